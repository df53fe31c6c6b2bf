// Rough surfaces. alpha = perceptual_roughness² is the width of the lobe (Burley 2012).

FN float alphaFromPerceptualRoughness(float perceptual_roughness) {
  return perceptual_roughness * perceptual_roughness;
}

// The roughness of a surface whose facets are also spread by bumps that are too small to be seen: GGX's α² is twice the
// variance of Beckmann's slopes, and variances add (Olano & Baker 2010, "LEAN mapping").
//   variance   of the bumps' slopes along one direction
FN float widenedRoughness(float perceptual_roughness, float variance) {
  if (variance <= 0.0f) return perceptual_roughness;
  float alpha = alphaFromPerceptualRoughness(perceptual_roughness);
  return sqrt(min(sqrt(alpha * alpha + 2.0f * variance), 1.0f));
}

// Multiple scattering: the share of white light that leaves a rough surface after two or more bounces between its
// facets (Fdez-Agüera 2019, "A multiple-scattering microfacet model for real-time image-based lighting", eqs. 9 to 12).
// Of the missing share, which does not leave at a bounce, the next facet reflects the mean share F. Of that the part
// single_scattering / F leaves, and so on. This is a geometric series. For facets that reflect everything it adds up to
// exactly what single scattering leaves missing.
//   single_scattering  what leaves after one bounce
//   mean_fresnel       the facets' reflectance, averaged over the cosine-weighted hemisphere
//   missing            1 − scale − bias: the share that facets with reflectance 1 do not send away at the first bounce
FN vec3 multipleScattering(vec3 single_scattering, vec3 mean_fresnel, float missing) {
  vec3 again = mean_fresnel * missing;
  return single_scattering * again / (1.0f - again);
}

// The cosine-weighted mean of a reflectance, 2 ∫ F(μ) μ dμ, from its values at three cosines: Gauss and Jacobi's rule,
// exact for polynomials up to μ⁵, of which Schlick's form is one. For Fresnel's equations it is within 0.002, but where
// part of the light is totally reflected.
const vec3 kMeanFresnelCosines = vec3(0.21234054f, 0.59053314f, 0.91141204f);
const vec3 kMeanFresnelWeights = vec3(0.13965396f, 0.45848221f, 0.40186383f);
