// Rough surfaces. alpha = perceptual_roughness² is the width of the lobe (Burley 2012).

FN float alphaFromPerceptualRoughness(float perceptual_roughness) {
  return perceptual_roughness * perceptual_roughness;
}

// Multiple scattering: the share of white light that leaves a rough surface after two or more bounces between its
// facets (Fdez-Agüera 2019, "A multiple-scattering microfacet model for real-time image-based lighting", eqs. 9 to 12).
// Of the missing share, which does not leave at a bounce, the next facet reflects the mean share F. Of that the part
// single_scattering / F leaves, and so on. This is a geometric series. For facets that reflect everything it adds up to
// exactly what single scattering leaves missing.
//   single_scattering  f0 · scale + bias of the BRDF table: what leaves after one bounce
//   mean_fresnel       the facets' reflectance, averaged over the cosine-weighted hemisphere
//   missing            1 − scale − bias: the share that facets with reflectance 1 do not send away at the first bounce
FN vec3 multipleScattering(vec3 single_scattering, vec3 mean_fresnel, float missing) {
  vec3 again = mean_fresnel * missing;
  return single_scattering * again / (1.0f - again);
}

// The cosine-weighted mean of Schlick's form, 2 ∫ (f0 + (f90 − f0)(1 − μ)⁵) μ dμ.
FN vec3 meanFresnel(vec3 f0, float f90) { return f0 + (f90 - f0) / 21.0f; }
