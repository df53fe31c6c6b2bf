// How a surface answers to the light of its environment.
// Needs: color, constants, material, microfacet, optics, reflection_lobe, thin_film.
// Other objects neither block light nor send it: each point sees the whole environment.

// Shares of a white environment's light.
struct Reflectance {
  vec3 single_scattering;    // of the light around the mirror direction, after one bounce
  vec3 forward_scattering;   // likewise, after several bounces between the facets of a rough surface
  vec3 multiple_scattering;  // of the light from all sides, after several bounces
  vec3 grazing;              // of single_scattering, what facets do not reflect at normal incidence
};

// Of the light around the mirror direction, however often it bounces.
FN vec3 aroundMirror(Reflectance r) { return r.single_scattering + r.forward_scattering; }

struct Surface {
  Material material;      // its numbers here: times what its textures hold
  vec3 normal;            // unit, on the viewer's side
  float own_roughness INITIALLY(0.0f);  // perceptual, without the bumps that a pixel hides; of a renderer only
  vec3 tangent INITIALLY(vec3(1.0f, 0.0f, 0.0f));  // unit, across the normal: anisotropy stretches along it
  float occlusion;
  // For its roughness and n·v: what white facets do not send away at the first bounce; of those that do, 1 − the cosine
  // at which Schlick's term is its mean, the fifth root of the BRDF table's bias / (scale + bias); and the mean of
  // 1 − their cosine.
  vec3 environment_brdf;
  // What stretched facets send away at the first bounce, over what round ones of the narrow width do (stretchedShare).
  float stretched_share INITIALLY(1.0f);
  // What white cloth of its sheen_roughness reflects of a white environment; 0: no sheen.
  float sheen_albedo INITIALLY(0.0f);
  // What it does with the light around it on the way to the eye, set by seenAlong():
  Reflectance reflectance;
  vec3 diffuse_albedo;    // the share of light that enters and may leave again: what a dielectric does not reflect
};

// A direction in the surface's frame of tangent, bitangent and normal.
FN vec3 inFrame(Surface s, vec3 d) {
  return vec3(dot(d, s.tangent), dot(d, cross(s.normal, s.tangent)), dot(d, s.normal));
}

// Towards the eye in that frame, never from below.
//   ray          unit, from the eye to the surface
FN vec3 eyeInFrame(Surface s, vec3 ray) {
  vec3 v = -inFrame(s, ray);
  return vec3(v.x, v.y, clamp(v.z, 1e-4f, 1.0f));
}

FN bool hasConductorIndex(Material m) { return m.conductor_k.x + m.conductor_k.y + m.conductor_k.z > 0.0f; }

FN RefractiveIndex refractiveIndexOf(Material m) {
  return MAKE(RefractiveIndex)(m.ior, m.dispersion, m.sellmeier_b, m.sellmeier_c);
}

// A material as light of one wavelength [µm] meets it, for which it has one index; 0: as light of all does.
FN Material atWavelength(Material m, float wavelength) {
  if (wavelength <= 0.0f) return m;
  m.ior = iorAtWavelength(refractiveIndexOf(m), wavelength);
  m.dispersion = 0.0f;
  m.sellmeier_b = vec4(0.0f);
  return m;
}

FN vec3 bareDielectricReflectance(Material m, float cosine, vec3 ior) {
  if (m.fresnel == kFresnelExact) return fresnelDielectricOfChannels(cosine, ior);
  if (m.fresnel == kFresnelEmpirical)
    return vec3(fresnelEmpirical(cosine, m.fresnel_offset, m.fresnel_scale, m.fresnel_power));
  vec3 f0 = normalDielectricReflectance(ior);
  if (m.fresnel == kFresnelF82) return fresnelF82(cosine, f0, m.f82_tint);
  return fresnelSchlick(cosine, f0);
}

FN vec3 bareMetalReflectance(Material m, float cosine) {
  if (m.fresnel == kFresnelExact && hasConductorIndex(m)) return fresnelConductor(cosine, m.conductor_n, m.conductor_k);
  if (m.fresnel == kFresnelF82) return fresnelF82(cosine, m.base_color, m.f82_tint);
  return fresnelSchlick(cosine, m.base_color);
}

