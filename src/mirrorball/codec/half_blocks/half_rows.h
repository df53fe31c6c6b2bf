#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mirrorball/codec/half_blocks/block_bits.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The largest half float: what blocks of unsigned half floats hold at most.
inline constexpr float kLargestHalf = 65504.0f;

/// So many blocks are encoded together, one in each lane of a vector or of a few.
inline constexpr std::size_t kHalfBlockBatch = 16;

/// The texels of a batch of blocks: the bits of half floats from 0 to 65504, [3 · texel + channel][block].
struct HalfBlockTexels {
  alignas(64) std::array<std::array<std::uint16_t, kHalfBlockBatch>, 48> halves;
};

/// Whether all red, green and blue lies in [0, kLargestHalf]. NaN does not.
bool fitsUnsignedHalf(std::span<const float> samples, int channels);

/// A row of blocks as half floats, red, green and blue: four rows of texels, and as many columns as whole batches have.
/// What is not there repeats its neighbours.
class HalfRows {
 public:
  /// channels 1 (grey), 3 or 4 a texel; alpha is dropped
  HalfRows(std::size_t channels, std::size_t width);

  /// samples  of at least one row, of which the first four are taken
  void fill(std::span<const float> samples);

  /// The batch of blocks from block `first` on.
  void gather(std::size_t first, HalfBlockTexels& texels) const;

 private:
  static constexpr std::size_t kColumns = 4 * kHalfBlockBatch;

  void fillRow(std::span<const float> samples, std::span<std::uint16_t> halves);

  std::size_t channels_;
  std::size_t width_;
  std::size_t padded_width_;
  std::vector<std::uint16_t> halves_;
  std::vector<float> colors_ = {};  // of a row, where samples are not
};

/// Calls `encode(texels, count, bytes)` for batches of blocks by rows: `count` of them are there, and `bytes` are
/// theirs, 16 each.
///
/// samples  as encodeBc6h's
template <typename Encode>
void forEachHalfBlockBatch(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes,
                           const Encode& encode) {
  const std::size_t row = std::size_t(channels) * std::size_t(width);
  const std::size_t blocks = (std::size_t(width) + 3) / 4;
  HalfRows rows{std::size_t(channels), std::size_t(width)};
  HalfBlockTexels texels;
  for (; !samples.empty(); samples = samples.subspan(std::min(4 * row, samples.size()))) {
    rows.fill(samples);
    for (std::size_t first = 0; first < blocks; first += kHalfBlockBatch) {
      rows.gather(first, texels);
      const std::size_t count = std::min(kHalfBlockBatch, blocks - first);
      encode(texels, count, bytes.first(count * kHalfBlockSize));
      bytes = bytes.subspan(count * kHalfBlockSize);
    }
  }
}

/// Puts the texels of a block into an image; those beyond its edges are dropped.
///
/// halves   red, green and blue of 16 texels, by rows from the top
/// x, y     where the first of them is
/// image    of 3 channels
void placeHalfBlock(std::span<const std::uint16_t, 48> halves, int x, int y, Image& image);

}  // namespace mirrorball
