// The sheen of cloth: fibres that stand up from the surface and reflect most at grazing angles (Estevez & Kulla 2017,
// "Production friendly microfacet sheen BRDF"; KHR_materials_sheen). The frame and the names are diffuse.glsl's.
// Needs: constants, microfacet.

// Smoother cloth than this shows nothing but at angles that no picture resolves.
const float kLeastSheenRoughness = 0.07f;

FN float alphaOfSheen(float sheen_roughness) {
  return alphaFromPerceptualRoughness(max(sheen_roughness, kLeastSheenRoughness));
}

// The area of fibres whose normal is h: (2 + 1/α) sin^{1/α} θ_h / 2π (eq. 2).
FN float charlieDistribution(float alpha, vec3 h) {
  float inverse = 1.0f / alpha;
  float sine2 = max(1.0f - h.z * h.z, 0.0f);
  return (2.0f + inverse) * pow(sine2, 0.5f * inverse) / kTwoPi;
}

// The fit of ln Λ between 90° and 60° (eq. 3 and its table), whose five numbers go from those of α = 1 to those of 0.
FN float charlieLambdaFit(float alpha, float cosine) {
  float smoothness = (1.0f - alpha) * (1.0f - alpha);
  float a = mix(21.5473f, 25.3245f, smoothness);
  float b = mix(3.82987f, 3.32435f, smoothness);
  float c = mix(0.19823f, 0.16801f, smoothness);
  float d = mix(-1.97760f, -1.27393f, smoothness);
  float e = mix(-4.32054f, -4.85967f, smoothness);
  return a / (1.0f + b * pow(cosine, c)) + d * cosine + e;
}

// How much area of fibres hides behind others, seen at an angle, for each area seen.
FN float charlieLambda(float alpha, float cosine) {
  float c = clamp(cosine, 0.0f, 1.0f);  // which rounding may have passed
  if (c < 0.5f) return exp(charlieLambdaFit(alpha, c));
  return exp(2.0f * charlieLambdaFit(alpha, 0.5f) - charlieLambdaFit(alpha, 1.0f - c));
}

// White cloth.
FN float evalCharlie(float alpha, vec3 v, vec3 l) {
  if (v.z <= 0.0f || l.z <= 0.0f) return 0.0f;
  float masking = 1.0f / (1.0f + charlieLambda(alpha, v.z) + charlieLambda(alpha, l.z));
  return charlieDistribution(alpha, normalize(v + l)) * masking / (4.0f * v.z * l.z);
}

// Directions from which the light on cloth is gathered: rings about the normal, the first one low, where cloth reflects
// most; in each, steps of equal angles from the side of the eye.
const int kSheenRings = 2;
const int kSheenSpokes = 6;
const float kSheenTapRoughness = 0.75f;  // of a lobe that reaches the next one

struct SheenTap {
  vec3 light;    // in the frame of the surface, unit
  float weight;  // BRDF times cosine times its part of the hemisphere
};

// v    towards the eye, in the frame of the surface
FN SheenTap sheenTap(float alpha, vec3 v, int ring, int spoke) {
  float low = ring == 0 ? 0.0f : 0.4f;  // cosines between which the ring lies
  float high = ring == 0 ? 0.4f : 1.0f;
  float z = (low + high) / 2.0f;
  float across = max(sqrt(v.x * v.x + v.y * v.y), 1e-6f);
  vec2 side = vec2(v.x, v.y) / across;
  float angle = kTwoPi * float(spoke) / float(kSheenSpokes);
  vec2 turned = vec2(side.x * cos(angle) - side.y * sin(angle), side.y * cos(angle) + side.x * sin(angle));
  float sine = sqrt(1.0f - z * z);
  vec3 l = vec3(sine * turned.x, sine * turned.y, z);
  return MAKE(SheenTap)(l, evalCharlie(alpha, v, l) * z * (high - low));
}
