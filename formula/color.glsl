// Colour: sRGB's transfer curve, luminance, and the curves that bring scene light to a display.
// Radiance is linear Rec.709. A tone map takes and gives linear light; its result lies in [0, 1] and is then encoded
// with srgbFromLinear.

// IEC 61966-2-1. The piecewise form, so that black and white are exact.
FN float linearFromSrgb1(float encoded) {
  if (encoded <= 0.04045f) return encoded / 12.92f;
  return pow((encoded + 0.055f) / 1.055f, 2.4f);
}

FN float srgbFromLinear1(float light) {
  if (light <= 0.0031308f) return 12.92f * light;
  return 1.055f * pow(light, 1.0f / 2.4f) - 0.055f;
}

FN vec3 linearFromSrgb(vec3 encoded) {
  return vec3(linearFromSrgb1(encoded.x), linearFromSrgb1(encoded.y), linearFromSrgb1(encoded.z));
}

FN vec3 srgbFromLinear(vec3 light) {
  return vec3(srgbFromLinear1(light.x), srgbFromLinear1(light.y), srgbFromLinear1(light.z));
}

// Rec.709 luminance.
FN float luminance(vec3 light) { return dot(light, vec3(0.2126f, 0.7152f, 0.0722f)); }

FN vec3 rec709FromXyz(vec3 xyz) {
  return vec3(3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
              -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
              0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z);
}

FN vec3 toneMapLinear(vec3 light) { return clamp(light, 0.0f, 1.0f); }

// x / (1 + x), by luminance so that hues stay (Reinhard et al. 2002, eq. 3).
FN vec3 toneMapReinhard(vec3 light) {
  return clamp(light / (1.0f + max(luminance(light), 0.0f)), 0.0f, 1.0f);
}

// Stephen Hill's fit of the ACES reference rendering transform and sRGB output transform (2016).
FN vec3 toneMapAces(vec3 light) {
  vec3 v = vec3(0.59719f * light.x + 0.35458f * light.y + 0.04823f * light.z,
                0.07600f * light.x + 0.90834f * light.y + 0.01566f * light.z,
                0.02840f * light.x + 0.13383f * light.y + 0.83777f * light.z);
  vec3 a = v * (v + 0.0245786f) - 0.000090537f;
  vec3 b = v * (0.983729f * v + 0.4329510f) + 0.238081f;
  vec3 c = a / b;
  return clamp(vec3(1.60475f * c.x - 0.53108f * c.y - 0.07367f * c.z,
                    -0.10208f * c.x + 1.10813f * c.y - 0.00605f * c.z,
                    -0.00327f * c.x - 0.07276f * c.y + 1.07602f * c.z),
               0.0f, 1.0f);
}

// Khronos PBR Neutral (2024): colours below 0.8 stay as they are but for the 4 % of a dielectric's reflection, brighter
// ones are compressed to 1 and slowly lose their saturation.
FN vec3 toneMapNeutral(vec3 light) {
  const float start = 0.8f - 0.04f;
  const float desaturation = 0.15f;
  float darkest = min(light.x, min(light.y, light.z));
  float offset = darkest < 0.08f ? darkest - 6.25f * darkest * darkest : 0.04f;
  vec3 color = light - offset;
  float peak = max(color.x, max(color.y, color.z));
  if (peak < start) return clamp(color, 0.0f, 1.0f);
  const float room = 1.0f - start;
  float new_peak = 1.0f - room * room / (peak + room - start);
  color = color * (new_peak / peak);
  float grey = 1.0f - 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  return clamp(mix(color, vec3(new_peak), grey), 0.0f, 1.0f);
}

// The sigmoid of AgX as a polynomial over the encoded range (Benjamin Wrensch's fit, 2023).
FN float agxContrast(float x) {
  float x2 = x * x;
  float x4 = x2 * x2;
  return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 + 0.1191f * x - 0.00232f;
}

FN float agxEncoded(float light) {
  const float min_stops = -12.47393f;  // stops below and above 1 that the curve spans
  const float max_stops = 4.026069f;
  float stops = log2(max(light, 1e-10f));
  return (clamp(stops, min_stops, max_stops) - min_stops) / (max_stops - min_stops);
}

// AgX (Troy Sobotka 2022), base look, Rec.709 in and out: inset, logarithm, sigmoid, outset; the result is encoded for
// a display of gamma 2.2 and is linearised again here.
FN vec3 toneMapAgx(vec3 light) {
  vec3 inset = vec3(0.842479062253094f * light.x + 0.0784335999999992f * light.y + 0.0792237451477643f * light.z,
                    0.0423282422610123f * light.x + 0.878468636469772f * light.y + 0.0791661274605434f * light.z,
                    0.0423756549057051f * light.x + 0.0784336f * light.y + 0.879142973793104f * light.z);
  vec3 c = vec3(agxContrast(agxEncoded(inset.x)), agxContrast(agxEncoded(inset.y)), agxContrast(agxEncoded(inset.z)));
  vec3 outset = vec3(1.19687900512017f * c.x - 0.0980208811401368f * c.y - 0.0990297440797205f * c.z,
                     -0.0528968517574562f * c.x + 1.15190312990417f * c.y - 0.0989611768448433f * c.z,
                     -0.0529716355144438f * c.x - 0.0980434501171241f * c.y + 1.15107367264116f * c.z);
  return pow(clamp(outset, 0.0f, 1.0f), vec3(2.2f));
}

// The tone map by its number: 0 AgX, 1 ACES, 2 neutral, 3 Reinhard, 4 linear.
FN vec3 toneMap(int curve, vec3 light) {
  if (curve == 0) return toneMapAgx(light);
  if (curve == 1) return toneMapAces(light);
  if (curve == 2) return toneMapNeutral(light);
  if (curve == 3) return toneMapReinhard(light);
  return toneMapLinear(light);
}

// Radiance → what a display sends of it: linear light in [0, 1]; both with premultiplied alpha. The tone map takes the
// light of the covered part alone, so that half of a lamp is half of the lamp's light and not all of a dimmer lamp's.
//   exposure     factor on the radiance, 2^EV
FN vec4 displayLight(vec4 radiance, float exposure, int curve) {
  if (radiance.w <= 0.0f) return vec4(0.0f, 0.0f, 0.0f, 0.0f);
  // No curve tells 10⁹ from more, and the squares of much more are no floats.
  vec3 light = clamp(vec3(radiance) * (exposure / radiance.w), 0.0f, 1e9f);
  return vec4(toneMap(curve, light) * radiance.w, radiance.w);
}

// Light over a background; all premultiplied, and linear.
FN vec4 laidOver(vec4 light, vec4 background) { return light + background * (1.0f - light.w); }

// A display's light, premultiplied → a picture for it: straight alpha, sRGB-encoded.
FN vec4 encodedPicture(vec4 light) {
  if (light.w <= 0.0f) return vec4(0.0f, 0.0f, 0.0f, 0.0f);
  return vec4(srgbFromLinear(vec3(light) / light.w), light.w);
}

// Radiance with premultiplied alpha → a picture for a display: straight alpha, tone mapped, sRGB-encoded.
FN vec4 displayed(vec4 radiance, float exposure, int curve) {
  return encodedPicture(displayLight(radiance, exposure, curve));
}
