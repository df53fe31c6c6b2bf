#include "mirrorball/scene/mesh_file/ply.h"

#include "fuzz.h"

MIRRORBALL_HARNESS(ply) {
  mirrorball::fuzz::checkError(mirrorball::decodePly({data, size}, "a.ply"), "a.ply");
  return 0;
}
