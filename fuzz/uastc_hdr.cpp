// Blocks of UASTC HDR as they are, and the same bytes as half floats that are encoded: what is read is finite light,
// and what is written is read.

#include "mirrorball/codec/uastc_hdr/uastc_hdr.h"

#include <algorithm>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"
#include "mirrorball/image/small_float.h"

namespace {

using namespace mirrorball;
using Halves = std::array<std::uint16_t, 48>;

void decodeBlock(HalfBlockBytes bytes) {
  Halves halves{};
  const bool is_read = decodeUastcHdrBlock(bytes, halves);
  const auto block = readUastcHdrBlock(bytes);
  fuzz::check(is_read == block.has_value(), "what is read can be decoded");
  if (!block) return;
  fuzz::check(*std::max_element(halves.begin(), halves.end()) < 0x7c00, "light is finite and not negative");
  std::array<std::uint8_t, kHalfBlockSize> again;
  writeUastcHdrBlock(*block, again);
  Halves of_again{};
  fuzz::check(decodeUastcHdrBlock(again, of_again) && of_again == halves, "what is read can be written");
}

void encodeTexels(const std::uint8_t* data, std::size_t size) {
  const int width = 1 + data[0] % 9;
  const std::size_t texels = size / 6 / std::size_t(width) * std::size_t(width);
  if (texels == 0) return;
  std::vector<float> samples(3 * texels);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = floatFromHalf(static_cast<std::uint16_t>((data[2 * i] | data[2 * i + 1] << 8) % 0x7c00));
  const int height = static_cast<int>(texels) / width;
  const std::size_t row = std::size_t((width + 3) / 4) * kHalfBlockSize;
  std::vector<std::uint8_t> bytes(row * std::size_t((height + 3) / 4));
  fuzz::check(encodeUastcHdr(samples, 3, width, bytes), "finite light is encoded");
  Image image(width, height, 3);
  for (int y = 0; y < height; y += 4)
    fuzz::check(decodeUastcHdrRow(bytes.data() + std::size_t(y / 4) * row, y, image) < 0, "what is written is read");
  for (const float sample : image.samples()) fuzz::check(sample >= 0.0f && sample <= 65504.0f, "light is finite");
}

}  // namespace

MIRRORBALL_HARNESS(uastc_hdr) {
  for (std::size_t at = 0; at + kHalfBlockSize <= size; at += kHalfBlockSize)
    decodeBlock(HalfBlockBytes(data + at, kHalfBlockSize));
  // Encoding takes much longer than decoding.
  if (size > 0 && data[0] % 16 == 0) encodeTexels(data, size);
  return 0;
}
