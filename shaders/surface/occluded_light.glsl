// The light of the environment at a place of which it is known what the scene hides from it (VertexOcclusion).
#include "color.glsl"
#include "self_occlusion.glsl"

// What is known of a place: VertexOcclusion.
struct PlaceInScene {
  vec4 occluded;  // and the share that is open
  vec3 interreflected;
  vec3 lit_from;
  vec3 emitted;
};

struct OccludedLight {
  float open;
  Opening opening;
  vec3 share;       // of an even light, what arrives with all that the scene reflects
  vec3 irradiance;  // over pi, likewise
  vec3 tint;        // of what hides the environment: its mean radiance in white light
  vec3 occluded;    // and in this light, if it is matt
  vec3 emitted;     // the scene's own irradiance, over pi
};

const PlaceInScene kInTheOpen = PlaceInScene(vec4(0.0, 0.0, 0.0, 1.0), vec3(0.0), vec3(0.0), vec3(0.0));

// The light on the surfaces that hide the sky from a place, which face the same way by the length of `lit_from`; those
// that do not are lit as the place is.
//   on_axis   on a surface along the opening's axis, divided by π
vec3 lightOnOccluders(vec3 position, PlaceInScene place, vec3 on_axis) {
  float brightness = luminance(place.interreflected);
  float size = length(place.lit_from);
  if (size < 1e-3 * brightness || size <= 0.0) return on_axis;
  vec3 towards = place.lit_from / size;
  vec3 facing = arrivingIrradiance(position, towards) + irradianceOfSuns(towards, allSuns());
  return mix(on_axis, facing, min(size / brightness, 1.0));
}

// Of the environment's light, divided by π.
//   on_axis   on a surface along the opening's axis
vec3 lightPastHiders(vec3 position, vec3 normal, Opening opening, float open, vec3 on_axis) {
  vec3 of_lobe = lightOfWideLobe(position, opening.axis, roughnessOfCone(opening.angle));
  vec3 through = open * lightThroughOpening(of_lobe, on_axis, open);
  float share = shareBesideOccluded(opening, open);
  if (share <= 0.0) return through;
  float roughness = roughnessOfCone(opening.occluded_angle);
  vec3 of_occluded = lightOfWideLobe(position, opening.occluded_axis, roughness);
  vec3 beside = lightBesideOccluded(arrivingIrradiance(position, normal), of_occluded, through, open);
  return mix(through, beside, share);
}

//   suns   those that are seen from there
OccludedLight occludedLight(vec3 position, vec3 normal, PlaceInScene place, SunsSeen suns) {
  OccludedLight light;
  light.open = clamp(place.occluded.w, 0.0, 1.0);
  light.opening = openingOf(normal, place.occluded.xyz, light.open);
  light.share = light.open + place.interreflected;
  vec3 on_axis = arrivingIrradiance(position, light.opening.axis);
  vec3 on_occluders = lightOnOccluders(position, place, on_axis + irradianceOfSuns(light.opening.axis, suns));
  light.irradiance = lightPastHiders(position, normal, light.opening, light.open, on_axis) +
                     place.interreflected * on_occluders + place.emitted;
  light.tint = min(place.interreflected / max(1.0 - light.open, kLeastOccluded), 1.0);
  light.emitted = place.emitted;
  light.occluded = light.tint * on_occluders;
  return light;
}

// Of a surface that is drawn. Where it is seen from behind something is known if backs are drawn by themselves.
OccludedLight lightAtPoint(Surface s, SurfacePoint point, PlaceInScene place) {
  return occludedLight(point.position, s.normal, seesFront() || knows_backs > 0 ? place : kInTheOpen,
                       suns_at_point);
}

// The mean radiance of what shines, for a lobe that sees at least what hides: of a small lamp a rough surface shows no
// more than its share of the lobe. Where among the hiders a lamp lies is not known, so that it counts as at least half
// of the hemisphere: else three lamps over metal would be three wedges between the corners of its triangles.
vec3 radianceOfEmission(OccludedLight light, float alpha) {
  float tangent = min(alpha, 1.0);  // of half the angle that the lobe reaches to
  float sine = 2.0 * tangent / (1.0 + tangent * tangent);
  return light.emitted / max(max(1.0 - light.open, sine * sine), 0.5);
}

// What a surface reflects around a direction, where the environment shows `reflected`. What hides the environment from
// polished metal is most often more of it, and shows about as bright a part of the environment.
vec3 occludedReflection(OccludedLight light, Surface s, vec3 direction, vec3 reflected) {
  float alpha = alphaFromPerceptualRoughness(s.material.perceptual_roughness);
  float polish = s.material.metallic * (1.0 - smoothstep(0.1, 0.5, s.material.perceptual_roughness));
  vec3 occluded = mix(light.occluded, light.tint * reflected, polish) + radianceOfEmission(light, alpha);
  // Smooth water and glass, of few large triangles, would show where each corner's few rays end as a star: there the
  // opening's edge is soft.
  const float kSoftEdge = 0.35;
  Opening opening = light.opening;
  opening.is_occluded_by_one *= 1.0 - s.material.transmission;
  return mix(occluded, reflected,
             lobeInOpening(opening, s.normal, direction, max(alpha, kSoftEdge * s.material.transmission)));
}

vec3 shadedOccluded(OccludedLight light, Surface s, vec3 reflected, vec3 transmitted, vec3 on_cloth) {
  // A texture that says so too does not darken twice, but where it knows of more.
  s.occlusion = min(s.occlusion / max(light.open, 1e-3), 1.0);
  return shadedByEnvironment(s, reflected, transmitted, light.irradiance, on_cloth * light.share);
}
