// Part "material" (material_core.glsl). Here: a surface that answers to no light.
#include "bare_surface.glsl"
#include "base_color.glsl"

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  return bareSurface(point, unlitMaterial(material, base_color), n);
}
