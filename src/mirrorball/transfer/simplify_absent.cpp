// A build without meshoptimizer.
#include "mirrorball/base/left_out.h"
#include "mirrorball/transfer/simplify.h"

namespace mirrorball {

Result<Simplified> simplified(const Scene&, std::size_t) {
  return leftOut("simplifies no meshes", "MIRRORBALL_MESHOPTIMIZER");
}

}  // namespace mirrorball
