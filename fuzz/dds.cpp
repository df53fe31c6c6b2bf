#include "fuzz.h"
#include "mirrorball/codec/texture_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}, "a.dds"), "a.dds");
  return 0;
}
