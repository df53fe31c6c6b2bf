// The heights of a material (scene/relief/height_texture.h), over the first texture coordinates.
#include "height_sampler.glsl"

uniform highp sampler2D slopes;  // SlopeMoments of height_field/slope_moments.h

vec2 heightMapSize() { return vec2(textureSize(heights, 0)); }

// Between the deepest and the highest place: world.
float reliefDepth(SurfacePoint point) {
  return abs(material.height_scale) * length(mat3(world_from_object) * point.object_normal);
}

// The mean slope that a pixel sees, (∂d/∂u, ∂d/∂v) in world units a unit of uv_0, and its variances.
vec4 seenSlope(SurfacePoint point) {
  float tiles = material.height_frequency;
  vec4 stored = textureGrad(slopes, point.uv_0 * tiles, point.uv_across * tiles, point.uv_down * tiles);
  float unit = height_form.z * tiles * reliefDepth(point);
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
