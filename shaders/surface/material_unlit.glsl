// Part "material" (material_core.glsl). Here: a surface that answers to no light.
#include "base_color.glsl"

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  Surface s;
  s.material = unlitMaterial(material, base_color);
  s.normal = n;
  s.occlusion = 1.0;
  s.environment_brdf = vec2(0.0);
  stretchRoughness(s, point);
  layCloth(s, point);
  return s;
}
