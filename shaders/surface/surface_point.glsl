// A point of a surface that the eye sees.

struct SurfacePoint {
  vec3 position;         // world
  vec3 object_position;
  vec3 normal;           // world, unit, of the smooth surface
  vec3 object_normal;    // unit
  vec4 tangent;          // world, of growing u; the sign of the bitangent
  vec2 uv_0;
  vec2 uv_1;
  vec4 color;            // of the vertices
  vec3 ray;              // world, unit, from the eye
  vec2 uv_across;        // how uv_0 changes to the next pixels
  vec2 uv_down;
  vec2 uv_1_across;      // likewise uv_1
  vec2 uv_1_down;
  vec3 object_across;    // how object_position does, on the triangle that was drawn; else 0
  vec3 object_down;
};

// A part of what a sample of a pixel sees.
//   at      from its middle, in footprints
//   share   of their sides
SurfacePoint stratumOf(SurfacePoint point, vec2 at, float share) {
  at /= sqrt(samples_per_pixel);
  point.uv_0 += at.x * point.uv_across + at.y * point.uv_down;
  point.uv_1 += at.x * point.uv_1_across + at.y * point.uv_1_down;
  point.object_position += at.x * point.object_across + at.y * point.object_down;
  point.uv_across *= share;
  point.uv_down *= share;
  point.uv_1_across *= share;
  point.uv_1_down *= share;
  point.object_across *= share;
  point.object_down *= share;
  return point;
}

// How the place changes with texture coordinates: world, a unit of uv_0.
struct SurfaceChange {
  vec3 along_u;
  vec3 along_v;
};

// Of a plane, on which places and coordinates change evenly: from two of their differences. Where the coordinates are
// all the same there is no change.
SurfaceChange changeOf(vec3 across, vec3 down, vec2 uv_across, vec2 uv_down) {
  float area = uv_across.x * uv_down.y - uv_across.y * uv_down.x;
  if (area == 0.0) return SurfaceChange(vec3(0.0), vec3(0.0));
  return SurfaceChange((across * uv_down.y - down * uv_across.y) / area,
                       (down * uv_across.x - across * uv_down.x) / area);
}
