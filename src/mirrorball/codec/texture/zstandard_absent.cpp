// A build without Zstandard.
#include "mirrorball/base/left_out.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {

Result<void> checkZstandard() { return leftOut("knows no Zstandard", "MIRRORBALL_ZSTD"); }

Result<void> unpackZstandard(std::span<const std::uint8_t>, std::span<std::uint8_t>) { return checkZstandard(); }

Result<Bytes> packZstandard(std::span<const std::uint8_t>, int, const ProgressFunction&) {
  MIRRORBALL_TRY_VOID(checkZstandard());
  return Bytes();
}

}  // namespace mirrorball
