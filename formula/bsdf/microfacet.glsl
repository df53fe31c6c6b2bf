// Rough surfaces. alpha = perceptual_roughness² is the width of the lobe (Burley 2012).

FN float alphaFromPerceptualRoughness(float perceptual_roughness) {
  return perceptual_roughness * perceptual_roughness;
}

// The share of white light that leaves a rough surface after two bounces or more between its facets (Fdez-Agüera 2019, "A
// multiple-scattering microfacet model for real-time image-based lighting", eqs. 9 to 12). Of what does not leave at a
// bounce, the missing share, the next facet reflects the mean share F, of which the part once / F leaves again, and so on: a
// geometric series that for facets which reflect all makes up exactly what the first bounce leaves missing.
//   once         f0 · scale + bias of the BRDF table: what leaves after one bounce
//   mean_fresnel the facets' reflectance, averaged over the cosine-weighted hemisphere
//   missing      1 − scale − bias: what facets that reflect all do not send away at once
FN vec3 multipleScattering(vec3 once, vec3 mean_fresnel, float missing) {
  vec3 again = mean_fresnel * missing;
  return once * again / (1.0f - again);
}

// The cosine-weighted mean of Schlick's form, 2 ∫ (f0 + (1 − f0)(1 − μ)⁵) μ dμ, for a reflectance that grows to `grazing`.
FN vec3 meanFresnel(vec3 head_on, float grazing) { return head_on + (grazing - head_on) / 21.0f; }
