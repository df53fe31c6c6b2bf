#include "mirrorball/environment/file/large_panorama.h"

#include <algorithm>
#include <cstdint>

#include "mirrorball/base/memory.h"

namespace mirrorball {

bool isLarge(const PanoramaRows& panorama) {
  constexpr std::uint64_t kLarge_bytes = std::uint64_t{512} << 20;
  const RowReader::Description& picture = panorama.rows->description();
  const std::uint64_t bytes =
      std::uint64_t(picture.width) * std::uint64_t(picture.height) * std::uint64_t(picture.channels) * sizeof(float);
  return bytes > std::min(kLarge_bytes, memoryLimit() / 2);
}

}  // namespace mirrorball