// Of a smooth metal or dielectric, where a thin film covers its share of it. HAS_FILM is always false in the shaders of
// surfaces without one.
//   ior          of a dielectric, which may differ between the channels
FN vec3 smoothReflectance(Material m, float cosine, vec3 ior, bool is_metal) {
  vec3 bare = is_metal ? bareMetalReflectance(m, cosine) : bareDielectricReflectance(m, cosine, ior);
  if (!HAS_FILM(m)) return bare;
  vec3 n = is_metal ? iorOfReflectance(m.base_color) : ior;
  vec3 k = vec3(0.0f);
  if (is_metal && hasConductorIndex(m)) {
    n = m.conductor_n;
    k = m.conductor_k;
  }
  return mix(bare, filmReflectance(cosine, m.iridescence_ior, 0.001f * m.iridescence_thickness, n, k), m.iridescence);
}

FN vec3 dielectricReflectance(Material m, float cosine, vec3 ior) { return smoothReflectance(m, cosine, ior, false); }

FN vec3 metalReflectance(Material m, float cosine) { return smoothReflectance(m, cosine, vec3(1.0f), true); }

// Two kinds of facets that stand for all which send light to the eye: those at some cosine, the first number, are the
// share that is the second, and the rest is met at normal incidence. They have all facets' means of 1 − cosine and of
// (1 − cosine)⁵, which the BRDF table knows: from share · u = mean tilt and share · u⁵ = grazing⁵. So Schlick's form is
// exact on average, and a line; other forms are between the two, and what is the same at all angles stays so.
//   cosine   −dot(ray, n); a mirror has no facets
FN vec2 facetsSeen(Surface s, float cosine) {
  bool has_facets = s.material.perceptual_roughness > 0.0f || s.material.anisotropy > 0.0f;
  if (!has_facets) return vec2(cosine, 1.0f);
  const float kLeastTilt = 1e-6f;
  float grazing2 = s.environment_brdf.y * s.environment_brdf.y;
  float tilt = max(s.environment_brdf.z, kLeastTilt);
  float u = min(sqrt(sqrt(grazing2 * grazing2 * s.environment_brdf.y / tilt)), 1.0f);
  return vec2(1.0f - u, min(tilt / max(u, kLeastTilt), 1.0f));
}

// A dielectric's reflectance with the strength and the colour of KHR_materials_specular: at normal incidence it is f0
// times the colour, at most 1, and from there it rises to 1 as it did from f0. With Schlick's form that is the
// extension's formula. The exact form of a great index falls below f0 before it rises; that part is scaled.
FN vec3 tintedReflectance(Material m, vec3 reflectance, vec3 f0) {
  if (m.specular_color == vec3(1.0f)) return m.specular * reflectance;
  vec3 start = min(f0 * m.specular_color, vec3(1.0f));
  vec3 fallen = min(reflectance, f0) / max(f0, vec3(1e-6f));
  vec3 risen = max(reflectance - f0, vec3(0.0f)) / max(vec3(1.0f) - f0, vec3(1e-6f));
  return m.specular * (start * fallen + (vec3(1.0f) - start) * risen);
}

// Of a smooth dielectric, per channel: dispersion gives each its own index.
FN vec3 smoothDielectric(Material m, float cosine) {
  vec3 ior = iorOfChannels(m.ior, m.dispersion);
  return tintedReflectance(m, dielectricReflectance(m, cosine, ior), dielectricReflectance(m, 1.0f, ior));
}

// The reflectance of the facets of a rough metal or dielectric.
struct FacetShares {
  vec3 seen;    // by the eye
  vec3 normal;  // at normal incidence
  vec3 mean;    // over the hemisphere, for multiple scattering
};

// The reflectance of the facets which that light meets first that stays between them. They are tilted at least as far
// from the eye as those that it sees, which are few along the normal, and at least as far as all are on average: random
// walks have them farther still (the test MultipleScattering).
FN vec3 firstOfSeveral(FacetShares facets) {
  return mix(min(facets.seen, facets.mean), max(facets.seen, facets.mean), step(facets.normal, facets.mean));
}

// What a surface reflects that has such facets. Light that stretched ones do not send away at once goes to and fro in
// their grooves and leaves along them with the rest: a series as in multipleScattering.
FN Reflectance roughReflectance(Surface s, FacetShares facets) {
  float missing = s.environment_brdf.x;
  float held = 1.0f - s.stretched_share;
  Reflectance r;
  r.single_scattering = facets.seen * (1.0f - missing) * s.stretched_share / (vec3(1.0f) - held * facets.seen);
  r.multiple_scattering = multipleScattering(firstOfSeveral(facets), facets.mean, missing);
  return r;
}

