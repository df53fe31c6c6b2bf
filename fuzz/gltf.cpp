#include "mirrorball/scene/gltf/gltf.h"

#include "model.h"

MIRRORBALL_HARNESS(gltf) {
  mirrorball::fuzz::checkModel(mirrorball::decodeGltf({data, size}, "a.gltf"));
  return 0;
}
