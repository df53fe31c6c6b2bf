#include "mirrorball/render/surface/wavelength_sets.h"

#include <algorithm>
#include <array>
#include <set>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball {
namespace {

FrameSettings spectral(int wavelengths) {
  FrameSettings settings;
  settings.dispersion = DispersionKind::spectral;
  settings.wavelengths = wavelengths;
  return settings;
}

// What does not disperse shows the sum of the shares, in 8 bits as in radiance.
TEST(WavelengthSets, EachIsWhite) {
  for (const int count : {8, 12, 16})
    for (int sample = 0; sample < 40; ++sample) {
      const auto sets = wavelengthSets(spectral(count), sample);
      ASSERT_EQ(sets.size(), std::size_t(formula::kWavelengthSets * count));
      for (int number = 0; number < formula::kWavelengthSets; ++number) {
        glm::vec3 sum(0.0f);
        for (int i = 0; i < count; ++i) sum += glm::vec3(sets[std::size_t(number * count + i)]);
        for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(sum[channel], 1.0f, 1e-6f);
      }
    }
}

// The mean of an index over a channel is that of the whole spectrum, from a single set on: a set holds all colours.
TEST(WavelengthSets, EachStandsForTheSpectrum) {
  const auto mean = [](auto begin, auto end) {
    glm::vec3 sum(0.0f);
    for (auto light = begin; light != end; ++light) sum += glm::vec3(*light) * light->w;
    return sum;
  };
  glm::vec3 truth(0.0f);
  constexpr int kMany = 4096;
  for (int i = 0; i < kMany; ++i) {
    const float wavelength = formula::sampleWavelength((float(i) + 0.5f) / kMany);
    truth += formula::shareOfWavelength(wavelength) * wavelength / float(kMany);
  }
  const auto sets = wavelengthSets(spectral(12), 0);
  glm::vec3 of_all(0.0f);
  for (std::size_t begin = 0; begin < sets.size(); begin += 12) {
    const glm::vec3 of_set = mean(sets.begin() + std::ptrdiff_t(begin), sets.begin() + std::ptrdiff_t(begin + 12));
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(of_set[channel], truth[channel], 4e-3f) << "µm";
    of_all += of_set / float(formula::kWavelengthSets);
  }
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(of_all[channel], truth[channel], 2e-4f) << "µm";
}

// No colour bands: over the sets and a few samples, wavelengths lie as close as if they were all of one set.
TEST(WavelengthSets, TogetherTheyLeaveNoGap) {
  std::set<float> seen;
  constexpr int kSamples = 8;
  for (int sample = 0; sample < kSamples; ++sample)
    for (const glm::vec4& light : wavelengthSets(spectral(12), sample)) seen.insert(light.w);
  EXPECT_GT(seen.size(), 12u * formula::kWavelengthSets * kSamples * 9 / 10);
  float widest = 0.0f;
  for (auto light = seen.lower_bound(0.43f); *light < 0.68f; ++light)
    widest = std::max(widest, *std::next(light) - *light);
  EXPECT_LT(widest, 1.2e-3f) << "µm; 48 wavelengths in four samples would be 8e-3 apart";
}

// Pixels side by side have sets whose wavelengths are a quarter of a part apart or more, and 16 pixels have all sets.
TEST(WavelengthSets, NeighboursHaveOtherOnes) {
  std::set<int> sets;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const int set = formula::wavelengthSetOfPixel(x + 8, y + 4);
      sets.insert(set);
      const int apart = std::abs(set - formula::wavelengthSetOfPixel(x + 9, y + 4));
      EXPECT_GE(std::min(apart, formula::kWavelengthSets - apart), formula::kWavelengthSets / 4);
    }
  EXPECT_EQ(sets.size(), std::size_t(formula::kWavelengthSets));
}

TEST(WavelengthSets, OneWavelengthIsAllLight) {
  FrameSettings settings = spectral(12);
  settings.wavelength_nm = 486.13f;
  for (const glm::vec4& light : wavelengthSets(settings, 3)) EXPECT_EQ(light, glm::vec4(1.0f, 1.0f, 1.0f, 0.48613f));
  EXPECT_EQ(lightKindsOf(settings), 1);
  settings.wavelength_nm = 0.0f;
  EXPECT_EQ(lightKindsOf(settings), 12);
  settings.dispersion = DispersionKind::channels;
  EXPECT_EQ(lightKindsOf(settings), 3);
}

}  // namespace
}  // namespace mirrorball
