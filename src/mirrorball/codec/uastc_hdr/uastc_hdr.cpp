#include "mirrorball/codec/uastc_hdr/uastc_hdr.h"

#include <array>
#include <cassert>

#include "mirrorball/codec/half_blocks/half_rows.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_search.h"

namespace mirrorball {

bool encodeUastcHdr(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes) {
  assert(channels != 2 && samples.size() % (std::size_t(channels) * std::size_t(width)) == 0);
  if (!fitsUnsignedHalf(samples, channels)) return false;
  std::array<UastcHdrBlock, kHalfBlockBatch> found;
  forEachHalfBlockBatch(samples, channels, width, bytes,
                        [&](const HalfBlockTexels& texels, std::size_t count, std::span<std::uint8_t> blocks) {
                          searchUastcHdr(texels, found);
                          for (std::size_t block = 0; block < count; ++block)
                            writeUastcHdrBlock(found[block],
                                               blocks.subspan(block * kHalfBlockSize).first<kHalfBlockSize>());
                        });
  return true;
}

int decodeUastcHdrRow(const std::uint8_t* bytes, int begin, Image& image) {
  std::array<std::uint16_t, 48> halves;
  for (int x = 0; x < image.width(); x += 4, bytes += kHalfBlockSize) {
    if (!decodeUastcHdrBlock(HalfBlockBytes(bytes, kHalfBlockSize), halves)) return x / 4;
    placeHalfBlock(halves, x, begin, image);
  }
  return -1;
}

}  // namespace mirrorball
