#include "mirrorball/codec/ldr/gain_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

constexpr std::size_t kGainRows = 16;  // that a thread takes at a time

/// Whether all three lie within ± limit; NaN does not.
bool areWithin(glm::vec3 numbers, float limit) {
  return std::abs(numbers.x) <= limit && std::abs(numbers.y) <= limit && std::abs(numbers.z) <= limit;
}

/// The codes of a map, as shares, at a place of the picture that it covers.
glm::vec3 sharesAt(const Image8& codes, glm::vec2 uv) {
  const auto fetch = [&](int x, int y) {
    const std::uint8_t* code = codes.texel(std::clamp(x, 0, codes.width() - 1), std::clamp(y, 0, codes.height() - 1));
    const int step = codes.channels() >= 3 ? 1 : 0;
    return glm::vec4(code[0], code[step], code[2 * step], 255.0f) / 255.0f;
  };
  return glm::vec3(bilinear(uv * glm::vec2(codes.width(), codes.height()), fetch));
}

}  // namespace

Result<void> checkGainMap(const GainMap& map) {
  constexpr float kMostGain = 64.0f;
  constexpr float kMostOffset = 1024.0f;
  constexpr float kLargest = 1e6f;
  const auto refuse = [](const char* what) {
    return fail(ErrorCode::bad_file,
                "has a damaged gain map: " + std::string(what) + "; save it anew, or without the gain map");
  };
  if (!areWithin(map.min_log2, kMostGain) || !areWithin(map.max_log2, kMostGain))
    return refuse("its gains are no numbers within 2^-64 and 2^64");
  if (glm::any(glm::greaterThan(map.min_log2, map.max_log2))) return refuse("its least gain is above its greatest");
  if (!areWithin(map.gamma, kLargest) || glm::any(glm::lessThanEqual(map.gamma, glm::vec3(0.0f))))
    return refuse("its gamma is no number above 0");
  if (!areWithin(map.offset_sdr, kMostOffset) || !areWithin(map.offset_hdr, kMostOffset))
    return refuse("its offsets are no numbers within -1024 and 1024");
  if (!areWithin({map.headroom_min_log2, map.headroom_max_log2, 0.0f}, kMostGain))
    return refuse("its headroom is no number within 2^-64 and 2^64");
  return {};
}

namespace {

/// Of the gain maps that are made: measured in docs/conversion.md.
constexpr float kMadeOffset = 1.0f / 1024.0f;
constexpr float kMadeGamma = 0.5f;

/// Web readers take displays to have at most 65504 times white, the greatest half float.
constexpr float kMostHeadroom = 15.0f;

/// The gain that takes a picture's texel to light.
glm::vec3 gainAt(const Image& picture, const Image& light, int x, int y) {
  constexpr float kMostLight = 1e15f;  // far beyond any, and below checkGainMap's limit
  const glm::vec3 wanted(rgbaAt(light, x, y));
  glm::vec3 gain;
  for (int c = 0; c < 3; ++c) {
    const float sample = wanted[c] > 0.0f ? std::min(wanted[c], kMostLight) : 0.0f;  // NaN is not above 0
    gain[c] = std::log2((sample + kMadeOffset) / (rgbaAt(picture, x, y)[c] + kMadeOffset));
  }
  return gain;
}

}  // namespace

MadeGainMap gainMapFor(const Image& picture, const Image& light) {
  const int width = picture.width();
  const std::size_t height = std::size_t(picture.height());
  Image gains = Image::withoutValues(width, picture.height(), 3);
  parallelFor(height, kGainRows, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < width; ++x) {
        const glm::vec3 gain = gainAt(picture, light, x, y);
        std::copy_n(&gain.x, 3, gains.texel(x, y));
      }
  });
  const auto [least, most] = std::minmax_element(gains.samples().begin(), gains.samples().end());
  const float min = *least;
  const float range = *most - min;
  MadeGainMap made{Image8::withoutValues(width, picture.height(), 3),
                   {.min_log2 = glm::vec3(min),
                    .max_log2 = glm::vec3(*most),
                    .gamma = glm::vec3(kMadeGamma),
                    .offset_sdr = glm::vec3(kMadeOffset),
                    .offset_hdr = glm::vec3(kMadeOffset),
                    .headroom_max_log2 = std::clamp(*most, 1.0f, kMostHeadroom)}};
  std::transform(gains.samples().begin(), gains.samples().end(), made.codes.samples().begin(), [&](float gain) {
    const float share = range > 0.0f ? std::pow((gain - min) / range, kMadeGamma) : 0.0f;
    return static_cast<std::uint8_t>(std::lround(255.0f * share));
  });
  return made;
}

Image lightByGainMap(const Image& picture, const Image8& codes, const GainMap& map) {
  const int channels = std::max(picture.channels(), codes.channels());
  const glm::vec2 extent(picture.width(), picture.height());
  Image light = Image::withoutValues(picture.width(), picture.height(), channels);
  parallelFor(std::size_t(picture.height()), kGainRows, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const glm::vec3 shares = glm::pow(sharesAt(codes, (glm::vec2(x, y) + 0.5f) / extent), 1.0f / map.gamma);
        const glm::vec3 gain = glm::exp2(glm::mix(map.min_log2, map.max_log2, shares));
        const glm::vec3 shown(rgbaAt(picture, x, y));
        const glm::vec3 lifted = glm::max((shown + map.offset_sdr) * gain - map.offset_hdr, 0.0f);
        std::copy_n(&lifted.x, channels, light.texel(x, y));
      }
  });
  return light;
}

}  // namespace mirrorball
