// The light of the environment at a place of which it is known what the scene hides from it (VertexOcclusion).
#include "self_occlusion.glsl"

struct LightPastScene {
  float open;
  Opening opening;
  vec3 share;       // of an even light, what arrives with all that the scene reflects
  vec3 irradiance;  // over pi, likewise
  vec3 tint;        // of what hides the environment: its mean radiance in white light
  vec3 hidden;      // and in this light, if it is matt
};

LightPastScene lightPastScene(vec3 position, vec3 normal, vec4 hidden, vec3 shown) {
  LightPastScene light;
  light.open = clamp(hidden.w, 0.0, 1.0);
  light.opening = openingOf(normal, hidden.xyz, light.open);
  light.share = light.open + shown;
  vec3 on_surface = arrivingIrradiance(position, light.opening.axis);
  vec3 of_lobe = incomingLight(position, light.opening.axis, roughnessOfOpening(light.opening), 0.0);
  light.irradiance = light.open * lightThroughOpening(of_lobe, on_surface, light.open) + shown * on_surface;
  // What hides a place is lit through the same opening.
  light.tint = shown / max(1.0 - light.open, 1e-3);
  light.hidden = light.tint * on_surface;
  return light;
}

// Of a surface that is drawn. Where it is seen from behind nothing is known.
LightPastScene lightAtPoint(Surface s, SurfacePoint point, vec4 hidden, vec3 shown) {
  bool is_known = seesFront();
  return lightPastScene(point.position, s.normal, is_known ? hidden : vec4(0.0, 0.0, 0.0, 1.0),
                        is_known ? shown : vec3(0.0));
}

// What a surface reflects around a direction, where the environment shows `reflected`. What hides the environment from
// polished metal is most often more of it, and shows about as bright a part of the environment.
vec3 reflectedPastScene(LightPastScene light, Surface s, vec3 direction, vec3 reflected) {
  float alpha = alphaFromPerceptualRoughness(s.material.perceptual_roughness);
  float polish = s.material.metallic * (1.0 - smoothstep(0.1, 0.5, s.material.perceptual_roughness));
  vec3 hidden = mix(light.hidden, light.tint * reflected, polish);
  // Smooth water and glass, of few large triangles, would show where each corner's few rays end as a star.
  Opening opening = light.opening;
  opening.is_hidden_by_one *= 1.0 - s.material.transmission;
  return mix(hidden, reflected, lobeInOpening(opening, s.normal, direction, alpha));
}

vec3 shadedPastScene(LightPastScene light, Surface s, vec3 reflected, vec3 transmitted, vec3 on_cloth) {
  // A texture that says so too does not darken twice, but where it knows of more.
  s.occlusion = min(s.occlusion / max(light.open, 1e-3), 1.0);
  return shadedByEnvironment(s, reflected, transmitted, light.irradiance, on_cloth * light.share);
}
