#include "mirrorball/codec/exr/exr_window.h"

#include <ImfStandardAttributes.h>

#include "mirrorball/codec/picture_window.h"

namespace mirrorball {
namespace {

glm::ivec2 extent(const Imath::Box2i& window) {
  return {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
}

constexpr const char* kDisplayWindow = "its display window";

}  // namespace

bool ExrWindow::isFull() const { return data.intersects(picture.min) && data.intersects(picture.max); }

Result<ExrWindow> exrWindow(const Imf::Header& header, std::uint64_t file_size) {
  const Imath::Box2i& data = header.dataWindow();
  const Imath::Box2i& display = header.displayWindow();
  if (display == data || Imf::hasEnvmap(header)) return ExrWindow{data, data};
  if (!display.intersects(data)) {
    ExrWindow window{data, data};
    window.oddity = noTexelText(kDisplayWindow);
    return window;
  }
  MIRRORBALL_TRY_VOID(checkWholePicture(static_cast<long long>(display.max.x) - display.min.x + 1,
                                        static_cast<long long>(display.max.y) - display.min.y + 1, kDisplayWindow,
                                        file_size));
  ExrWindow window{display, data};
  window.part = PictureWindow{.whole = extent(display),
                              .corner = {data.min.x - display.min.x, data.min.y - display.min.y},
                              .source = kDisplayWindow,
                              .size = extent(data)};
  window.oddity = windowText(*window.part);
  return window;
}

}  // namespace mirrorball
