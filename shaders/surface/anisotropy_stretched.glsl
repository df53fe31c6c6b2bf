// Part "anisotropy" (anisotropy_none.glsl). Here: along the mesh's tangent, turned by the material and its map
// (KHR_materials_anisotropy).
#include "brdf_look_up.glsl"
#include "ggx.glsl"
#include "stretched_lobe.glsl"
#include "tangent.glsl"

void stretchRoughness(inout Surface s, SurfacePoint point) {
  vec3 map = anisotropy_map_at(point).xyz;
  s.material.anisotropy *= map.z;
  s.tangent = turnedTangent(point.tangent, s.normal,
                            anisotropyTurn(map.xy * 2.0 - 1.0, s.material.anisotropy_rotation));
  vec2 alpha = stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy);
  s.environment_brdf =
      environmentBrdf(brdf_table, sqrt(roundAlpha(alpha)), clamp(-dot(point.ray, s.normal), 0.0, 1.0));
}
