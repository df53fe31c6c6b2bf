// How a surface answers to the light of its environment.
// Needs: color, constants, material, microfacet, optics, reflection_lobe.
// Other objects neither block light nor send it: each point sees the whole environment.

struct Surface {
  Material material;      // its numbers here: times what its textures hold
  vec3 normal;            // unit, on the viewer's side
  float occlusion;
  // For its roughness and n·v: what white facets do not send away at the first bounce, and 1 − the cosine at which
  // Schlick's term is its mean over the facets: the fifth root of the BRDF table's bias / (scale + bias).
  vec2 environment_brdf;
};

// Shares of a white environment's light.
struct Reflectance {
  vec3 single_scattering;    // of the light around the mirror direction, after one bounce
  vec3 multiple_scattering;  // of the light from all sides, after several bounces between the facets of a rough surface
};

// Of a smooth dielectric, whose index may differ between the channels.
FN vec3 dielectricReflectance(Surface s, float cosine, vec3 ior) {
  Material m = s.material;
  if (m.fresnel == kFresnelExact) return fresnelDielectricOfChannels(cosine, ior);
  if (m.fresnel == kFresnelEmpirical)
    return vec3(fresnelEmpirical(cosine, m.fresnel_offset, m.fresnel_scale, m.fresnel_power));
  vec3 f0 = fresnelDielectricOfChannels(1.0f, ior);
  if (m.fresnel == kFresnelF82) return fresnelF82(cosine, f0, m.f82_tint);
  return fresnelSchlick(cosine, f0);
}

FN vec3 metalReflectance(Surface s, float cosine) {
  Material m = s.material;
  bool has_index = m.conductor_k.x + m.conductor_k.y + m.conductor_k.z > 0.0f;
  if (m.fresnel == kFresnelExact && has_index) return fresnelConductor(cosine, m.conductor_n, m.conductor_k);
  if (m.fresnel == kFresnelF82) return fresnelF82(cosine, m.base_color, m.f82_tint);
  return fresnelSchlick(cosine, m.base_color);
}

// The cosine at which a facet stands for all that the eye sees: where Schlick's (1 − cosine)⁵ is its mean over them,
// which is known from the BRDF table. So Schlick's form is exact on average. Any other form is taken at that cosine
// too: it is nearly a line over Schlick's term, and what is the same at all angles stays so.
//   cosine   −dot(ray, n); a mirror has no facets
FN float cosineOfFacets(Surface s, float cosine) {
  return s.material.perceptual_roughness > 0.0f ? 1.0f - s.environment_brdf.y : cosine;
}

// A dielectric's reflectance with the strength and the colour of KHR_materials_specular: at normal incidence it is f0
// times the colour, at most 1, and from there it rises to 1 as it did from f0. With Schlick's form that is the
// extension's formula. The exact form of a great index falls below f0 before it rises; that part is scaled.
FN vec3 tintedReflectance(Material m, vec3 reflectance, vec3 f0) {
  vec3 start = min(f0 * m.specular_color, vec3(1.0f));
  vec3 fallen = min(reflectance, f0) / max(f0, vec3(1e-6f));
  vec3 risen = max(reflectance - f0, vec3(0.0f)) / max(vec3(1.0f) - f0, vec3(1e-6f));
  return m.specular * (start * fallen + (vec3(1.0f) - start) * risen);
}

// Of a smooth dielectric, per channel: dispersion gives each its own index.
FN vec3 smoothDielectric(Surface s, float cosine) {
  vec3 ior = iorOfChannels(s.material.ior, s.material.dispersion);
  vec3 here = dielectricReflectance(s, cosine, ior);
  if (s.material.specular_color == vec3(1.0f)) return s.material.specular * here;
  return tintedReflectance(s.material, here, dielectricReflectance(s, 1.0f, ior));
}

// What a surface reflects whose facets reflect `facets`, as the eye sees them, and `mean` over the hemisphere.
FN Reflectance roughReflectance(Surface s, vec3 facets, vec3 mean) {
  float missing = s.environment_brdf.x;
  Reflectance r;
  r.single_scattering = facets * (1.0f - missing);
  r.multiple_scattering = multipleScattering(r.single_scattering, mean, missing);
  return r;
}

