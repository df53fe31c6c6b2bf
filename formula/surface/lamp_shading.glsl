// How a surface answers to lamps. They have no width: what a mirror shows of them is widened to kLeastLampAlpha.
// Needs: charlie, constants, ggx, lamp, material, microfacet, shading.

const float kLeastLampAlpha = 0.01f;

// The BRDF of a surface for light that comes from one direction.
//   v, l         unit, towards the eye and the light, in the surface's frame and above it
//   facets       of GGX's facets, without Fresnel's factor
FN vec3 litFrom(Surface s, vec3 v, vec3 l, vec3 facets) {
  float at_facet = clamp(dot(v, normalize(v + l)), 0.0f, 1.0f);
  vec3 fresnel =
      mix(smoothDielectric(s.material, at_facet), metalReflectance(s.material, at_facet), s.material.metallic);
  vec3 several = s.reflectance.multiple_scattering + s.reflectance.forward_scattering;
  float even = evenFraction(s.material.perceptual_roughness, v.z);
  vec3 matt = s.diffuse_albedo * (1.0f - s.material.transmission) + even * several;
  // What stays in the grooves of stretched facets leaves along them, too (roughReflectance).
  vec3 leaves = vec3(1.0f) - (1.0f - s.stretched_share) * fresnel;
  // What is not even after several bounces goes about where white facets send light at once, which is this share.
  float at_once = max((1.0f - s.environment_brdf.x) * s.stretched_share, 1e-3f);
  vec3 shown = matt / kPi + facets * (fresnel / leaves + (1.0f - even) / at_once * several);
  if (s.sheen_albedo <= 0.0f) return shown;
  return underSheen(s, shown, vec3(evalCharlie(alphaOfSheen(s.material.sheen_roughness), v, l)));
}

// The radiance towards the viewer of a surface that a punctual light shines on (KHR_lights_punctual). What one facet
// sends is glTF's D V with Fresnel's factor at the facet; what several facets send and what enters is spread evenly, in
// the shares that it has under the environment (shadedByEnvironment). Light from behind passes no surface.
//   s            seenAlong the ray
//   ray          unit, from the eye to the surface
//   light        unit, from the surface to the light
//   illuminance  of a surface that faces the light
FN vec3 shadedByPunctualLight(Surface s, vec3 ray, vec3 light, vec3 illuminance) {
  vec3 l = inFrame(s, light);
  if (l.z <= 0.0f) return vec3(0.0f);
  vec3 v = eyeInFrame(s, ray);
  vec2 alpha = max(stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy), vec2(kLeastLampAlpha));
  return illuminance * l.z * litFrom(s, v, l, vec3(evalGgx(alpha, v, l)));
}

// The same of any lamp.
//   place        world, of the surface
FN vec3 shadedByLamp(Surface s, vec3 ray, vec3 place, Lamp lamp) {
  vec3 light = towardsLamp(lamp, place);
  if (lamp.kind == kLampPhong) return shadedByPointLight(s, ray, light, lamp.color);
  return shadedByPunctualLight(s, ray, light, lampIlluminance(lamp, place));
}
