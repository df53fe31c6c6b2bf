// The heights of a material (scene/relief/height_texture.h), over the first texture coordinates.
#include "height_sampler.glsl"

uniform highp sampler2D slopes;  // SlopeMoments of height_field/slope_moments.h

// From the deepest place to the highest: world. Where an instance is stretched it is not along the normal.
vec3 reliefUp(SurfacePoint point) {
  return abs(material.height_scale) * (mat3(world_from_object) * point.object_normal);
}

// The mean slope that a sample of a pixel sees, (∂h/∂u, ∂h/∂v) a unit of uv_0, and its variances.
vec4 seenSlope(SurfacePoint point) {
  float tiles = material.height_frequency;
  float part = tiles / sqrt(samples_per_pixel);
  vec4 stored = textureGrad(slopes, point.uv_0 * tiles, point.uv_across * part, point.uv_down * part);
  float unit = height_form.x * tiles;
  return stored * vec4(unit, unit, unit * unit, unit * unit);
}

// The texture coordinates that a way along the surface passes.
//   along   world; only what is across n counts
vec2 uvAlong(SurfaceChange change, vec3 n, vec3 along) {
  vec3 for_u = cross(change.along_v, n);
  vec3 for_v = cross(n, change.along_u);
  float area = dot(change.along_u, for_u);
  return area == 0.0 ? vec2(0.0) : vec2(dot(along, for_u), dot(along, for_v)) / area;
}

vec2 texelsAlong(SurfaceChange change, vec3 n, vec3 along) {
  return uvAlong(change, n, along) * material.height_frequency * heightMapSize();
}