// The mean over the hemisphere is of the one index: what dispersion adds to it is not seen.
FN Reflectance roughDielectric(Surface s, float cosine) {
  vec3 ior = vec3(s.material.ior);
  vec3 mean = meanFresnel(dielectricReflectance(s, kMeanFresnelCosines.x, ior),
                          dielectricReflectance(s, kMeanFresnelCosines.y, ior),
                          dielectricReflectance(s, kMeanFresnelCosines.z, ior));
  vec3 tinted = tintedReflectance(s.material, mean, dielectricReflectance(s, 1.0f, ior));
  return roughReflectance(s, smoothDielectric(s, cosineOfFacets(s, cosine)), tinted);
}

FN Reflectance roughMetal(Surface s, float cosine) {
  vec3 mean = meanFresnel(metalReflectance(s, kMeanFresnelCosines.x), metalReflectance(s, kMeanFresnelCosines.y),
                          metalReflectance(s, kMeanFresnelCosines.z));
  return roughReflectance(s, metalReflectance(s, cosineOfFacets(s, cosine)), mean);
}

// glTF mixes the two materials, not their parts (appendix B.3.5).
FN Reflectance specularReflectance(Surface s, float cosine) {
  Reflectance dielectric = roughDielectric(s, cosine);
  Reflectance metal = roughMetal(s, cosine);
  Reflectance r;
  r.single_scattering = mix(dielectric.single_scattering, metal.single_scattering, s.material.metallic);
  r.multiple_scattering = mix(dielectric.multiple_scattering, metal.multiple_scattering, s.material.metallic);
  return r;
}

// A material whose specular colour is grey, as bright as its brightest channel. What it does not reflect is what enters
// (KHR_materials_specular): a red reflection does not make what is below it cyan.
FN Material withGreySpecular(Material m) {
  m.specular_color = vec3(max(max(m.specular_color.x, m.specular_color.y), m.specular_color.z));
  return m;
}

// The share of light that enters the surface and may leave it again: what a dielectric of its kind does not reflect.
FN vec3 diffuseAlbedo(Surface s, float cosine) {
  vec3 albedo = s.material.base_color * (1.0f - s.material.metallic);
  if (s.material.metallic == 1.0f) return albedo;
  s.material = withGreySpecular(s.material);
  Reflectance dielectric = roughDielectric(s, cosine);
  return albedo * (vec3(1.0f) - dielectric.single_scattering - dielectric.multiple_scattering);
}

// A material that answers to no light and shows a colour as radiance (KHR_materials_unlit).
FN Material unlitMaterial(Material m, vec3 color) {
  m.base_color = vec3(0.0f);
  m.metallic = 0.0f;
  m.specular = 0.0f;
  m.transmission = 0.0f;
  m.emission = color;
  return m;
}

// A material that shows what is seen through it, and nothing else.
FN Material openMaterial(Material m) {
  m = unlitMaterial(m, vec3(0.0f));
  m.base_color = vec3(1.0f);
  m.transmission = 1.0f;
  return m;
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
  // Occlusion is known for diffuse light only. It takes more of the reflected light the rougher the lobe is.
  float reflected_occlusion = mix(1.0f, s.occlusion, s.material.perceptual_roughness);
  vec3 specular = reflected * reflectance.single_scattering * reflected_occlusion +
                  irradiance * s.occlusion * reflectance.multiple_scattering;
  return specular + inner * diffuseAlbedo(s, cosine) + s.material.emission;
}

// Phong's point light: diffuse by Lambert, specular by the reflected ray, its lobe scaled to keep its energy.
//   light        unit, from the surface to the light
//   color        the radiance that a white diffuse surface facing the light shows
FN vec3 shadedByPointLight(Surface s, vec3 ray, vec3 light, vec3 color) {
  float facing = dot(s.normal, light);
  if (facing <= 0.0f) return vec3(0.0f);
  // A point light has no width: on a perfect mirror it could not be seen.
  float exponent = phongExponent(max(alphaFromPerceptualRoughness(s.material.perceptual_roughness), 0.01f));
  float mirrored = max(dot(reflect(ray, s.normal), light), 0.0f);
  float cosine = clamp(-dot(ray, s.normal), 0.0f, 1.0f);
  Reflectance reflectance = specularReflectance(s, cosine);
  vec3 diffuse = diffuseAlbedo(s, cosine) * (1.0f - s.material.transmission) + reflectance.multiple_scattering;
  vec3 lobe = reflectance.single_scattering * ((exponent + 2.0f) / 2.0f * pow(mirrored, exponent));
  return color * facing * (diffuse + lobe);
}
