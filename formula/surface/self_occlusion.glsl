// What the objects of a scene hide of the environment from a place of a surface, and show there instead: known for each
// vertex by rays (rays/scene_occlusion.h), as a share and a mean direction.
// Needs: constants.

// The part of the hemisphere that is open, as a cone (ambient aperture lighting: Oat & Sander 2007).
struct Opening {
  vec3 axis;                 // unit: the mean direction of the light of an even sky, the bent normal (Landis 2002)
  float angle;               // half of its aperture [rad]
  vec3 occluded_axis;        // of what hides the rest, as a cone likewise
  float occluded_angle;      // half of its aperture [rad]
  float likeness;            // of the occluded directions: 1 where they are as much alike as those of a cone
  float is_occluded_by_one;  // 1: what hides lies together, and is less than what is open; 0: it lies all around
};

// Below that share nothing is hidden. It only keeps zeros out of divisions: from a corner of a triangle that sees all
// the sky to one that does not, the share grows from 0, and what hides stays as much alike, in the same direction. A
// share that is seen in a picture would draw a line there.
const float kLeastOccluded = 1e-6f;

// The angle in [0, π/2] whose sine has that square.
FN float angleOfSine(float squared) { return atan(sqrt(squared / max(1.0f - squared, 1e-12f))); }

// A cone of half the aperture b, all above the surface, whose axis is tilted by t, lets through the share sin² b cos t
// of an even sky's irradiance. The open hemisphere is one too, and what is hidden is missing in its mean direction, 2/3
// n.
//
// What hides is known by the same two numbers. It lies together, as a knob beside a place does, if its directions are
// as much alike as those of a cone of its share, whose mean is as long as (1 + cos b) / 2.
//   n          unit
//   occluded   the mean of the occluded directions, those that are open counting as 0
//   open       share of the irradiance, in [0, 1]
FN Opening openingOf(vec3 n, vec3 occluded, float open) {
  vec3 mean = (2.0f / 3.0f) * n - occluded;
  vec3 axis = dot(mean, mean) > 1e-6f ? normalize(mean) : n;
  float squared_sine = clamp(open / max(dot(axis, n), 0.05f), 0.0f, 1.0f);
  float length_of_occluded = length(occluded);
  vec3 occluded_axis = length_of_occluded > kLeastOccluded ? occluded / length_of_occluded : n;
  float share = 1.0f - open;
  float occluded_squared_sine = clamp(share / max(dot(occluded_axis, n), 0.2f), 0.0f, 1.0f);
  float occluded_cosine = sqrt(1.0f - occluded_squared_sine);
  float likeness = length_of_occluded / max(share * (0.5f + 0.5f * occluded_cosine), kLeastOccluded);
  float is_occluded_by_one = smoothstep(0.8f, 0.95f, likeness) * (1.0f - smoothstep(0.3f, 0.6f, share));
  return MAKE(Opening)(axis, angleOfSine(squared_sine), occluded_axis, angleOfSine(occluded_squared_sine), likeness,
                       is_occluded_by_one);
}

// Of unit vectors, by its half, whose tangent is |a − b| / |a + b|: also exact where they are nearly the same, unlike
// the inverse of the cosine.
FN float angleBetween(vec3 a, vec3 b) { return 2.0f * atan(length(a - b) / max(length(a + b), 1e-18f)); }

// How much of what a surface reflects around a direction is in the opening, of all that is above the surface.
//
// What hides takes no more of a lobe than about its own size, as where two caps of a sphere meet (Oat & Sander 2007):
// the less is hidden the less it takes, however wide the lobe is, and a hider of no size takes nothing.
//   direction   unit
//   alpha       of the facets: half of the lobe lies within twice the angle whose tangent that is (GGX)
FN float lobeInOpening(Opening opening, vec3 n, vec3 direction, float alpha) {
  float width = 0.02f + 2.0f * atan(alpha);
  float above = max(smoothstep(-width, width, 0.5f * kPi - angleBetween(direction, n)), 1e-3f);
  float inside = opening.angle - angleBetween(direction, opening.axis);
  float open = clamp(smoothstep(-width, width, inside) / above, 0.0f, 1.0f);
  float behind = opening.occluded_angle - angleBetween(direction, opening.occluded_axis);
  float size = min(smoothstep(0.0f, width, opening.occluded_angle) / above, 1.0f);
  return mix(open, 1.0f - size * smoothstep(-width, width, behind), opening.is_occluded_by_one);
}

// The roughness of a GGX lobe along the normal that has half of its weight within the same angle as an even light in a
// cone, weighted by its cosine: sin² of that is half of the aperture's. A fit of the inverse of ggxHalfAngle, by 1.5°.
//   angle   half of the aperture [rad]
FN float roughnessOfCone(float angle) { return pow(clamp(angle / (0.5f * kPi), 0.0f, 1.0f), 0.7f); }

// What arrives through the opening, over its share. The light of a lobe as wide as it is shows where the sky is bright,
// but knows nothing of the cosine to the normal; the light on a surface along its axis knows too much of what is beside
// it. Halfway between them errs least, and where nothing is hidden the latter is exact.
FN vec3 lightThroughOpening(vec3 of_lobe, vec3 on_surface, float open) {
  return mix(of_lobe, on_surface, 0.5f + 0.5f * open);
}

// What is left of all the light on the surface: what hides takes that of a lobe as wide as it is. Where that lobe holds
// a sun it may take more than there is: what is left is half of what comes through the opening, at least.
//   on_surface   where nothing is hidden
//   through      the opening
FN vec3 lightBesideOccluded(vec3 on_surface, vec3 of_occluded_lobe, vec3 through, float open) {
  return max(on_surface - (1.0f - open) * of_occluded_lobe, 0.5f * through);
}

// How much the latter counts beside the former. It is nearer where what hides lies together and most is open: on a wall
// that stands on a floor the light comes from its front, where the opening's axis does not point. The bounds are those
// that were nearest to paths in twenty scenes (docs/techniques/objects.md).
FN float shareBesideOccluded(Opening opening, float open) {
  return smoothstep(0.3f, 0.65f, open) * smoothstep(0.7f, 0.95f, opening.likeness);
}
