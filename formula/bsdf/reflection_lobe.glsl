// How much light a rough surface reflects from each direction towards an eye that looks along the normal: what a
// prefiltered environment map holds. With the eye, the normal and the mirror direction in one (n = v = r) every lobe is
// symmetric about them; it is a function of
//   s = sin²(θ/2) = (1 − cos θ) / 2 = |l − n|² / 4,  θ the angle between the light l and the mirror direction n,
// which is also sin² of the half vector's angle, and exact for small angles where cos θ is not. Each lobe is D(h)
// (n·l)₊, Phong's excepted, scaled to be at most 1; whoever uses it divides by its integral.

FN float cosineOfLobe(float s) { return max(1.0f - 2.0f * s, 0.0f); }

// D(h) = α² / π ((n·h)² (α² − 1) + 1)² (Walter et al. 2007, eq. 33), where (n·h)² = 1 − s.
FN float ggxLobe(float alpha, float s) {
  float a2 = alpha * alpha;
  float q = a2 / (a2 + (1.0f - a2) * s);
  return q * q * cosineOfLobe(s);
}

// ln(1 − x) for x in [0, 1), also where 1 − x would round x away: high powers of 1 − x need its digits.
FN float logOfOneMinus(float x) {
  if (x < 0.03125f) return -x * (1.0f + x * (0.5f + x * (1.0f / 3.0f + x * (0.25f + 0.2f * x))));
  return log(1.0f - x);
}

// D(h) ∝ (n·h)^p (Blinn 1977).
FN float blinnLobe(float exponent, float s) {
  return exp(0.5f * exponent * logOfOneMinus(min(s, 0.5f))) * cosineOfLobe(s);
}

// (r·l)^p (Phong 1975): a lobe about the mirror direction itself, without the cosine of the light.
FN float phongLobe(float exponent, float s) { return s < 0.5f ? exp(exponent * logOfOneMinus(2.0f * s)) : 0.0f; }

// D(h) ∝ (sin θ_h)^(1/α): the fibres of cloth, which reflect most at grazing angles (Estevez & Kulla 2017, eq. 2).
// Below the horizon there is nothing, so 2 s is at most 1.
FN float charlieLobe(float alpha, float s) { return pow(min(2.0f * s, 1.0f), 0.5f / alpha) * cosineOfLobe(s); }

// The exponent for which Blinn's lobe is as wide as GGX's (Walter et al. 2007, p. 8).
FN float blinnExponent(float alpha) { return 2.0f / (alpha * alpha) - 2.0f; }

// The exponent of the Phong lobe that is as wide as a GGX lobe: a quarter of Blinn's for the half vector, since the
// reflected ray turns twice as fast. At least 1.
FN float phongExponent(float alpha) { return max(blinnExponent(alpha) / 4.0f, 1.0f); }

// The angle about the mirror direction within which the GGX lobe has half of its weight [rad]: 2 r² for a smooth
// surface, 45° for r = 1. Integrated over directions, 4π ds, the lobe is up to a factor
//   W(s) = (1 + a²) (1/a² − 1/q) − 2 ln(q / a²),  a = r², q = a² + (1 − a²) s,
// and W(s) = W(½) / 2 has no closed form. The fit s = a² / (1 + r³ (4.45 + 1.38 a)) gives the angle within 0.7 %.
FN float ggxHalfAngle(float perceptual_roughness) {
  float r = perceptual_roughness;
  float a = r * r;
  return 2.0f * atan(a / sqrt(1.0f + r * a * (4.45f + 1.38f * a) - a * a));  // tan² = s / (1 − s)
}

// The width of a mip level's texels, in texels of level 0. A level has half of the side of the one before, rounded
// down: below a side that is no power of two its texels are wider than 2^level.
FN float mipTexelWidth(int side, int level) { return float(side) / float(max(side >> level, 1)); }

// The level of a plain mip chain of a cube that has half of its weight within the same angle as the lobe. A texel is a
// mean over a square, and between texels and levels the hardware interpolates linearly; over all places within a texel
// that is a square convolved with a tent twice as wide, of which half lies within 0.608 texels. Texels are narrower
// away from a face's middle: their solid angle goes with the cube of the direction's longest component.
//   texels_per_radian  of level 0 in the middle of a face: half of its side
//   direction          unit
FN float lodOfLobe(float perceptual_roughness, float texels_per_radian, vec3 direction) {
  float longest = max(abs(direction.x), max(abs(direction.y), abs(direction.z)));
  float texels = ggxHalfAngle(perceptual_roughness) / 0.608f * texels_per_radian * pow(longest, -1.5f);
  if (texels <= 1.0f) return 0.0f;
  int side = int(2.0f * texels_per_radian + 0.5f);
  int level = int(log2(texels));
  if (mipTexelWidth(side, level) > texels) level -= 1;
  float width = mipTexelWidth(side, level);
  float next = mipTexelWidth(side, level + 1);
  if (next <= width) return float(level);  // the last level: one texel
  return float(level) + log2(texels / width) / log2(next / width);
}
