#include "mirrorball/scene/mesh_file/stl.h"

#include "model.h"

MIRRORBALL_HARNESS(stl) {
  mirrorball::fuzz::checkModel(mirrorball::decodeStl({data, size}, "a.stl"));
  return 0;
}
