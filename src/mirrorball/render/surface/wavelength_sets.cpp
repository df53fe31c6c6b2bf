#include "mirrorball/render/surface/wavelength_sets.h"

#include <cmath>

#include "formula/color.h"

namespace mirrorball {
namespace {

/// The wavelengths of one set.
///
/// turn     where in its part each lies, in [0, 1)
std::vector<glm::vec4> wavelengthSet(int count, float turn) {
  std::vector<glm::vec4> set;
  glm::vec3 sum(0.0f);
  for (int part = 0; part < count; ++part) {
    const float wavelength = formula::sampleWavelength((static_cast<float>(part) + turn) / static_cast<float>(count));
    const glm::vec3 share = formula::shareOfWavelength(wavelength);
    set.emplace_back(share, wavelength);
    sum += share;
  }
  // What does not disperse stays exactly white.
  for (glm::vec4& light : set) light /= glm::vec4(sum, 1.0f);
  return set;
}

}  // namespace

std::vector<glm::vec4> wavelengthSets(const FrameSettings& settings, int sample) {
  if (settings.wavelength_nm > 0.0f)
    return std::vector<glm::vec4>(formula::kWavelengthSets, glm::vec4(glm::vec3(1.0f), settings.wavelength_nm / 1000));
  // The golden section's multiples fill a gap after the other, however many samples there are.
  const double of_sample = sample * 0.6180339887498949;
  std::vector<glm::vec4> sets;
  for (int number = 0; number < formula::kWavelengthSets; ++number) {
    const double turn = of_sample + double(number) / formula::kWavelengthSets;
    const auto set = wavelengthSet(settings.wavelengths, static_cast<float>(turn - std::floor(turn)));
    sets.insert(sets.end(), set.begin(), set.end());
  }
  return sets;
}

bool isSpectral(const FrameSettings& settings) {
  return settings.dispersion == DispersionKind::spectral || settings.wavelength_nm > 0.0f;
}

int lightKindsOf(const FrameSettings& settings) {
  if (!isSpectral(settings)) return 3;
  return settings.wavelength_nm > 0.0f ? 1 : settings.wavelengths;
}

}  // namespace mirrorball
