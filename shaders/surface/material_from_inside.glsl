// Part "material" (material_core.glsl). Here: a surface of a body that is seen from inside of bodies, where all of its
// light, also what it reflects, is that of the traced ray from the eye.
#include "base_color.glsl"

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  Surface s;
  s.material = openMaterial(material);
  s.normal = n;
  s.occlusion = 1.0;
  s.environment_brdf = vec2(0.0);
  stretchRoughness(s, point);
  layCloth(s, point);
  return s;
}
