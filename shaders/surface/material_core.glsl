// Part "material": what the surface is made of at a point.
//   vec4 colorAt(SurfacePoint point)                                base colour and opacity
//   Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color)  n on the viewer's side
// Here: glTF's core, and the textures of its extensions.
#include "base_color.glsl"
#include "brdf_look_up.glsl"
#include "known_numbers.glsl"

Surface surfaceAt(SurfacePoint point, vec3 n, vec3 base_color) {
  Surface s;
  s.material = atWavelength(withKnownNumbers(material), only_wavelength);
  s.material.base_color = base_color;
  s.own_roughness = s.material.perceptual_roughness * roughness_map_at(point).y;
  s.material.perceptual_roughness = widenedRoughness(s.own_roughness, hiddenSlopes(point) + hiddenDetail(point));
  s.material.metallic *= metallic_map_at(point).z;
  s.material.specular *= specular_map_at(point).w;
  s.material.specular_color *= specular_color_map_at(point).xyz;
  s.material.transmission *= transmission_map_at(point).x;
  s.material.emission *= emission_map_at(point).xyz;
  s.material.iridescence *= iridescence_map_at(point).x;
  s.material.iridescence_thickness = mix(material.iridescence_thickness_minimum, material.iridescence_thickness,
                                         iridescence_thickness_map_at(point).y);
  s.normal = n;
  s.occlusion = 1.0 + material.occlusion_strength * (occlusion_map_at(point).x - 1.0);
  s.environment_brdf =
      environmentBrdf(brdf_table, s.material.perceptual_roughness, clamp(-dot(point.ray, n), 0.0, 1.0));
  stretchRoughness(s, point);
  layCloth(s, point);
  return s;
}
