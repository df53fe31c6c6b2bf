#include "mirrorball/image/halve.h"

#include <array>
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

}  // namespace

Image8 halved(const Image8& image, bool srgb) {
  assert(image.channels() == 4);
  return halvedBy<Image8>(
      image, [srgb](const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, const std::uint8_t* d,
                    std::uint8_t* mean) { averageTexel(a, b, c, d, srgb, mean); });
}

Image halved(const Image& image) {
  return halvedBy<Image>(image, [&image](const float* a, const float* b, const float* c, const float* d, float* mean) {
    for (int i = 0; i < image.channels(); ++i) mean[i] = 0.25f * (a[i] + b[i] + c[i] + d[i]);
  });
}

}  // namespace mirrorball
