#include "mirrorball/scene/mesh_file/obj.h"

#include "fuzz.h"

MIRRORBALL_HARNESS(obj) {
  mirrorball::fuzz::checkError(mirrorball::decodeObj({data, size}, "a.obj"));
  return 0;
}
