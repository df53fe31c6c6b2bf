#include "mirrorball/codec/bc6h/bc6h.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "mirrorball/codec/bc6h/bc6h_block.h"
#include "mirrorball/codec/bc6h/bc6h_search.h"
#include "mirrorball/image/small_float.h"

namespace mirrorball {
namespace {

/// A row of blocks as half floats, red, green and blue: four rows of texels, and as many columns as whole batches have.
/// What is not there repeats its neighbours.
class HalfRows {
 public:
  HalfRows(std::size_t channels, std::size_t width)
      : channels_(channels),
        width_(width),
        padded_width_((width + kColumns - 1) / kColumns * kColumns),
        halves_(4 * 3 * padded_width_) {}

  /// samples  of at least one row, of which the first four are taken
  void fill(std::span<const float> samples) {
    const std::size_t row = channels_ * width_;
    for (std::size_t y = 0; y < 4; ++y) {
      const std::size_t from = std::min(y, samples.size() / row - 1);
      fillRow(samples.subspan(from * row, row), std::span(halves_).subspan(y * 3 * padded_width_, 3 * padded_width_));
    }
  }

  /// The batch of blocks from block `first` on.
  void gather(std::size_t first, Bc6hTexels& texels) const {
    for (std::size_t y = 0; y < 4; ++y) {
      const std::uint16_t* from = halves_.data() + 3 * (y * padded_width_ + 4 * first);
      for (std::size_t block = 0; block < kBc6hBatch; ++block, from += 12)
        for (std::size_t i = 0; i < 12; ++i) texels.halves[12 * y + i][block] = from[i];
    }
  }

 private:
  static constexpr std::size_t kColumns = 4 * kBc6hBatch;

  void fillRow(std::span<const float> samples, std::span<std::uint16_t> halves) {
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

  std::size_t channels_;
  std::size_t width_;
  std::size_t padded_width_;
  std::vector<std::uint16_t> halves_;
  std::vector<float> colors_;  // of a row, where samples are not
};

Bc6hBlock blockOf(const Bc6hFound& found, std::size_t lane) {
  Bc6hBlock block;
  block.mode = static_cast<int>(found.modes[lane]);
  block.partition = static_cast<int>(found.partitions[lane]);
  for (std::size_t e = 0; e < block.endpoints.size(); ++e)
    block.endpoints[e] = static_cast<int>(found.endpoints[e][lane]);
  for (std::size_t i = 0; i < block.indices.size(); ++i)
    block.indices[i] = static_cast<std::uint8_t>(found.indices[i][lane]);
  return block;
}

}  // namespace

bool fitsBc6h(std::span<const float> samples, int channels) {
  bool all_fit = true;
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t texel = 0; texel < samples.size(); texel += step)
    for (std::size_t c = 0; c < std::min<std::size_t>(step, 3); ++c)
      all_fit &= samples[texel + c] >= 0.0f && samples[texel + c] <= kLargestBc6h;
  return all_fit;
}

bool encodeBc6h(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes) {
  assert(channels != 2 && samples.size() % (std::size_t(channels) * std::size_t(width)) == 0);
  if (!fitsBc6h(samples, channels)) return false;
  const std::size_t row = std::size_t(channels) * std::size_t(width);
  const std::size_t blocks = (std::size_t(width) + 3) / 4;
  HalfRows rows{std::size_t(channels), std::size_t(width)};
  Bc6hTexels texels;
  Bc6hFound found;
  for (; !samples.empty(); samples = samples.subspan(std::min(4 * row, samples.size()))) {
    rows.fill(samples);
    for (std::size_t first = 0; first < blocks; first += kBc6hBatch) {
      rows.gather(first, texels);
      searchBc6h(texels, found);
      for (std::size_t lane = 0; lane < std::min(kBc6hBatch, blocks - first); ++lane) {
        writeBc6hBlock(blockOf(found, lane), bytes.first<kBc6hBlockSize>());
        bytes = bytes.subspan(kBc6hBlockSize);
      }
    }
  }
  assert(bytes.empty());
  return true;
}

void decodeBc6hRow(const std::uint8_t* bytes, bool is_signed, int begin, Image& image) {
  std::array<std::uint16_t, 48> halves;
  std::array<float, 48> light;
  for (int x = 0; x < image.width(); x += 4, bytes += kBc6hBlockSize) {
    decodeBc6hBlock(std::span<const std::uint8_t, kBc6hBlockSize>(bytes, kBc6hBlockSize), is_signed, halves);
    floatsFromHalves(halves, light);
    const int columns = std::min(4, image.width() - x);
    for (int y = 0; y < std::min(4, image.height() - begin); ++y)
      std::copy_n(light.data() + 12 * y, 3 * columns, image.texel(x, begin + y));
  }
}

}  // namespace mirrorball
