#include "mirrorball/output/baked/packed_light.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/codec/format_registry.h"

namespace mirrorball {
namespace {

constexpr float kBrightestRgbd = 255.0f;
constexpr float kBrightestRgbp = 64.0f;

std::uint8_t byteOf(float share) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
}

void encodeRgbd(glm::vec3 light, std::uint8_t* code) {
  const float max = std::max({light.x, light.y, light.z, 1.0f});
  const float d = std::max(std::floor(kBrightestRgbd / max), 1.0f);
  for (int c = 0; c < 3; ++c) code[c] = byteOf(std::pow(light[c] * d / 255.0f, 1.0f / 2.2f));
  code[3] = static_cast<std::uint8_t>(d);
}

void encodeRgbp(glm::vec3 light, std::uint8_t* code) {
  const float root = std::sqrt(std::max({light.x, light.y, light.z, 1.0f}));
  // Rounded down, so that no channel is above 1.
  const float a = std::floor(255.0f * (1.0f - (root - 1.0f) / 7.0f)) / 255.0f;
  for (int c = 0; c < 3; ++c) code[c] = byteOf(std::sqrt(light[c]) / (8.0f - 7.0f * a));
  code[3] = byteOf(a);
}

}  // namespace

LightCode rgbd() { return {kBrightestRgbd, encodeRgbd}; }

LightCode rgbp() { return {kBrightestRgbp, encodeRgbp}; }

Image8 encoded(const Image& light, const LightCode& code) {
  Image8 codes = Image8::withoutValues(light.width(), light.height(), 4);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const glm::vec3 texel = glm::max(rgbAt(light, x, y), 0.0f);
      const float max = std::max({texel.x, texel.y, texel.z, code.brightest});
      code.encode(texel * (code.brightest / max), codes.texel(x, y));
    }
  return codes;
}

Result<Bytes> encodedPng(const Image& light, const LightCode& code) {
  return encodePicture(ImageFormatId::png, encoded(light, code), {});
}

LostLight lostLight(const ImageSet& chain, const LightCode& code) {
  LostLight lost;
  for (int face = 0; face < chain.faces(); ++face) {
    Image light = chain.at(0, face);
    lost.add(limitLight(Projection::cube, {.max = code.brightest}, light));
  }
  return lost;
}

}  // namespace mirrorball
