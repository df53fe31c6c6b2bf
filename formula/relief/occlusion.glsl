// How much of the sky a place on a height field sees, slice by slice: a half-plane through the place's vertical, above
// a horizon.

// What one slice sees: its share of the irradiance, and the light's mean direction times that share.
//
// With the angle θ from the vertical and the slice's part of the unit normal, n · d = n_z cos θ + n_along sin θ, the
// integrals of (n · d) sin θ, times 1, sin θ and cos θ, have closed forms from θ = 0 to the horizon's. The sum over
// slices, each times its width in radians, is π for a place that sees all that is before its normal. (The first of
// them as in Jiménez et al. 2016, "Practical realtime strategies for accurate indirect occlusion", eq. 7, which takes
// slices around the view instead of around the vertical.)
//   n_along   the normal's part along the slice, horizontally away from the place
//   n_z       its vertical part, above 0
//   horizon   the slope at which the slice's view of the sky ends; where the surface's own slope is more, that does
//   returns   (along the slice, up, share)
FN vec3 visibleSlice(float n_along, float n_z, float horizon) {
  float slope = max(horizon, -n_along / n_z);
  float s = 1.0f / sqrt(1.0f + slope * slope);
  float c = slope * s;
  float angle = atan(1.0f, slope);
  float s3 = s * s * s / 3.0f;
  float c3 = c * c * c / 3.0f;
  float share = 0.5f * (n_z * s * s + n_along * (angle - s * c));
  return vec3(n_z * s3 + n_along * (2.0f / 3.0f - c + c3), n_z * (1.0f / 3.0f - c3) + n_along * s3, share);
}