// In a loop, so that what a film reflects stands in the shader once.
FN FacetShares facetShares(Surface s, float cosine, bool is_metal) {
  FacetShares shares = MAKE(FacetShares)(vec3(0.0f), vec3(0.0f), vec3(0.0f));
  vec3 ior = iorOfChannels(s.material.ior, s.material.dispersion);
  vec2 seen = facetsSeen(s, cosine);
  for (int i = 0; i < 5; ++i) {
    float at = i == 0 ? seen.x : 1.0f;
    if (i >= 2) at = kMeanFresnelCosines[i - 2];
    vec3 reflectance = smoothReflectance(s.material, at, ior, is_metal);
    if (i == 0) shares.seen = reflectance;
    if (i == 1) shares.normal = reflectance;
    if (i >= 2) shares.mean += kMeanFresnelWeights[i - 2] * reflectance;
  }
  shares.seen = mix(shares.normal, shares.seen, seen.y);
  return shares;
}

// A material whose specular colour is grey, as bright as its brightest channel. What it does not reflect is what enters
// (KHR_materials_specular): a red reflection does not make what is below it cyan.
FN Material withGreySpecular(Material m) {
  m.specular_color = vec3(max(max(m.specular_color.x, m.specular_color.y), m.specular_color.z));
  return m;
}

FN Reflectance dielectricOf(Surface s, Material tint, FacetShares facets) {
  FacetShares tinted;
  tinted.seen = tintedReflectance(tint, facets.seen, facets.normal);
  tinted.normal = tintedReflectance(tint, facets.normal, facets.normal);
  tinted.mean = tintedReflectance(tint, facets.mean, facets.normal);
  return roughReflectance(s, tinted);
}

// How much of what facets reflect they do not reflect at normal incidence: nothing where a film makes it less.
FN vec3 grazingShare(vec3 seen, vec3 normal) {
  return clamp(vec3(1.0f) - normal / max(seen, vec3(1e-6f)), vec3(0.0f), vec3(1.0f));
}

// A surface with what it does with the light around it. glTF mixes its metal and its dielectric, not their parts
// (appendix B.3.5).
//   ray          unit, from the eye to the surface
FN Surface seenAlong(Surface s, vec3 ray) {
  Material m = s.material;
  float cosine = clamp(-dot(ray, s.normal), 0.0f, 1.0f);
  FacetShares facets = MAKE(FacetShares)(vec3(0.0f), vec3(0.0f), vec3(0.0f));
  FacetShares of_metal = facets;
  if (m.metallic < 1.0f) facets = facetShares(s, cosine, false);
  if (m.metallic > 0.0f) of_metal = facetShares(s, cosine, true);
  Reflectance dielectric = dielectricOf(s, m, facets);
  Reflectance kept_out = dielectricOf(s, withGreySpecular(m), facets);
  Reflectance metal = roughReflectance(s, of_metal);
  s.reflectance.single_scattering = mix(dielectric.single_scattering, metal.single_scattering, m.metallic);
  vec3 several = mix(dielectric.multiple_scattering, metal.multiple_scattering, m.metallic);
  s.reflectance.multiple_scattering = several * evenFractionBesideRow(m.perceptual_roughness, cosine);
  s.reflectance.forward_scattering = several - s.reflectance.multiple_scattering;
  vec3 seen = mix(tintedReflectance(m, facets.seen, facets.normal), of_metal.seen, m.metallic);
  vec3 normal = mix(tintedReflectance(m, facets.normal, facets.normal), of_metal.normal, m.metallic);
  s.reflectance.grazing = grazingShare(seen, normal);
  vec3 enters = vec3(1.0f) - kept_out.single_scattering - kept_out.multiple_scattering;
  s.diffuse_albedo = m.base_color * (1.0f - m.metallic) * enters;
  return s;
}

// The same of a surface that lies in another body, as water in a glass, behind a surface of that body which is parallel
// to it: the ray that meets it is the refracted one, and its index is relative to that body's.
//   ray          unit, from the eye, before it is refracted
//   ior_around   of the body around it; 1: it lies in air
FN Surface seenWithin(Surface s, vec3 ray, float ior_around) {
  Material own = s.material;
  s.material.ior /= ior_around;
  s = seenAlong(s, ior_around == 1.0f ? ray : refractedDirection(ray, s.normal, ior_around));
  s.material = own;
  return s;
}

