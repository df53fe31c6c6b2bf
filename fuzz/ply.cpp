#include "mirrorball/scene/mesh_file/ply.h"

#include "model.h"

MIRRORBALL_HARNESS(ply) {
  mirrorball::fuzz::checkModel(mirrorball::decodePly({data, size}, "a.ply"));
  return 0;
}
