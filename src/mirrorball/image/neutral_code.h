#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Which channels of an image of signed numbers are 0 where nothing is shown, and which is greatest there.
struct NeutralChannels {
  std::size_t first;
  std::size_t second;
  int greatest = -1;  ///< −1: none
};

/// Whether the most frequent texel of an image of codes is 128 in two channels: programs write that for a number of 0,
/// though 127.5 is the middle of 8 bits. Two channels are counted, and of those texels with the third at its greatest.
///
/// image    at least 3 channels; floats are fractions of the greatest code
/// cost     about 1 ns a texel of 8 bits, 5 ns of floats
template <typename Sample>
bool isNeutralAt128(const ImageOf<Sample>& image, NeutralChannels channels) {
  constexpr bool kHasFloats = std::is_floating_point_v<Sample>;
  constexpr Sample kGreatest = kHasFloats ? Sample(1) : std::numeric_limits<Sample>::max();
  constexpr auto kNeutral = static_cast<Sample>(kHasFloats ? 128.0f / 255.0f : 128.0f);
  const auto codeOf = [](Sample sample) -> std::size_t {
    if constexpr (kHasFloats)
      return static_cast<std::size_t>(std::lround(sample > 0.0f ? 255.0f * std::min(sample, 1.0f) : 0.0f));
    return static_cast<std::size_t>(sample);
  };
  std::vector<std::uint32_t> counts(std::size_t{256} * 256, 0u);
  std::uint32_t neutral = 0;
  const std::span<const Sample> samples = image.samples();
  for (std::size_t i = 0; i < samples.size(); i += std::size_t(image.channels())) {
    const Sample a = samples[i + channels.first], b = samples[i + channels.second];
    const bool is_greatest = channels.greatest < 0 || samples[i + std::size_t(channels.greatest)] == kGreatest;
    if (a == kNeutral && b == kNeutral && is_greatest)
      ++neutral;
    else
      ++counts[256 * codeOf(a) + codeOf(b)];
  }
  return neutral > 0 && *std::max_element(counts.begin(), counts.end()) <= neutral;
}

}  // namespace mirrorball
