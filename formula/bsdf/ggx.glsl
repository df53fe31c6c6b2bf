// A rough mirror of GGX's microfacets (Trowbridge & Reitz 1975; Walter et al. 2007), without Fresnel. The frame and the
// names are diffuse.glsl's; v is towards the eye, h the normal of the facets that reflect l to v. alpha > 0 is the
// width along x and along y, the tangent and the bitangent; they differ where the roughness has a direction (Burley
// 2012).
// Needs: constants.

// The widths of a surface whose roughness is stretched along its tangent (KHR_materials_anisotropy).
FN vec2 stretchedAlpha(float perceptual_roughness, float anisotropy) {
  float alpha = perceptual_roughness * perceptual_roughness;
  return vec2(mix(alpha, 1.0f, anisotropy * anisotropy), alpha);
}

// The area of facets whose normal is h, for each area of the surface and solid angle (Walter et al. 2007, eq. 33).
// Their slope tells small angles apart where h.z does not.
FN float ggxDistribution(vec2 alpha, vec3 h) {
  if (h.z <= 0.0f) return 0.0f;
  vec2 slope = vec2(h.x, h.y) / (h.z * alpha);
  float cosine2 = h.z * h.z;
  float spread = 1.0f + dot(slope, slope);
  return 1.0f / (kPi * alpha.x * alpha.y * cosine2 * cosine2 * spread * spread);
}

// Smith's Λ: how much area of facets hides behind others, seen from w, for each area seen (Heitz 2014, eqs. 72 and 80).
FN float ggxLambda(vec2 alpha, vec3 w) {
  vec2 across = alpha * vec2(w.x, w.y);
  return (sqrt(1.0f + dot(across, across) / max(w.z * w.z, 1e-30f)) - 1.0f) / 2.0f;
}

FN float ggxMasking(vec2 alpha, vec3 v) { return 1.0f / (1.0f + ggxLambda(alpha, v)); }

// Seen from both sides; facets that lie high are seen from both (height-correlated: Heitz 2014, eq. 99).
FN float ggxMaskingShadowing(vec2 alpha, vec3 v, vec3 l) {
  return 1.0f / (1.0f + ggxLambda(alpha, v) + ggxLambda(alpha, l));
}

// The density of a facet's normal among those that the eye sees (Heitz 2018, eq. 1).
FN float pdfVisibleNormal(vec2 alpha, vec3 v, vec3 h) {
  return ggxMasking(alpha, v) * max(dot(v, h), 0.0f) * ggxDistribution(alpha, h) / max(v.z, 1e-30f);
}

// A normal of that density. Stretched, the facets are a hemisphere, and what is seen of a hemisphere reflects the eye's
// ray into a spherical cap with equal density everywhere (Heitz 2018; the cap: Dupuy & Benyoub 2023).
FN vec3 sampleVisibleNormal(vec2 alpha, vec3 v, vec2 u) {
  vec3 stretched = normalize(vec3(alpha.x * v.x, alpha.y * v.y, v.z));
  float z = (1.0f - u.x) * (1.0f + stretched.z) - stretched.z;
  float sine = sqrt(clamp(1.0f - z * z, 0.0f, 1.0f));
  vec3 h = vec3(sine * cos(kTwoPi * u.y), sine * sin(kTwoPi * u.y), z) + stretched;
  return normalize(vec3(alpha.x * h.x, alpha.y * h.y, max(h.z, 0.0f)));
}

// Walter et al. 2007, eq. 20.
FN float evalGgx(vec2 alpha, vec3 v, vec3 l) {
  if (v.z <= 0.0f || l.z <= 0.0f) return 0.0f;
  vec3 h = normalize(v + l);
  return ggxDistribution(alpha, h) * ggxMaskingShadowing(alpha, v, l) / (4.0f * v.z * l.z);
}

// May lie below the horizon, where nothing is reflected: the share of those is what further bounces would carry.
FN vec3 sampleGgx(vec2 alpha, vec3 v, vec2 u) { return reflect(-v, sampleVisibleNormal(alpha, v, u)); }

FN float pdfGgx(vec2 alpha, vec3 v, vec3 l) {
  vec3 h = normalize(v + l);
  return pdfVisibleNormal(alpha, v, h) / max(4.0f * dot(v, h), 1e-30f);
}
