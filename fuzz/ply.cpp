#include "mirrorball/scene/ply.h"

#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodePly({data, size}, "a.ply"), "a.ply");
  return 0;
}
