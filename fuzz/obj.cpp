#include "mirrorball/scene/obj.h"

#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeObj({data, size}, "a.obj"), "a.obj");
  return 0;
}
