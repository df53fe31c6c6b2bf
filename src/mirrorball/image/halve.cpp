#include "mirrorball/image/halve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "formula/color.h"

namespace mirrorball {
namespace {

/// Light is averaged as whole numbers up to this: fine enough that every 8-bit value comes back as itself.
constexpr int kWhite = 16383;

/// Encoded 8-bit values to light in steps of 1 / kWhite, and back.
struct SrgbTables {
  std::array<int, 256> light;
  std::array<std::uint8_t, kWhite + 1> encoded;

  SrgbTables() {
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = static_cast<int>(std::lround(formula::linearFromSrgb1(static_cast<float>(i) / 255.0f) * kWhite));
    for (std::size_t i = 0; i < encoded.size(); ++i)
      encoded[i] = static_cast<std::uint8_t>(
          std::lround(formula::srgbFromLinear1(static_cast<float>(i) / static_cast<float>(kWhite)) * 255.0f));
  }
};

const SrgbTables& tables() {
  static const SrgbTables made;
  return made;
}

/// Writes one texel from the four at a, b, c, d.
void averageTexel(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, const std::uint8_t* d, bool srgb,
                  std::uint8_t* mean) {
  for (int channel = 0; channel < 4; ++channel) {
    if (srgb && channel < 3) {
      const SrgbTables& table = tables();
      const int sum =
          table.light[a[channel]] + table.light[b[channel]] + table.light[c[channel]] + table.light[d[channel]];
      mean[channel] = table.encoded[static_cast<std::size_t>((sum + 2) / 4)];
    } else {
      mean[channel] = static_cast<std::uint8_t>((a[channel] + b[channel] + c[channel] + d[channel] + 2) / 4);
    }
  }
}

/// Writes each texel of half the size: average(a, b, c, d, mean) from the four that it covers.
template <typename Texels, typename Average>
Texels halvedBy(const Texels& image, const Average& average) {
  assert(image.width() > 1 || image.height() > 1);
  Texels half(std::max(image.width() / 2, 1), std::max(image.height() / 2, 1), image.channels());
  for (int y = 0; y < half.height(); ++y) {
    const int upper = 2 * y;
    const int lower = std::min(upper + 1, image.height() - 1);
    for (int x = 0; x < half.width(); ++x) {
      const int left = 2 * x;
      const int right = std::min(left + 1, image.width() - 1);
      average(image.texel(left, upper), image.texel(right, upper), image.texel(left, lower), image.texel(right, lower),
              half.texel(x, y));
    }
  }
  return half;
}

}  // namespace

Image8 halved(const Image8& image, bool srgb) {
  assert(image.channels() == 4);
  return halvedBy(image, [srgb](const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c,
                                const std::uint8_t* d, std::uint8_t* mean) { averageTexel(a, b, c, d, srgb, mean); });
}

Image halved(const Image& image) {
  return halvedBy(image, [&image](const float* a, const float* b, const float* c, const float* d, float* mean) {
    for (int i = 0; i < image.channels(); ++i) mean[i] = 0.25f * (a[i] + b[i] + c[i] + d[i]);
  });
}

}  // namespace mirrorball
