// What a rough surface sees around its mirror direction: an environment blurred in one of three ways.
// Needs: microfacet, mip_mapping, reflection_lobe, tangent.

struct Blur {
  int kind;                 // 0 prefiltered, 1 a mip level, 2 many rays in a cone
  float first_level;        // of the prefiltered chain: the texture's level 0
  float last_level;         // of the prefiltered chain: that of roughness 1
  float texels_per_radian;  // of the environment, in the middle of a face
};

// The perceptual roughness whose lobe is about as wide as one of these, seen over a patch of directions: variances add
// up (Kaplanyan et al. 2016, "Filtering distributions of normals for shading antialiasing"). A square patch of φ² sr
// has φ²/12 along each of its sides, its half vectors' slopes φ²/48. GGX has no variance, but the median of its slopes
// is α; that of normally distributed ones with the variance v is sqrt(2 ln 2 v).
FN float roughnessOverPatch(float perceptual_roughness, float patch_sr) {
  float alpha = perceptual_roughness * perceptual_roughness;
  return min(sqrt(sqrt(alpha * alpha + 0.0288811f * patch_sr)), 1.0f);
}

// A chain of bake/prefilter/prefilter.h, by a lobe that is at least as wide as that of its first level.
FN vec4 chainLight(Blur blur, CUBE_SAMPLER prefiltered, vec3 d, float perceptual_roughness, float minified) {
  // A texel's own width is in the chain.
  float patch_sr = (exp2(2.0f * minified) - 1.0f) / (blur.texels_per_radian * blur.texels_per_radian);
  float widened = lodOfRoughness(roughnessOverPatch(perceptual_roughness, patch_sr), blur.last_level);
  return sampleLod(prefiltered, d, max(widened, 1.0f) - blur.first_level);
}

// The same by any lobe. For the mirror's level 0 the environment itself stands in, with as many mip
// levels as a pixel's footprint asks for; the others' lobes are much wider than their texels, and are widened by it.
FN vec4 prefilteredLight(Blur blur, CUBE_SAMPLER environment, CUBE_SAMPLER prefiltered, vec3 d,
                         float perceptual_roughness, float minified) {
  float lod = lodOfRoughness(perceptual_roughness, blur.last_level);
  vec4 smooth_light = vec4(0.0f);
  if (lod < 1.0f) smooth_light = sampleLod(environment, d, minified);
  if (lod <= 0.0f) return smooth_light;
  return mix(smooth_light, chainLight(blur, prefiltered, d, perceptual_roughness, minified), min(lod, 1.0f));
}

// Point i of n of GGX's reflected lobe about +Z for n = v = r, at even shares of what the half vector's density sends
// (Walter et al. 2007, eq. 35), turned by the golden angle from one to the next.
FN vec3 coneRay(float alpha, int i, int n) {
  float share = (float(i) + 0.5f) / float(n);
  float s = alpha * alpha * share / (1.0f - (1.0f - alpha * alpha) * share);  // sin² of the half vector's angle
  float cosine = 1.0f - 2.0f * s;
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  float turn = 2.39996323f * float(i);
  return vec3(sine * cos(turn), sine * sin(turn), cosine);
}

// The mean of 64 rays: what prefiltering is spared for. Few enough rays show as copies of each lamp.
FN vec4 coneLight(CUBE_SAMPLER environment, vec3 d, float perceptual_roughness, float minified) {
  float alpha = alphaFromPerceptualRoughness(perceptual_roughness);
  vec3 t = anyTangent(d);
  vec3 b = cross(d, t);
  vec4 sum = vec4(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < 64; ++i) {
    vec3 ray = coneRay(alpha, i, 64);
    if (ray.z <= 0.0f) continue;
    sum += sampleLod(environment, t * ray.x + b * ray.y + d * ray.z, minified) * ray.z;
    weights += ray.z;
  }
  return sum / weights;
}

// minified   the mip level that a pixel's footprint asks for in the environment
FN vec4 blurredLight(Blur blur, CUBE_SAMPLER environment, CUBE_SAMPLER prefiltered, vec3 d,
                     float perceptual_roughness, float minified) {
  if (blur.kind == 1)
    return sampleLod(environment, d, max(lodOfLobe(perceptual_roughness, blur.texels_per_radian, d), minified));
  if (blur.kind == 2) return coneLight(environment, d, perceptual_roughness, minified);
  return prefilteredLight(blur, environment, prefiltered, d, perceptual_roughness, minified);
}
