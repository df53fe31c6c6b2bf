// What happens to a ray at a smooth surface. Directions point along the ray; n is the unit normal on the side that the
// ray comes from; cosine is −dot(ray, n) = V·N in [0, 1]; eta is the index of the far side over that of the near side.

// A normal that does not turn away from the ray that meets its triangle, as a smooth one may: it is bent back.
FN vec3 facingNormal(vec3 normal, vec3 ray) {
  const float kLeastCosine = 1e-3f;
  float cosine = -dot(ray, normal);
  return cosine < kLeastCosine ? normalize(normal - ray * (kLeastCosine - cosine)) : normal;
}

// A point of a surface so far on one side of it as rounding may have put it on the other.
//
// distance_to  from where the ray came that met it
// towards      unit, away from the surface
FN vec3 besideSurface(vec3 place, float distance_to, vec3 towards) {
  vec3 magnitude = abs(place);
  return place + towards * (4e-6f * max(max(magnitude.x, magnitude.y), max(magnitude.z, distance_to)));
}

// What a body leaves of light over a distance (Lambert & Beer).
//
// color, over  what is left of white light after that distance; 0: nothing is absorbed
FN vec3 bodyTransmittance(vec3 color, float over, float distance) {
  return over > 0.0f ? pow(color, vec3(min(distance / over, 1e6f))) : vec3(1.0f);
}

// The direction of the ray beyond the surface (Snell: n1 sin θ1 = n2 sin θ2). Past the critical angle nothing passes
// and the ray reflects: GLSL's refract then gives 0, which is no direction.
FN vec3 refractedDirection(vec3 ray, vec3 n, float eta) {
  vec3 refracted = refract(ray, n, 1.0f / eta);
  return dot(refracted, refracted) == 0.0f ? reflect(ray, n) : refracted;
}

// Fresnel's equations for unpolarised light between two dielectrics; 1 past the critical angle.
FN float fresnelDielectric(float cosine, float eta) {
  if (eta == 1.0f) return 0.0f;  // also along the surface, where the equations are 0 / 0
  float sine2 = (1.0f - cosine * cosine) / (eta * eta);
  if (sine2 >= 1.0f) return 1.0f;
  float cosine_t = sqrt(1.0f - sine2);
  float parallel = (eta * cosine - cosine_t) / (eta * cosine + cosine_t);
  float perpendicular = (cosine - eta * cosine_t) / (cosine + eta * cosine_t);
  return (parallel * parallel + perpendicular * perpendicular) / 2.0f;
}

FN vec3 fresnelDielectricOfChannels(float cosine, vec3 eta) {
  return vec3(fresnelDielectric(cosine, eta.x), fresnelDielectric(cosine, eta.y), fresnelDielectric(cosine, eta.z));
}

// The same at normal incidence: ((η − 1) / (η + 1))².
FN vec3 normalDielectricReflectance(vec3 eta) {
  vec3 amplitude = (eta - 1.0f) / (eta + 1.0f);
  return amplitude * amplitude;
}

// The same into a metal of complex index n + ik (Born & Wolf, Principles of Optics, 14.2).
FN float fresnelConductor1(float cosine, float n, float k) {
  float cosine2 = cosine * cosine;
  float sine2 = 1.0f - cosine2;
  float difference = n * n - k * k - sine2;
  float a2b2 = sqrt(difference * difference + 4.0f * n * n * k * k);
  float a = sqrt(max((a2b2 + difference) / 2.0f, 0.0f));
  float sum = a2b2 + cosine2;
  float cross_term = 2.0f * a * cosine;
  float perpendicular = (sum - cross_term) / (sum + cross_term);
  float sum_p = cosine2 * a2b2 + sine2 * sine2;
  float cross_p = cross_term * sine2;
  float parallel = perpendicular * (sum_p - cross_p) / (sum_p + cross_p);
  return (parallel + perpendicular) / 2.0f;
}

FN vec3 fresnelConductor(float cosine, vec3 n, vec3 k) {
  return vec3(fresnelConductor1(cosine, n.x, k.x), fresnelConductor1(cosine, n.y, k.y),
              fresnelConductor1(cosine, n.z, k.z));
}

