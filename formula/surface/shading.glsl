// How a surface answers to the light of its environment.
// Needs: color, constants, material, microfacet, optics, reflection_lobe.
// Light that another object would block or send is not seen: each point sees the whole environment.

struct Surface {
  Material material;      // its numbers here: times what its textures hold
  vec3 normal;            // unit, on the viewer's side
  float occlusion;
  vec2 environment_brdf;  // for its roughness and n·v what the BRDF table's scale and bias lack to 1, and the bias
};

// Shares of a white environment's light.
struct Reflectance {
  vec3 once;  // of the light around the mirror direction, after one bounce
  vec3 more;  // of the light from all sides, after several bounces between the facets of a rough surface
};

FN float dielectricReflectance(Surface s, float cosine, float ior) {
  Material m = s.material;
  if (m.fresnel == kFresnelEmpirical)
    return fresnelEmpirical(cosine, m.fresnel_offset, m.fresnel_scale, m.fresnel_power);
  if (m.fresnel == kFresnelSchlick) return fresnelSchlick(cosine, vec3(fresnelDielectric(1.0f, ior))).x;
  return fresnelDielectric(cosine, ior);
}

FN vec3 metalReflectance(Surface s, float cosine) {
  vec3 k = s.material.conductor_k;
  if (s.material.fresnel == kFresnelExact && k.x + k.y + k.z > 0.0f) return fresnelConductor(cosine, s.material.conductor_n, k);
  return fresnelSchlick(cosine, s.material.base_color);
}

// Of a smooth dielectric, per channel: dispersion gives each its own index.
FN vec3 smoothDielectric(Surface s, float cosine) {
  vec3 ior = iorOfChannels(s.material.ior, s.material.dispersion);
  return s.material.specular * vec3(dielectricReflectance(s, cosine, ior.x), dielectricReflectance(s, cosine, ior.y),
                           dielectricReflectance(s, cosine, ior.z));
}

// What a surface reflects whose facets reflect `here` at this angle, `head_on` and `grazing`. A lobe up to perceptual
// roughness ¼ (alpha 1/16) is so narrow that Fresnel's equations hold at its middle; from 0 to there they give way to the
// BRDF table, which knows only the reflectance head-on.
FN Reflectance roughReflectance(Surface s, vec3 here, vec3 head_on, float grazing) {
  float missing = s.environment_brdf.x;
  float bias = s.environment_brdf.y;
  float whole = 1.0f - missing;
  vec3 rough = head_on * (whole - bias) + vec3(grazing * bias);
  Reflectance r;
  r.once = mix(here * whole, rough, clamp(s.material.perceptual_roughness * 4.0f, 0.0f, 1.0f));
  r.more = multipleScattering(r.once, meanFresnel(head_on, grazing), missing);
  return r;
}

FN Reflectance roughDielectric(Surface s, float cosine) {
  return roughReflectance(s, smoothDielectric(s, cosine), smoothDielectric(s, 1.0f), s.material.specular);
}

// glTF mixes the two materials, not their parts (appendix B.3.5).
FN Reflectance specularReflectance(Surface s, float cosine) {
  Reflectance dielectric = roughDielectric(s, cosine);
  Reflectance metal = roughReflectance(s, metalReflectance(s, cosine), metalReflectance(s, 1.0f), 1.0f);
  Reflectance r;
  r.once = mix(dielectric.once, metal.once, s.material.metallic);
  r.more = mix(dielectric.more, metal.more, s.material.metallic);
  return r;
}

// The share of light that a surface takes in and may send back: what a dielectric of its kind does not reflect.
FN vec3 diffuseAlbedo(Surface s, float cosine) {
  vec3 albedo = s.material.base_color * (1.0f - s.material.metallic);
  if (s.material.metallic == 1.0f) return albedo;
  Reflectance dielectric = roughDielectric(s, cosine);
  return albedo * (vec3(1.0f) - dielectric.once - dielectric.more);
}

// The radiance towards the viewer: what is not reflected is refracted, scattered or absorbed, so that a white surface
// in a white environment is exactly white.
//   ray          unit, from the eye to the surface
//   reflected    the environment's radiance in the mirror direction, blurred for the roughness
//   refracted    the radiance that is seen through it; read only where transmission > 0
//   irradiance   on the surface, divided by π
FN vec3 shadedByEnvironment(Surface s, vec3 ray, vec3 reflected, vec3 refracted, vec3 irradiance) {
  float cosine = clamp(-dot(ray, s.normal), 0.0f, 1.0f);
  Reflectance reflectance = specularReflectance(s, cosine);
  vec3 inner = mix(irradiance * s.occlusion, refracted, s.material.transmission);
  // Occlusion is known for diffuse light only; of reflected light it takes the more the rougher the lobe.
  float reflected_occlusion = mix(1.0f, s.occlusion, s.material.perceptual_roughness);
  vec3 specular = reflected * reflectance.once * reflected_occlusion + irradiance * s.occlusion * reflectance.more;
  return specular + inner * diffuseAlbedo(s, cosine) + s.material.emission;
}

// Phong's point light: diffuse by Lambert, specular by the reflected ray, its lobe scaled to keep its energy.
//   light        unit, from the surface to the light
//   color        the radiance that a white diffuse surface facing the light shows
FN vec3 shadedByPointLight(Surface s, vec3 ray, vec3 light, vec3 color) {
  float facing = dot(s.normal, light);
  if (facing <= 0.0f) return vec3(0.0f);
  // A point has no width of its own: on a perfect mirror nothing of it would be seen.
  float exponent = phongExponent(max(alphaFromPerceptualRoughness(s.material.perceptual_roughness), 0.01f));
  float mirrored = max(dot(reflect(ray, s.normal), light), 0.0f);
  float cosine = clamp(-dot(ray, s.normal), 0.0f, 1.0f);
  Reflectance reflectance = specularReflectance(s, cosine);
  vec3 diffuse = diffuseAlbedo(s, cosine) * (1.0f - s.material.transmission) + reflectance.more;
  vec3 lobe = reflectance.once * ((exponent + 2.0f) / 2.0f * pow(mirrored, exponent));
  return color * facing * (diffuse + lobe);
}
