// Part "material": what the surface is made of at a point.
//   vec4 colorAt(SurfacePoint point)                                base colour and opacity
//   Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color)  n on the viewer's side
// Here: glTF's core.
#include "brdf_table.glsl"

uniform sampler2D brdf_table;

vec4 colorAt(SurfacePoint point) {
  return vec4(material.base_color, material.opacity) * point.color * base_color_map_at(point);
}

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  Surface s;
  s.material = material;
  s.material.base_color = base_color;
  s.material.perceptual_roughness *= roughness_map_at(point).y;
  s.material.metallic *= metallic_map_at(point).z;
  s.material.emission *= emission_map_at(point).xyz;
  s.normal = n;
  s.occlusion = 1.0 + material.occlusion_strength * (occlusion_map_at(point).x - 1.0);
  float cosine = clamp(-dot(point.ray, n), 0.0, 1.0);
  float size = float(textureSize(brdf_table, 0).x);
  vec2 uv = brdfTableCoordinates(s.material.perceptual_roughness, cosine, size);
  s.environment_brdf = textureLod(brdf_table, uv, 0.0).xy;
  return s;
}