// A material that answers to no light and shows a colour as radiance (KHR_materials_unlit).
FN Material unlitMaterial(Material m, vec3 color) {
  m.base_color = vec3(0.0f);
  m.metallic = 0.0f;
  m.specular = 0.0f;
  m.transmission = 0.0f;
  m.clearcoat = 0.0f;
  m.sheen_color = vec3(0.0f);
  m.emission = color;
  return m;
}

// A material of the core of glTF alone.
FN Material coreMaterial(Material m, vec3 base_color, float metallic, float perceptual_roughness, vec3 emission) {
  m = unlitMaterial(m, emission);
  m.base_color = base_color;
  m.metallic = metallic;
  m.perceptual_roughness = perceptual_roughness;
  m.specular = 1.0f;
  m.specular_color = vec3(1.0f);
  m.ior = 1.5f;
  m.dispersion = 0.0f;
  m.conductor_k = vec3(0.0f);
  m.fresnel = kFresnelSchlick;
  m.anisotropy = 0.0f;
  m.iridescence = 0.0f;
  return m;
}

// A material that shows what is seen through it, and nothing else.
FN Material openMaterial(Material m) {
  m = unlitMaterial(m, vec3(0.0f));
  m.anisotropy = 0.0f;
  m.iridescence = 0.0f;
  m.base_color = vec3(1.0f);
  m.transmission = 1.0f;
  return m;
}

// Light under cloth, and what the cloth adds: it lets through what its brightest channel does not reflect, so that
// white stays white and no colour comes up that is in neither (KHR_materials_sheen).
//   light        of the surface without cloth
//   on_cloth     what white cloth shows of the light around it
FN vec3 underSheen(Surface s, vec3 light, vec3 on_cloth) {
  vec3 color = s.material.sheen_color;
  float strongest = max(color.x, max(color.y, color.z));
  return light * (1.0f - strongest * s.sheen_albedo) + color * on_cloth;
}

// The radiance towards the viewer: what is not reflected is refracted, scattered or absorbed, so that a white surface
// in a white environment is exactly white.
//   s            seenAlong the ray from the eye
//   reflected    the environment's radiance in the mirror direction, blurred for the roughness
//   refracted    the radiance that is seen through it; read only where transmission > 0
//   irradiance   on the surface, divided by π
//   on_cloth     the mean radiance that cloth reflects; read only where there is sheen
FN vec3 shadedByEnvironment(Surface s, vec3 reflected, vec3 refracted, vec3 irradiance, vec3 on_cloth) {
  vec3 inner = mix(irradiance * s.occlusion, refracted, s.material.transmission);
  // Occlusion is known for diffuse light only. It takes more of the reflected light the rougher the lobe is.
  float reflected_occlusion = mix(1.0f, s.occlusion, s.material.perceptual_roughness);
  vec3 specular = reflected * aroundMirror(s.reflectance) * reflected_occlusion +
                  irradiance * s.occlusion * s.reflectance.multiple_scattering;
  vec3 light = specular + inner * s.diffuse_albedo + s.material.emission;
  return underSheen(s, light, on_cloth * (s.occlusion * s.sheen_albedo));
}

// What a surface shows of itself to itself where its relief hides the environment. It reflects the share R of what
// arrives, of which a share is the sky's and the rest is such light again: L = e + R (share · E + (1 − share) L). What
// a hidden place sees of the relief is higher than it is itself, and sees more of the sky: halfway to all of it.
//   s            seenAlong the ray from the eye
//   seen         the share of the sky that it sees itself
//   irradiance   of the sky, divided by π
FN vec3 lightOfRelief(Surface s, float seen, vec3 irradiance) {
  float share = mix(seen, 1.0f, 0.5f);
  vec3 albedo = aroundMirror(s.reflectance) + s.reflectance.multiple_scattering +
                s.diffuse_albedo * (1.0f - s.material.transmission);
  return (s.material.emission + albedo * share * irradiance) / max(vec3(1.0f) - albedo * (1.0f - share), vec3(1e-3f));
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
  vec3 diffuse = s.diffuse_albedo * (1.0f - s.material.transmission) + s.reflectance.multiple_scattering;
  vec3 lobe = aroundMirror(s.reflectance) * ((exponent + 2.0f) / 2.0f * pow(mirrored, exponent));
  return color * facing * underSheen(s, diffuse + lobe, vec3(s.sheen_albedo));
}
