#pragma once

#include <cstddef>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// A mesh whose triangles lie side by side in a texture.
struct Unwrapped {
  Mesh mesh;  ///< with uv[0] and tangents; vertices between charts are split
  std::size_t charts = 0;
  double stretch = 1.0;  ///< root mean square of how much a step in the texture is on the surface, over that of a map
                         ///< without stretch; 1 is the least
  double worst_stretch = 1.0;  ///< the greatest of a direction anywhere
  double used = 0.0;           ///< share of the texture that triangles cover
};

/// Spreads a surface out for a square map: cut into charts, each seen from its front, packed at one scale.
///
/// size     of the map that will be used, in texels; at least 1
/// gutter   texels between charts, so that filtering does not mix them; 0 or more
/// errors   out_of_range: the charts do not fit into so small a map
/// cost     5,000 triangles at 1024²: 0.1 s
/// from     Sander, Snyder, Gortler & Hoppe 2001, "Texture mapping progressive meshes", for the measure (L²)
Result<Unwrapped> unwrapped(const Mesh& mesh, int size, int gutter);

}  // namespace mirrorball
