#include "fuzz.h"
#include "mirrorball/codec/codec.h"

/// Both ways to read it: to light, and to samples as stored.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeImage({data, size}, "a.png"), "a.png");
  mirrorball::fuzz::checkError(mirrorball::decodeTexture({data, size}, "a.png"), "a.png");
  return 0;
}
