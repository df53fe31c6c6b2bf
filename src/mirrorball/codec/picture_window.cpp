#include "mirrorball/codec/picture_window.h"

#include "mirrorball/base/size_text.h"

namespace mirrorball {
namespace {

/// The most texels of a larger picture that one byte of a real file stands for: 8 × 8 texels of 4096 × 2048 have 17 000
/// a byte. More than this is a lie that would only cost memory.
constexpr std::uint64_t kMaxTexelsPerByteOfWhole = 1 << 15;

bool coversWhole(const PictureWindow& window) {
  const glm::ivec2 end = window.corner + window.size;
  return window.corner.x <= 0 && window.corner.y <= 0 && end.x >= window.whole.x && end.y >= window.whole.y;
}

bool reachesBeyond(const PictureWindow& window) {
  const glm::ivec2 end = window.corner + window.size;
  return window.corner.x < 0 || window.corner.y < 0 || end.x > window.whole.x || end.y > window.whole.y;
}

}  // namespace

Result<void> checkWholePicture(long long width, long long height, const std::string& source, std::uint64_t file_size) {
  MIRRORBALL_TRY_VOID(withName(source, checkDimensions(width, height)));
  if (std::uint64_t(width * height) / kMaxTexelsPerByteOfWhole > file_size)
    return fail(ErrorCode::bad_file, "says " + source + " is " + std::to_string(width) + "x" + std::to_string(height) +
                                         ", for which a file of " + std::to_string(file_size) +
                                         " bytes is too small; it is damaged");
  return {};
}

std::string windowText(const PictureWindow& window) {
  const std::string size = sizeText(window.size), whole = sizeText(window.whole);
  if (!reachesBeyond(window))
    return "holds " + size + " of the " + whole + " texels of " + window.source + ": what lies outside is black";
  return "holds " + size + " texels, beyond " + window.source + " of " + whole + ": what lies outside is cut off" +
         (coversWhole(window) ? "" : ", and what it lacks is black");
}

std::string noTexelText(const std::string& source) {
  return "has no texel in " + source + ": read without that window";
}

}  // namespace mirrorball
