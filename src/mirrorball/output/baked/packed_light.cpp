#include "mirrorball/output/baked/packed_light.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/parallel.h"
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

/// An image of light as bytes.
///
/// place    where each texel goes
Image8 encodedAt(const SquareSymmetry& place, const Image& light, const LightCode& code) {
  Image8 codes = Image8::withoutValues(light.width(), light.height(), 4);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const glm::vec3 texel = glm::max(rgbAt(light, x, y), 0.0f);
      const float max = std::max({texel.x, texel.y, texel.z, code.brightest});
      const glm::ivec2 to = place.from({x, y}, light.width());
      code.encode(texel * (code.brightest / max), codes.texel(to.x, to.y));
    }
  return codes;
}

}  // namespace

LightCode rgbd() { return {kBrightestRgbd, encodeRgbd}; }

LightCode rgbp() { return {kBrightestRgbp, encodeRgbp}; }

Image8 encoded(const Image& light, const LightCode& code) { return encodedAt({}, light, code); }

Result<Bytes> encodedPng(const Image& light, const LightCode& code) {
  return encodePicture(ImageFormatId::png, encoded(light, code), {});
}

Result<std::vector<Bytes>> encodedCube(const ImageSet& cube, const CubeArrangement& arrangement, const LightCode& code,
                                       const ProgressFunction& progress) {
  const auto count = static_cast<std::size_t>(cube.levels()) * 6;
  std::vector<Result<Bytes>> pngs(count, Bytes());
  ProgressCounter counter(progress, count);
  counter.advance(0);
  parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !counter.stopped(); ++i) {
      const FaceFrame& frame = arrangement.slots[i % 6];
      const Image& face = cube.at(static_cast<int>(i / 6), static_cast<int>(frame.centre));
      pngs[i] = encodePicture(ImageFormatId::png, encodedAt(faceFromImage(frame), face, code), {});
      counter.advance();
    }
  });
  MIRRORBALL_TRY_VOID(counter.result());
  std::vector<Bytes> whole;
  for (Result<Bytes>& png : pngs) {
    if (!png) return tl::unexpected<Error>(png.error());
    whole.push_back(std::move(*png));
  }
  return whole;
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
