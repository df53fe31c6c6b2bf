#include "mirrorball/codec/exr/exr_window.h"

#include <ImfStandardAttributes.h>

#include "mirrorball/image/image.h"

namespace mirrorball {
namespace {

/// The most texels of a display window that one byte of a real file stands for: 8 × 8 texels of 4096 × 2048 have 17 000
/// a byte. More than this is a lie that would only cost memory.
constexpr std::uint64_t kMaxTexelsPerByteOfWindow = 1 << 15;

glm::ivec2 extent(const Imath::Box2i& window) {
  return {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
}

std::string sizeText(const Imath::Box2i& window) {
  const glm::ivec2 size = extent(window);
  return std::to_string(size.x) + "x" + std::to_string(size.y);
}

bool contains(const Imath::Box2i& outer, const Imath::Box2i& inner) {
  return outer.intersects(inner.min) && outer.intersects(inner.max);
}

/// errors   bad_file; too_large
Result<void> checkDisplayWindow(const Imath::Box2i& window, std::uint64_t file_size) {
  const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
  const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
  MIRRORBALL_TRY_VOID(withName("its display window", checkDimensions(width, height)));
  if (std::uint64_t(width * height) / kMaxTexelsPerByteOfWindow > file_size)
    return fail(ErrorCode::bad_file, "says its display window is " + std::to_string(width) + "x" +
                                         std::to_string(height) + ", for which a file of " + std::to_string(file_size) +
                                         " bytes is too small; it is damaged");
  return {};
}

std::string describe(const ExrWindow& window) {
  const std::string whole = sizeText(window.picture);
  if (contains(window.picture, window.data))
    return "holds " + sizeText(window.data) + " of the " + whole +
           " texels of its display window: what lies outside is black";
  const std::string beyond = "holds " + sizeText(window.data) + " texels, beyond its display window of " + whole;
  return beyond + (window.isFull() ? ": what lies outside is cut off"
                                   : ": what lies outside is cut off, and what it lacks is black");
}

}  // namespace

bool ExrWindow::isFull() const { return contains(data, picture); }

Result<ExrWindow> exrWindow(const Imf::Header& header, std::uint64_t file_size) {
  const Imath::Box2i& data = header.dataWindow();
  const Imath::Box2i& display = header.displayWindow();
  if (display == data || Imf::hasEnvmap(header)) return ExrWindow{data, data};
  if (!display.intersects(data)) {
    ExrWindow window{data, data};
    window.oddity = "has no texel in its display window: read without that window";
    return window;
  }
  MIRRORBALL_TRY_VOID(checkDisplayWindow(display, file_size));
  ExrWindow window{display, data};
  window.part = PictureWindow{.whole = extent(display),
                              .corner = {data.min.x - display.min.x, data.min.y - display.min.y},
                              .source = "its display window",
                              .size = extent(data)};
  window.oddity = describe(window);
  return window;
}

}  // namespace mirrorball
