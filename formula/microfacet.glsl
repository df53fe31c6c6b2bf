// Rough surfaces. alpha = perceptual_roughness² is the width of the lobe (Burley 2012).

FN float alphaFromPerceptualRoughness(float perceptual_roughness) {
  return perceptual_roughness * perceptual_roughness;
}

// The level of a plain mip chain whose texels are alpha radians wide, about half the width at half maximum of the lobe
// around the mirror direction (1.3 alpha: tan θ = 0.64 alpha for the half vector, twice that for the ray). `last` is the
// level of 4² texels a face, each ½ rad wide, beyond which a cube would show. A larger map has more levels and looks the
// same.
FN float lodOfLobe(float perceptual_roughness, float last) {
  return clamp(last + 1.0f + 2.0f * log2(max(perceptual_roughness, 1e-4f)), 0.0f, last);
}

// Scale and bias of f0 in the light that a GGX surface reflects from a white environment: Brian Karis' fit ("Physically
// based shading on mobile", 2014), good to about 0.02. At roughness 0 the two sum to 1.
FN vec2 environmentBrdf(float perceptual_roughness, float cosine) {
  vec4 r = vec4(-1.0f, -0.0275f, -0.572f, 0.022f) * perceptual_roughness + vec4(1.0f, 0.0425f, 1.04f, -0.04f);
  float bend = min(r.x * r.x, exp2(-9.28f * cosine)) * r.x + r.y;
  return vec2(-1.04f * bend + r.z, 1.04f * bend + r.w);
}
