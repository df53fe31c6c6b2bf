// Part "anisotropy": which way the roughness is stretched.
//   void stretchRoughness(inout Surface s, SurfacePoint point)   sets its tangent, from what else is known of it
// Here: none.
#include "tangent.glsl"

void stretchRoughness(inout Surface s, SurfacePoint point) {
  s.material.anisotropy = 0.0;
  s.tangent = anyTangent(s.normal);
  s.stretched_share = 1.0;
}
