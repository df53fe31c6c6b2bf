// A surface lit by its environment. #defines choose what the material needs; see render/surface_program.cpp.
#include "constants.glsl"
#include "color.glsl"
#include "grid_random.glsl"
#include "height.glsl"
#include "microfacet.glsl"
#include "mip_mapping.glsl"
#include "optics.glsl"
#include "reflection_lobe.glsl"
#include "sampling.glsl"
#include "sphere_map.glsl"
#include "tangent.glsl"
#include "brdf_table.glsl"
#include "blur.glsl"
#include "shading.glsl"

in vec3 object_position;
in vec3 object_normal;
in vec3 world_position;
in vec3 world_normal;
in vec4 world_tangent;
in vec2 texture_uv_0;
in vec2 texture_uv_1;
in vec4 vertex_color;
in vec3 vertex_reflection;

uniform vec3 camera_position;
uniform vec3 camera_forward;
uniform float orthographic;
uniform mat3 normal_matrix;

uniform samplerCube environment;
uniform mat3 environment_from_world;
uniform float environment_intensity;
uniform samplerCube prefiltered;
uniform samplerCube irradiance;  // divided by π
uniform int blur_kind;
uniform float first_level;
uniform float last_level;
uniform float coarser;
uniform float texels_per_radian;
uniform float samples_per_pixel;
uniform sampler2D brdf_table;
#ifdef SPHERE_MAPPING
uniform sampler2D sphere_map;
uniform mat4 texture_matrix;
#endif

uniform vec4 base_color;
uniform float metallic;
uniform float perceptual_roughness;
uniform float specular;
uniform float ior;
uniform float dispersion;
uniform float transmission;
uniform vec3 conductor_n;
uniform vec3 conductor_k;
uniform vec3 emission;
uniform int fresnel;
uniform vec3 fresnel_empirical;
uniform float bump_height;
uniform float bump_frequency;
uniform float alpha_cutoff;

// Of each texture slot: columns of a 2 × 2 matrix, offset, and which set of texture coordinates.
#ifdef BASE_COLOR_TEXTURE
uniform sampler2D base_color_texture;
uniform vec4 base_color_uv_matrix;
uniform vec3 base_color_uv_offset;
#endif
#ifdef METALLIC_ROUGHNESS_TEXTURE
uniform sampler2D metallic_roughness_texture;
uniform vec4 metallic_roughness_uv_matrix;
uniform vec3 metallic_roughness_uv_offset;
#endif
#ifdef NORMAL_TEXTURE
uniform sampler2D normal_texture;
uniform vec4 normal_uv_matrix;
uniform vec3 normal_uv_offset;
uniform float normal_scale;
#endif
#ifdef OCCLUSION_TEXTURE
uniform sampler2D occlusion_texture;
uniform vec4 occlusion_uv_matrix;
uniform vec3 occlusion_uv_offset;
uniform float occlusion_strength;
#endif
#ifdef EMISSION_TEXTURE
uniform sampler2D emission_texture;
uniform vec4 emission_uv_matrix;
uniform vec3 emission_uv_offset;
#endif

#ifdef LIGHTS
uniform vec3 light_position[LIGHTS];
uniform vec3 light_color[LIGHTS];
#endif

out vec4 fragment;

vec2 transformedUv(vec4 matrix, vec3 offset) {
  vec2 uv = offset.z > 0.5 ? texture_uv_1 : texture_uv_0;
  return mat2(matrix.xy, matrix.zw) * uv + offset.xy;
}

vec3 shadingNormal() {
#ifdef BUMP
  // The height is a function of the place, so any frame will do for its two slopes.
  vec3 smooth_normal = normalize(object_normal);
  vec3 p_u = anyTangent(smooth_normal);
  vec3 p_v = cross(smooth_normal, p_u);
  vec3 slope = orangeHeight(object_position * bump_frequency).xyz * (bump_height * bump_frequency);
  vec3 n = normalize(normal_matrix * perturbedNormal(p_u, p_v, smooth_normal, dot(slope, p_u), dot(slope, p_v)));
#else
  vec3 n = normalize(world_normal);
#endif
#ifdef NORMAL_TEXTURE
  vec3 t = normalize(world_tangent.xyz - n * dot(n, world_tangent.xyz));
  vec3 b = cross(n, t) * world_tangent.w;
  vec3 encoded = texture(normal_texture, transformedUv(normal_uv_matrix, normal_uv_offset)).xyz;
  n = normalFromMap(t, b, n, encoded, normal_scale);
#endif
  return gl_FrontFacing ? n : -n;
}

