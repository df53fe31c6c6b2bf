#include "mirrorball/codec/compressed_xmp.h"

#include "mirrorball/codec/format_registry.h"

namespace mirrorball {

std::string compressedXmp(std::span<const std::uint8_t> bytes) {
  const Result<const FormatCodec*> codec = FormatRegistry::ofThisBuild().codecFor(bytes);
  return codec && *codec && (*codec)->compressed_xmp ? (*codec)->compressed_xmp(bytes) : std::string();
}

}  // namespace mirrorball
