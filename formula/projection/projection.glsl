// Equirectangular and angular maps: direction ↔ position in the image. Needs: constants.
// A position (u, v) has v growing downwards from the image's top row, both in [0, 1]; directions are unit vectors.
// Pictures of each: docs/conventions.md.

// Longitude runs along the row so that +Z stands in the middle and +X to the left of it:
// u = atan2(x, −z) / 2π mod 1, v = acos(y) / π. Same directions as OpenEXR's LatLong and Mitsuba 3.
FN vec2 equirectPosition(vec3 d) {
  // atan has no value at the poles, where every u names the same direction.
  float longitude = (d.x == 0.0f && d.z == 0.0f) ? kPi : atan(d.x, -d.z);
  // Near the poles acos(y) loses half the digits of y; the angle from its sine and cosine keeps them.
  float latitude = atan(sqrt(d.x * d.x + d.z * d.z), d.y);
  float u = longitude / kTwoPi;
  return vec2(u < 0.0f ? u + 1.0f : u, latitude / kPi);
}

FN vec3 equirectDirection(vec2 uv) {
  float longitude = uv.x * kTwoPi;
  float latitude = uv.y * kPi;
  return vec3(sin(latitude) * sin(longitude), cos(latitude), -sin(latitude) * cos(longitude));
}

// The solid angle of a texel between the two latitudes v0 < v1, in an image `width` texels wide: the zone between
// two parallels has the area 2π (cos θ0 − cos θ1) (Archimedes).
FN float equirectTexelSolidAngle(float v0, float v1, float width) {
  return (cos(v0 * kPi) - cos(v1 * kPi)) * kTwoPi / width;
}

// Angular map (light probe): the distance from the centre is proportional to the angle θ from +Z and reaches ½ at −Z,
// with +X to the right as on a mirror ball: (x, y) θ / (2π √(x² + y²)) from the centre.
// Debevec 1998, in the form "u = x·r, v = y·r with r = acos(z) / (π √(x² + y²))" for u, v in [−1, 1].
FN vec2 angularPosition(vec3 d) {
  float sine = sqrt(d.x * d.x + d.y * d.y);
  // Straight ahead the ratio θ / sin θ tends to 1; straight behind every point of the rim is the same direction.
  if (sine == 0.0f) return d.z >= 0.0f ? vec2(0.5f, 0.5f) : vec2(1.0f, 0.5f);
  float radius = atan(sine, d.z) / kTwoPi;
  return vec2(0.5f + radius * d.x / sine, 0.5f - radius * d.y / sine);
}

// Outside the disc (radius above ½) there is no direction: ask insideDisc first.
FN vec3 angularDirection(vec2 uv) {
  vec2 from_center = vec2(uv.x - 0.5f, 0.5f - uv.y);
  float radius = length(from_center);
  if (radius == 0.0f) return vec3(0.0f, 0.0f, 1.0f);
  float angle = radius * kTwoPi;
  return vec3(from_center * (sin(angle) / radius), cos(angle));
}

// Whether a position lies on the disc that an angular map or a sphere map fills.
FN bool insideDisc(vec2 uv) {
  vec2 from_center = vec2(uv.x - 0.5f, uv.y - 0.5f);
  return dot(from_center, from_center) <= 0.25f;
}
