#pragma once

#include <cstdint>

#include "mirrorball/base/result.h"
#include "mirrorball/base/text.h"

namespace mirrorball {

/// Why a file of points cannot be drawn, and what helps.
inline tl::unexpected<Error> pointsAlone(std::uint64_t points) {
  return fail(ErrorCode::unsupported, "holds no faces, but " + counted(points, "point") +
                                          "; only surfaces can be drawn: make one of them in MeshLab (Screened "
                                          "Poisson) or CloudCompare");
}

}  // namespace mirrorball