Surface surfaceHere(vec3 n, vec3 color) {
  Surface s;
  s.normal = n;
  s.base_color = color;
  s.metallic = metallic;
  s.perceptual_roughness = perceptual_roughness;
  s.specular = specular;
  s.ior = ior;
  s.dispersion = dispersion;
  s.transmission = transmission;
  s.conductor_n = conductor_n;
  s.conductor_k = conductor_k;
  s.occlusion = 1.0;
  s.emission = emission;
  s.fresnel = fresnel;
  s.fresnel_empirical = fresnel_empirical;
#ifdef METALLIC_ROUGHNESS_TEXTURE
  vec4 mr = texture(metallic_roughness_texture, transformedUv(metallic_roughness_uv_matrix, metallic_roughness_uv_offset));
  s.perceptual_roughness *= mr.y;
  s.metallic *= mr.z;
#endif
#ifdef OCCLUSION_TEXTURE
  float occluded = texture(occlusion_texture, transformedUv(occlusion_uv_matrix, occlusion_uv_offset)).x;
  s.occlusion = 1.0 + occlusion_strength * (occluded - 1.0);
#endif
#ifdef EMISSION_TEXTURE
  s.emission *= texture(emission_texture, transformedUv(emission_uv_matrix, emission_uv_offset)).xyz;
#endif
  return s;
}

Blur blurHere() { return Blur(blur_kind, first_level, last_level, texels_per_radian, coarser); }

vec3 reflectedLight(Surface s, vec3 ray) {
#ifdef SPHERE_MAPPING
  vec4 st = texture_matrix * vec4(s.normal, 1.0);
  return textureLod(sphere_map, st.xy, 0.0).xyz;
#else
#if defined(NORMAL_MAPPING)
  vec3 d = s.normal;
#elif defined(REFLECT_AT_VERTEX)
  vec3 d = normalize(vertex_reflection);
#else
  vec3 d = reflect(ray, s.normal);
#endif
  float minified = footprintLod(dFdx(d), dFdy(d), texels_per_radian, samples_per_pixel);
  return blurredLight(blurHere(), environment, prefiltered, environment_from_world * d, s.perceptual_roughness, minified)
      .xyz;
#endif
}

vec2 environmentBrdf(Surface s, vec3 ray) {
  float cosine = clamp(-dot(ray, s.normal), 0.0, 1.0);
  float size = float(textureSize(brdf_table, 0).x);
  return textureLod(brdf_table, brdfTableCoordinates(s.perceptual_roughness, cosine, size), 0.0).xy;
}

void main() {
  vec4 color = base_color * vertex_color;
#ifdef BASE_COLOR_TEXTURE
  color *= texture(base_color_texture, transformedUv(base_color_uv_matrix, base_color_uv_offset));
#endif
#ifdef ALPHA_MASK
  if (color.w < alpha_cutoff) discard;
#endif
  vec3 ray = orthographic > 0.5 ? camera_forward : normalize(world_position - camera_position);
  Surface s = surfaceHere(shadingNormal(), color.xyz);
  s.environment_brdf = environmentBrdf(s, ray);

  vec3 reflected = reflectedLight(s, ray) * environment_intensity;
  vec3 refracted = vec3(0.0);
#ifdef TRANSMISSION
  refracted = refractedLight(s, ray, environment_from_world, blurHere(), environment, prefiltered) * environment_intensity;
#endif
  vec3 diffuse = sampleLod(irradiance, environment_from_world * s.normal, 0.0).xyz * environment_intensity;
  vec3 light = shadedByEnvironment(s, ray, reflected, refracted, diffuse);
#ifdef LIGHTS
  for (int i = 0; i < LIGHTS; ++i)
    light += shadedByPointLight(s, ray, normalize(light_position[i] - world_position), light_color[i]);
#endif
#ifdef ALPHA_BLEND
  fragment = vec4(light * color.w, color.w);
#else
  fragment = vec4(light, 1.0);
#endif
}
