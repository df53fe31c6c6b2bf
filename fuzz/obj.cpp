#include "mirrorball/scene/mesh_file/obj.h"

#include "model.h"

MIRRORBALL_HARNESS(obj) {
  mirrorball::fuzz::checkModel(mirrorball::decodeObj({data, size}, "a.obj"));
  return 0;
}
