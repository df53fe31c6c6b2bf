// What happens to a ray at a smooth surface. Directions point along the ray; n is the unit normal on the side that the
// ray comes from; cosine is −dot(ray, n) = V·N in [0, 1]; eta is the index of the far side over that of the near side.

// A normal that does not turn away from the ray that meets its triangle, as a smooth one may: it is bent back.
FN vec3 facingNormal(vec3 normal, vec3 ray) {
  const float kLeastCosine = 1e-3f;
  float cosine = -dot(ray, normal);
  return cosine < kLeastCosine ? normalize(normal - ray * (kLeastCosine - cosine)) : normal;
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

// The lecture's form, offset + scale (1 + V·N)ⁿ with V from the eye to the surface, so that V·N = −cos θ.
FN float fresnelEmpirical(float cosine, float offset, float scale, float power) {
  return clamp(offset + scale * pow(max(1.0f - cosine, 0.0f), power), 0.0f, 1.0f);
}

// The index for the red, green and blue channel of a glass whose index is `ior` at 588 nm. KHR_materials_dispersion:
// dispersion = 20 / V with Abbe's number V = (n_d − 1) / (n_F − n_C), red and blue standing for the lines C and F.
FN vec3 iorOfChannels(float ior, float dispersion) {
  float half_spread = (ior - 1.0f) * 0.025f * dispersion;
  return vec3(ior - half_spread, ior, ior + half_spread);
}

// The same for one wavelength [µm]: Cauchy's n = A + B / λ² through `ior` at the line d. From the line C (0.6563 µm) to
// F (0.4861 µm) the index grows by (n_d − 1) / V, and so B = (n_d − 1) dispersion / 20 / (1 / F² − 1 / C²).
FN float iorAtWavelength(float ior, float dispersion, float wavelength) {
  const float cauchy = 0.026183f;  // µm²: 1 / 20 / (1 / F² − 1 / C²)
  const float line_d = 0.58756f;
  float spread = (ior - 1.0f) * dispersion * cauchy * (1.0f / (wavelength * wavelength) - 1.0f / (line_d * line_d));
  return max(ior + spread, 0.1f);  // far from any glass it would end below 0
}
