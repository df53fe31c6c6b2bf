#include "mirrorball/scene/stl.h"

#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeStl({data, size}, "a.stl"), "a.stl");
  return 0;
}
