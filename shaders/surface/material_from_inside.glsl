// Part "material" (material_core.glsl). Here: a surface of a body that is seen from inside of bodies, where all of its
// light, also what it reflects, is that of the traced ray from the eye.
#include "bare_surface.glsl"
#include "base_color.glsl"

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  return bareSurface(point, openMaterial(material), n);
}
