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

// Of the light that has met two facets or more, the share that meets another one, over what is missing after one. Who
// has left a facet is higher than who comes from above, and so escapes more often. Fitted to random walks between the
// facets (trace/microsurface.h) at roughness 1 along the normal, where such light is most; elsewhere it is off by at
// most 0.01 of all light (the test MultipleScattering).
const float kKeptOfMissing = 0.72f;

// Multiple scattering: the share of white light that leaves a rough surface after two or more bounces between its
// facets. Of what the first facets reflect, the missing share meets a second one, which reflects the mean share F. Of
// that the part e leaves, and of the rest the same. This is a geometric series, as in Fdez-Agüera 2019 ("A multiple-
// scattering microfacet model for real-time image-based lighting", eqs. 9 to 12), whose e is 1 − missing: too small,
// so that grey metal of roughness 1 lost a seventh of its light. For facets that reflect everything it adds up to
// exactly what single scattering leaves missing.
//   first_fresnel      the reflectance of those that such light meets first
//   mean_fresnel       that of facets, averaged over the cosine-weighted hemisphere
//   missing            1 − scale − bias: the share that facets with reflectance 1 do not send away at the first bounce;
//                      below 1
FN vec3 multipleScattering(vec3 first_fresnel, vec3 mean_fresnel, float missing) {
  float kept = kKeptOfMissing * missing;
  return first_fresnel * mean_fresnel * (missing * (1.0f - kept)) / (vec3(1.0f) - mean_fresnel * kept);
}

// Of that light, the fraction that leaves evenly to all sides. The rest leaves around the mirror direction: where the
// eye grazes a surface of small roughness, a facet that turns light down meets another one a little farther on, which
// turns it up again, so that it goes on nearly as it came. Fitted to random walks between the facets (the test
// MultipleScattering), within 0.12 wherever such light is more than a thirtieth of all: the fraction by which the
// horizontal part of the directions that it leaves in is shorter than after one bounce.
//   cosine   n·v
FN float evenFraction(float perceptual_roughness, float cosine) {
  return mix(smoothstep(0.0f, 1.0f, perceptual_roughness), 1.0f, cosine * cosine);
}

// The same beside a row of round lobes (lobe_row.glsl). Four narrow lobes lack a part of GGX's tail, which even light
// makes up for: of random walks between the facets, what differs from the row is even by as much as the light that is
// missing after one bounce, from a roughness of 0.3 on, and by less for smoother surfaces.
FN float evenFractionBesideRow(float perceptual_roughness, float cosine) {
  return min(smoothstep(0.12f, 0.35f, perceptual_roughness) + 2.4f * cosine, 1.0f);
}

// The cosine-weighted mean of a reflectance, 2 ∫ F(μ) μ dμ, from its values at three cosines: Gauss and Jacobi's rule,
// exact for polynomials up to μ⁵, of which Schlick's form is one. For Fresnel's equations it is within 0.002, but where
// part of the light is totally reflected.
const vec3 kMeanFresnelCosines = vec3(0.21234054f, 0.59053314f, 0.91141204f);
const vec3 kMeanFresnelWeights = vec3(0.13965396f, 0.45848221f, 0.40186383f);
