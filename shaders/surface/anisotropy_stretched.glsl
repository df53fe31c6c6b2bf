// Part "anisotropy" (anisotropy_none.glsl). Here: along the mesh's tangent, turned by the material and its map
// (KHR_materials_anisotropy).
#include "brdf_look_up.glsl"
#include "ggx.glsl"
#include "stretched_lobe.glsl"
#include "tangent.glsl"

void stretchRoughness(inout Surface s, SurfacePoint point) {
  vec3 map = anisotropy_map_at(point).xyz;
  s.material.anisotropy *= map.z;
  vec2 turn = anisotropyTurn(map.xy * 2.0 - 1.0, s.material.anisotropy_rotation);
  if (!seesFront()) turn.y = -turn.y;  // from behind, the normal is turned round
  s.tangent = turnedTangent(point.tangent, s.normal, turn);
  vec2 alpha = stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy);
  vec3 v = eyeInFrame(s, point.ray);
  float mean_roughness = sqrt(0.5 * (alpha.x + alpha.y));
  s.environment_brdf.yz = environmentBrdf(brdf_table, mean_roughness, v.z).yz;
  s.stretched_share = stretchedShare(alpha, v);
}
