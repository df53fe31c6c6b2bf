// How libFuzzer changes a PNG: as any bytes, and every other time with checksums that are right again. libpng drops a
// chunk whose checksum is wrong, so hardly any other change would get past it.

#include <algorithm>

#include <zlib.h>

#include "fuzz.h"
#include "mirrorball/codec/byte_order.h"

namespace {

/// Makes the checksum of each chunk right. The last one ends with the data, whatever length it says.
void mendChecksums(std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kFrame = 12;  // a chunk's length, its type, and its checksum behind the data
  for (std::size_t at = kSignature; at + kFrame <= size;) {
    const std::size_t length = std::min<std::size_t>(mirrorball::bigU32(data + at), size - at - kFrame);
    const auto sum = static_cast<std::uint32_t>(crc32(0, data + at + 4, static_cast<uInt>(4 + length)));
    std::uint8_t* checksum = data + at + 8 + length;
    for (int byte = 0; byte < 4; ++byte) checksum[byte] = static_cast<std::uint8_t>(sum >> (24 - 8 * byte));
    at += kFrame + length;
  }
}

}  // namespace

/// libFuzzer's own changes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  const std::size_t changed = LLVMFuzzerMutate(data, size, max);
  if (seed % 2 == 0) mendChecksums(data, changed);
  return changed;
}
