#include "fuzz.h"
#include "mirrorball/codec/codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeImage({data, size}, "a.hdr"), "a.hdr");
  return 0;
}
