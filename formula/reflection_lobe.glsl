// How much light a rough surface reflects from each direction towards an eye that looks along the normal: what a
// prefiltered environment map holds. With the eye, the normal and the mirror direction in one (n = v = r) every lobe is
// symmetric about them; it is a function of
//   s = sin²(θ/2) = (1 − cos θ) / 2 = |l − n|² / 4,  θ the angle between the light l and the mirror direction n,
// which is also sin² of the half vector's angle, and exact for small angles where cos θ is not. Each lobe is D(h) (n·l)₊,
// Phong's excepted, scaled to be at most 1; whoever uses it divides by its integral.

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

// D(h) ∝ (sin θ_h)^(1/α): the fibres of cloth, which reflect most at grazing angles (Estevez & Kulla 2017, eq. 2). Below
// the horizon there is nothing, so 2 s is at most 1.
FN float charlieLobe(float alpha, float s) { return pow(min(2.0f * s, 1.0f), 0.5f / alpha) * cosineOfLobe(s); }

// The exponent for which Blinn's lobe is as wide as GGX's (Walter et al. 2007, p. 8).
FN float blinnExponent(float alpha) { return 2.0f / (alpha * alpha) - 2.0f; }

// The exponent of the Phong lobe that is as wide as a GGX lobe: a quarter of Blinn's for the half vector, since the
// reflected ray turns twice as fast. At least 1.
FN float phongExponent(float alpha) { return max(blinnExponent(alpha) / 4.0f, 1.0f); }
