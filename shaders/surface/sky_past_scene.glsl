// Part "sky" (sky_open.glsl). Here: the scene hides a part of the environment, as its vertices know, and shows there what
// it reflects itself.
#include "self_occlusion.glsl"

in vec4 vertex_hidden;
in vec3 vertex_shown;

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  // Of a surface that is seen from behind nothing is known.
  float open = seesFront() ? clamp(vertex_hidden.w, 0.0, 1.0) : 1.0;
  vec3 shown = seesFront() ? vertex_shown : vec3(0.0);
  Opening opening = openingOf(s.normal, seesFront() ? vertex_hidden.xyz : vec3(0.0), open);
  vec3 on_surface = arrivingIrradiance(point.position, opening.axis);
  vec3 of_lobe = incomingLight(point.position, opening.axis, roughnessOfOpening(opening), 0.0);
  vec3 irradiance = open * lightThroughOpening(of_lobe, on_surface, open) + shown * on_surface;
  // What hides a place is lit through the same opening.
  vec3 hidden = shown / max(1.0 - open, 1e-3) * on_surface;
  float lobe = lobeInOpening(opening, s.normal, reflect(point.ray, s.normal),
                             alphaFromPerceptualRoughness(s.material.perceptual_roughness));
  // A texture that says so too does not darken twice, but where it knows of more.
  s.occlusion = min(s.occlusion / max(open, 1e-3), 1.0);
  return shadedByEnvironment(s, mix(hidden, reflectedLight(s, point), lobe), transmitted, irradiance,
                             on_cloth * (open + shown));
}
