#include "mirrorball/scene/gltf/gltf.h"

#include "fuzz.h"

MIRRORBALL_HARNESS(gltf) {
  mirrorball::fuzz::checkError(mirrorball::decodeGltf({data, size}, "a.gltf"));
  return 0;
}