// Schlick 1994: f0 + (1 − f0)(1 − cos θ)⁵.
FN vec3 fresnelSchlick(float cosine, vec3 f0) {
  float grazing = 1.0f - cosine;
  float grazing2 = grazing * grazing;
  return f0 + (1.0f - f0) * (grazing2 * grazing2 * grazing);
}

// F82 (Kutz, Hašan & Edmondson 2021, "Novel aspects of the Adobe Standard Material"): Schlick's form less a dip near
// grazing incidence, a cos θ (1 − cos θ)⁶, which metals have. It is deepest at cos θ = 1/7, an angle of 82°; `tint` is
// the share that it leaves of Schlick's form there, 1 being no dip. Where f0 is small a deep dip would end below 0.
FN vec3 fresnelF82(float cosine, vec3 f0, vec3 tint) {
  const float deepest_cosine = 1.0f / 7.0f;
  const float of_deepest = 17.651384f;  // 1 / (1/7 · (6/7)⁶)
  float grazing = 1.0f - cosine;
  float grazing2 = grazing * grazing;
  vec3 a = fresnelSchlick(deepest_cosine, f0) * (1.0f - tint) * of_deepest;
  return max(fresnelSchlick(cosine, f0) - a * (cosine * grazing2 * grazing2 * grazing2), vec3(0.0f));
}

// The lecture's form, offset + scale (1 + V·N)ⁿ with V from the eye to the surface, so that V·N = −cos θ.
FN float fresnelEmpirical(float cosine, float offset, float scale, float power) {
  return clamp(offset + scale * pow(max(1.0f - cosine, 0.0f), power), 0.0f, 1.0f);
}

// How the index of a substance depends on the wavelength.
struct RefractiveIndex {
  float ior;         // at the line d, 588 nm
  float dispersion;  // 20 / Abbe number
  vec4 sellmeier_b;  // terms of iorOfSellmeier; all 0: only the two numbers above are known
  vec4 sellmeier_c;
};

// The index for the red, green and blue channel of a glass whose index is `ior` at 588 nm. KHR_materials_dispersion:
// dispersion = 20 / V with Abbe's number V = (n_d − 1) / (n_F − n_C), red and blue standing for the lines C and F.
FN vec3 iorOfChannels(float ior, float dispersion) {
  float half_spread = (ior - 1.0f) * 0.025f * dispersion;
  return vec3(ior - half_spread, ior, ior + half_spread);
}

// The same for one wavelength [µm]: Cauchy's n = A + B / λ² through `ior` at the line d. From the line C (0.6563 µm) to
// F (0.4861 µm) the index grows by (n_d − 1) / V, and so B = (n_d − 1) dispersion / 20 / (1 / F² − 1 / C²).
FN float iorOfCauchy(float ior, float dispersion, float wavelength) {
  const float cauchy = 0.026183f;  // µm²: 1 / 20 / (1 / F² − 1 / C²)
  const float line_d = 0.58756f;
  float spread = (ior - 1.0f) * dispersion * cauchy * (1.0f / (wavelength * wavelength) - 1.0f / (line_d * line_d));
  return max(ior + spread, 0.1f);  // far from any glass it would end below 0
}

// The same from measurements, where there are some (scene/material/optical_constants.h): Sellmeier 1871, n² = 1 +
// Σ b λ² / (λ² − c), with λ in µm and c in µm². c are the squares of wavelengths that the substance absorbs: the
// formula holds between them, as in all visible light.
FN float iorOfSellmeier(vec4 b, vec4 c, float wavelength) {
  vec4 squared = vec4(wavelength * wavelength);
  return sqrt(1.0f + dot(b, squared / (squared - c)));
}

// The index for light of one wavelength [µm], as it was measured, where it was.
FN float iorAtWavelength(RefractiveIndex index, float wavelength) {
  if (index.sellmeier_b == vec4(0.0f)) return iorOfCauchy(index.ior, index.dispersion, wavelength);
  return iorOfSellmeier(index.sellmeier_b, index.sellmeier_c, wavelength);
}
