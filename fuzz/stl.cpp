#include "mirrorball/scene/mesh_file/stl.h"

#include "fuzz.h"

MIRRORBALL_HARNESS(stl) {
  mirrorball::fuzz::checkError(mirrorball::decodeStl({data, size}));
  return 0;
}
