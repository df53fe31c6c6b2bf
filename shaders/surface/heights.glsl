// The heights of a material (scene/relief/height_texture.h), over the first texture coordinates.
#include "texture_filter.glsl"
#include "height_map.glsl"

uniform highp sampler2D heights;
uniform highp sampler2D slopes;  // SlopeMoments of height_field/slope_moments.h
uniform vec4 height_form;        // how it is wrapped; its last level; the unit of slopes; steps of a search

HeightMap heightMap() { return HeightMap(int(height_form.x), int(height_form.y)); }

vec2 heightMapSize() { return vec2(textureSize(heights, 0)); }

// Between the deepest and the highest place: world.
float reliefDepth(SurfacePoint point) {
  return abs(material.height_scale) * length(mat3(world_from_object) * point.object_normal);
}

// The mean slope that a pixel sees, (∂d/∂u, ∂d/∂v) in world units a unit of uv_0, and its variances.
vec4 seenSlope(SurfacePoint point) {
  vec4 stored = texture(slopes, point.uv_0 * material.height_frequency);
  float unit = height_form.z * material.height_frequency * reliefDepth(point);
  return stored * vec4(unit, unit, unit * unit, unit * unit);
}

// The texels that a way along the surface passes.
//   along   world; only what is across n counts
vec2 texelsAlong(SurfaceChange change, vec3 n, vec3 along) {
  vec3 for_u = cross(change.along_v, n);
  vec3 for_v = cross(n, change.along_u);
  float area = dot(change.along_u, for_u);
  if (area == 0.0) return vec2(0.0);
  return vec2(dot(along, for_u), dot(along, for_v)) / area * material.height_frequency * heightMapSize();
}
