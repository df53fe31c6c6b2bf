#include "mirrorball/codec/bc6h/bc6h.h"

#include <array>
#include <cassert>

#include "mirrorball/codec/bc6h/bc6h_block.h"
#include "mirrorball/codec/bc6h/bc6h_search.h"
#include "mirrorball/codec/half_blocks/half_rows.h"

namespace mirrorball {
namespace {

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

bool encodeBc6h(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes) {
  assert(channels != 2 && samples.size() % (std::size_t(channels) * std::size_t(width)) == 0);
  if (!fitsUnsignedHalf(samples, channels)) return false;
  Bc6hFound found;
  forEachHalfBlockBatch(samples, channels, width, bytes,
                        [&](const HalfBlockTexels& texels, std::size_t count, std::span<std::uint8_t> blocks) {
                          searchBc6h(texels, found);
                          for (std::size_t lane = 0; lane < count; ++lane)
                            writeBc6hBlock(blockOf(found, lane),
                                           blocks.subspan(lane * kBc6hBlockSize).first<kBc6hBlockSize>());
                        });
  return true;
}

void decodeBc6hRow(const std::uint8_t* bytes, bool is_signed, int begin, Image& image) {
  std::array<std::uint16_t, 48> halves;
  for (int x = 0; x < image.width(); x += 4, bytes += kBc6hBlockSize) {
    decodeBc6hBlock(std::span<const std::uint8_t, kBc6hBlockSize>(bytes, kBc6hBlockSize), is_signed, halves);
    placeHalfBlock(halves, x, begin, image);
  }
}

}  // namespace mirrorball
