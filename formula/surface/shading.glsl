// How a surface answers to the light of its environment.
// Needs: color, constants, material, microfacet, optics, reflection_lobe.
// Other objects neither block light nor send it: each point sees the whole environment.

struct Surface {
  Material material;      // its numbers here: times what its textures hold
  vec3 normal;            // unit, on the viewer's side
  float occlusion;
  vec2 environment_brdf;  // for its roughness and n·v what the BRDF table's scale and bias lack to 1, and the bias
};

// Shares of a white environment's light.
struct Reflectance {
  vec3 single_scattering;    // of the light around the mirror direction, after one bounce
  vec3 multiple_scattering;  // of the light from all sides, after several bounces between the facets of a rough surface
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
  bool has_index = k.x + k.y + k.z > 0.0f;
  if (s.material.fresnel == kFresnelExact && has_index) return fresnelConductor(cosine, s.material.conductor_n, k);
  return fresnelSchlick(cosine, s.material.base_color);
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
  vec3 here = vec3(dielectricReflectance(s, cosine, ior.x), dielectricReflectance(s, cosine, ior.y),
                   dielectricReflectance(s, cosine, ior.z));
  if (s.material.specular_color == vec3(1.0f)) return s.material.specular * here;
  vec3 f0 = vec3(dielectricReflectance(s, 1.0f, ior.x), dielectricReflectance(s, 1.0f, ior.y),
                 dielectricReflectance(s, 1.0f, ior.z));
  return tintedReflectance(s.material, here, f0);
}

// What a surface reflects whose facets reflect `here` at this angle, f0 at normal and f90 at grazing incidence. Up to
// perceptual roughness ¼ (alpha 1/16) the lobe is so narrow that Fresnel's equations hold at its middle. From 0 to ¼
// they are blended into the BRDF table, which knows only f0 and f90.
FN Reflectance roughReflectance(Surface s, vec3 here, vec3 f0, float f90) {
  float missing = s.environment_brdf.x;
  float bias = s.environment_brdf.y;
  float whole = 1.0f - missing;
  vec3 rough = f0 * (whole - bias) + vec3(f90 * bias);
  Reflectance r;
  r.single_scattering = mix(here * whole, rough, clamp(s.material.perceptual_roughness * 4.0f, 0.0f, 1.0f));
  r.multiple_scattering = multipleScattering(r.single_scattering, meanFresnel(f0, f90), missing);
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
