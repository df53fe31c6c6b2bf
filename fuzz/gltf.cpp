#include "mirrorball/scene/gltf.h"

#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirrorball::fuzz::checkError(mirrorball::decodeGltf({data, size}, "a.gltf"), "a.gltf");
  return 0;
}
