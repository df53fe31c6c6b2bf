#include "mirrorball/scene/mesh_file/ply.h"

#include "fuzz.h"

MIRRORBALL_HARNESS(ply) {
  mirrorball::fuzz::checkError(mirrorball::decodePly({data, size}));
  return 0;
}
