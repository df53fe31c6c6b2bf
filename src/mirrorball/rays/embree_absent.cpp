#include "mirrorball/base/left_out.h"
#include "mirrorball/rays/ray_tree.h"

namespace mirrorball {

RayTracer fastestRayTracer() { return RayTracer::own; }

Result<std::unique_ptr<RayTree>> embreeTree(const Scene&, const PrismsOfInstances&) {
  return leftOut("has no Embree", "MIRRORBALL_EMBREE");
}

}  // namespace mirrorball
