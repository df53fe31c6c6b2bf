#include "mirrorball/codec/half_blocks/half_rows.h"

#include <algorithm>

#include "mirrorball/image/small_float.h"

namespace mirrorball {

bool fitsUnsignedHalf(std::span<const float> samples, int channels) {
  bool all_fit = true;
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t texel = 0; texel < samples.size(); texel += step)
    for (std::size_t c = 0; c < std::min<std::size_t>(step, 3); ++c)
      all_fit &= samples[texel + c] >= 0.0f && samples[texel + c] <= kLargestHalf;
  return all_fit;
}

HalfRows::HalfRows(std::size_t channels, std::size_t width)
    : channels_(channels),
      width_(width),
      padded_width_((width + kColumns - 1) / kColumns * kColumns),
      halves_(4 * 3 * padded_width_) {}

void HalfRows::fill(std::span<const float> samples) {
  const std::size_t row = channels_ * width_;
  for (std::size_t y = 0; y < 4; ++y) {
    const std::size_t from = std::min(y, samples.size() / row - 1);
    fillRow(samples.subspan(from * row, row), std::span(halves_).subspan(y * 3 * padded_width_, 3 * padded_width_));
  }
}

void HalfRows::gather(std::size_t first, HalfBlockTexels& texels) const {
  for (std::size_t y = 0; y < 4; ++y) {
    const std::uint16_t* from = halves_.data() + 3 * (y * padded_width_ + 4 * first);
    for (std::size_t block = 0; block < kHalfBlockBatch; ++block, from += 12)
      for (std::size_t i = 0; i < 12; ++i) texels.halves[12 * y + i][block] = from[i];
  }
}

void HalfRows::fillRow(std::span<const float> samples, std::span<std::uint16_t> halves) {
  const std::span<std::uint16_t> there = halves.first(3 * width_);
  if (channels_ == 3) {
    halvesFromFloats(samples, there);
  } else {
    colors_.resize(3 * width_);
    for (std::size_t x = 0; x < width_; ++x)
      for (std::size_t c = 0; c < 3; ++c) colors_[3 * x + c] = samples[x * channels_ + (channels_ == 1 ? 0 : c)];
    halvesFromFloats(colors_, there);
  }
  // −0 is 0.
  for (std::uint16_t& half : there) half = static_cast<std::uint16_t>(half & 0x7fffu);
  for (std::size_t i = 3 * width_; i < halves.size(); ++i) halves[i] = halves[i - 3];
}

void placeHalfBlock(std::span<const std::uint16_t, 48> halves, int x, int y, Image& image) {
  std::array<float, 48> light;
  floatsFromHalves(halves, light);
  const int columns = std::min(4, image.width() - x);
  for (int row = 0; row < std::min(4, image.height() - y); ++row)
    std::copy_n(light.data() + 12 * row, 3 * columns, image.texel(x, y + row));
}

}  // namespace mirrorball
