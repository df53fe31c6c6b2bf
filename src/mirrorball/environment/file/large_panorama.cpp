#include "mirrorball/environment/file/large_panorama.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/environment/file/picture_content.h"

namespace mirrorball {
namespace {

bool isLarge(const RowReader::Description& picture) {
  constexpr std::uint64_t kLarge_bytes = std::uint64_t{512} << 20;
  const std::uint64_t bytes =
      std::uint64_t(picture.width) * std::uint64_t(picture.height) * std::uint64_t(picture.channels) * sizeof(float);
  return bytes > std::min(kLarge_bytes, memoryLimit() / 2);
}

/// Texels of some rows, evenly spread.
///
/// rows     of a picture of 2:1; begins at the first row again
Result<Image> coarsePicture(RowReader& rows) {
  constexpr int kMostRows = 128;
  const int full = rows.description().height;
  const int height = std::min(full, kMostRows);
  const auto spread = [&](int i) { return static_cast<int>((2LL * i + 1) * full / (2LL * height)); };
  Image coarse(2 * height, height, 3);
  for (int y = 0; y < height; ++y) {
    rows.goTo(spread(y));
    MIRRORBALL_TRY(row, rows.read(1));
    for (int x = 0; x < coarse.width(); ++x) {
      const glm::vec3 light = rgbAt(row, spread(x), 0);
      std::copy_n(&light.x, 3, coarse.texel(x, y));
    }
  }
  rows.goTo(0);
  return coarse;
}

}  // namespace

Result<std::optional<PanoramaRows>> openLargePanorama(const std::string& name_or_path,
                                                      const EnvironmentLoadOptions& options) {
  MIRRORBALL_TRY(panorama, openPanorama(name_or_path, options));
  if (!panorama || !isLarge(panorama->rows->description())) return std::nullopt;
  MIRRORBALL_TRY_VOID(panorama->rows->survey());
  if (panorama->recognition.is_by_shape) {
    MIRRORBALL_TRY(coarse, coarsePicture(*panorama->rows));
    MIRRORBALL_TRY(doubt, withName(name_or_path, settleByContent(coarse, panorama->recognition)));
    panorama->doubt = std::move(doubt);
  }
  return std::move(panorama);
}

}  // namespace mirrorball
