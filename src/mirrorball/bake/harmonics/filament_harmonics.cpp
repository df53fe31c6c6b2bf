#include "mirrorball/bake/harmonics/filament_harmonics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "formula/constants.h"
#include "formula/prefilter.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr std::size_t kCount = std::tuple_size_v<FilamentHarmonics>;

/// Filament's polynomials: the harmonics of our axes without their factors.
std::array<float, kCount> polynomialsAt(glm::vec3 n) {
  return {1.0f, n.y, n.z, n.x, n.y * n.x, n.y * n.z, 3.0f * n.z * n.z - 1.0f, n.z * n.x, n.x * n.x - n.y * n.y};
}

/// What each is to be multiplied by to be that harmonic.
std::array<float, kCount> factors() {
  const glm::vec3 anywhere(0.48f, 0.6f, 0.64f);
  const std::array<float, kCount> polynomials = polynomialsAt(anywhere);
  std::array<float, kCount> factors;
  for (std::size_t i = 0; i < kCount; ++i)
    factors[i] = formula::harmonic(static_cast<int>(i), anywhere) / polynomials[i];
  return factors;
}

FilamentHarmonics blurred(FilamentHarmonics harmonics, float t) {
  constexpr std::array<int, kCount> kBands{0, 1, 1, 1, 2, 2, 2, 2, 2};
  for (std::size_t i = 0; i < kCount; ++i)
    harmonics[i] *= std::exp(-t * static_cast<float>(kBands[i] * (kBands[i] + 1)));
  return harmonics;
}

/// Whether no channel is below 0, seen every four degrees: so smooth a function falls by less than a thousandth of
/// itself between there.
bool isNowhereNegative(const FilamentHarmonics& harmonics) {
  constexpr int kRings = 45;
  for (int ring = 0; ring < kRings; ++ring)
    for (int place = 0; place < 2 * kRings; ++place) {
      const float theta = (static_cast<float>(ring) + 0.5f) * formula::kPi / kRings;
      const float phi = static_cast<float>(place) * formula::kPi / kRings;
      const glm::vec3 normal(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      const glm::vec3 light = irradianceOverPi(harmonics, normal);
      if (std::min({light.x, light.y, light.z}) < 0.0f) return false;
    }
  return true;
}

}  // namespace

FilamentHarmonics filamentHarmonics(const Harmonics& radiance) {
  assert(radiance.size() >= kCount);
  const Harmonics irradiance = irradianceOf(radiance);
  const std::array<float, kCount> factor = factors();
  FilamentHarmonics harmonics;
  for (std::size_t i = 0; i < kCount; ++i) harmonics[i] = irradiance[i] * factor[i] / formula::kPi;
  if (isNowhereNegative(harmonics)) return harmonics;
  // Light from one direction alone needs t = 0.094, and all other light is a sum of such.
  float too_little = 0.0f;
  float enough = 0.1f;
  constexpr int kHalvings = 14;
  for (int i = 0; i < kHalvings; ++i) {
    const float t = 0.5f * (too_little + enough);
    (isNowhereNegative(blurred(harmonics, t)) ? enough : too_little) = t;
  }
  return blurred(harmonics, enough);
}

glm::vec3 irradianceOverPi(const FilamentHarmonics& harmonics, glm::vec3 normal) {
  const std::array<float, kCount> polynomials = polynomialsAt(normal);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < kCount; ++i) sum += harmonics[i] * polynomials[i];
  return sum;
}

std::string textOf(const FilamentHarmonics& harmonics) {
  std::string text;
  for (const glm::vec3& row : harmonics)
    for (int channel = 0; channel < 3; ++channel) {
      std::array<char, 24> number;
      std::snprintf(number.data(), number.size(), "%.9g", static_cast<double>(row[channel]));
      text += (text.empty() ? "" : " ") + std::string(number.data());
    }
  return text;
}

std::optional<FilamentHarmonics> filamentHarmonicsIn(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), '\n', ' ');
  FilamentHarmonics harmonics;
  std::size_t count = 0;
  for (const std::string& word : split(spaced, ' ')) {
    if (word.empty()) continue;
    const auto number = parseNumber(word);
    if (!number || count == 3 * kCount) return {};
    harmonics[count / 3][static_cast<int>(count % 3)] = static_cast<float>(*number);
    ++count;
  }
  if (count != 3 * kCount) return {};
  return harmonics;
}

}  // namespace mirrorball
