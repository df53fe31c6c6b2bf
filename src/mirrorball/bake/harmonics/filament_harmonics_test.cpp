#include "mirrorball/bake/harmonics/filament_harmonics.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

LightHarmonics lightOf(const Environment& environment) {
  auto light = LightHarmonics::make(environment, {Lobe::cosine()});
  EXPECT_TRUE(light);
  return std::move(*light);
}

FilamentHarmonics harmonicsOf(const Environment& environment) {
  return filamentHarmonics(radianceHarmonics(lightOf(environment), 2));
}

/// Light of three bands, which differs by channel and direction, and lights no normal with less than 0.
glm::vec3 threeBands(glm::vec3 d) {
  return {1.0f + 0.4f * d.x - 0.3f * d.y * d.z, 0.8f - 0.3f * d.y + 0.2f * (d.x * d.x - d.y * d.y),
          0.6f + 0.2f * d.z * d.z + 0.3f * d.x * d.y - 0.1f * d.z * d.x};
}

/// A lamp in the dark.
Environment lamp() {
  Image map(128, 64, 3, 0.0f);
  for (int y = 10; y < 14; ++y)
    for (int x = 30; x < 36; ++x)
      for (int c = 0; c < 3; ++c) map.texel(x, y)[c] = static_cast<float>(c + 1);
  return Environment(EnvironmentMap(Projection::equirect, ImageSet(std::move(map))));
}

TEST(FilamentHarmonics, WhiteIsOne) {
  const FilamentHarmonics white = harmonicsOf(Environment([](glm::vec3) { return glm::vec3(1.0f); }, 16));
  EXPECT_NEAR(white[0].x, 1.0f, 1e-5f);
  for (std::size_t i = 1; i < white.size(); ++i) EXPECT_NEAR(white[i].y, 0.0f, 1e-4f) << i;
}

// Of light of three bands the cosine lobe leaves no others, so that nothing is lost.
TEST(FilamentHarmonics, ThePolynomialIsTheIrradianceOverPi) {
  const Environment environment(threeBands, 128);
  const LightHarmonics light = lightOf(environment);
  const FilamentHarmonics harmonics = filamentHarmonics(radianceHarmonics(light, 2));
  const EnvironmentMap irradiance = *cubeOf(light, Lobe::cosine(), 16);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const glm::vec3 normal = directionAt(Projection::cube, {face, (glm::vec2(x, y) + 0.5f) / 16.0f});
        const glm::vec3 expected = rgbAt(irradiance.face(face), x, y);
        EXPECT_LT(glm::length(irradianceOverPi(harmonics, normal) - expected), 1e-4f * glm::length(expected));
      }
}

TEST(FilamentHarmonics, RotationTurnsThem) {
  const LightHarmonics light = lightOf(Environment(threeBands, 128));
  const glm::mat3 source_from_target(glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0));
  const FilamentHarmonics ours = filamentHarmonics(radianceHarmonics(light, 2));
  const FilamentHarmonics turned = filamentHarmonics(radianceHarmonics(light, 2, source_from_target));
  for (const glm::vec3 d : testing::manyDirections(50))
    EXPECT_LT(glm::length(irradianceOverPi(turned, d) - irradianceOverPi(ours, source_from_target * d)), 1e-5f);
}

TEST(FilamentHarmonics, ALampLeavesNothingBelowZeroAndItsFluxAsItWas) {
  const Harmonics radiance = radianceHarmonics(lightOf(lamp()), 2);
  const FilamentHarmonics harmonics = filamentHarmonics(radiance);
  const Harmonics irradiance = irradianceOf(radiance);
  // √(1/4π) / π of the first coefficient: the mean of irradiance / π is that of radiance.
  EXPECT_NEAR(harmonics[0].z, irradiance[0].z * 0.0897936f, 1e-6f);
  glm::vec3 min(1.0f);
  for (const glm::vec3 d : testing::manyDirections(5000)) min = glm::min(min, irradianceOverPi(harmonics, d));
  // As little blurred as that takes: the least is 0 but for what lies between the places that are looked at.
  EXPECT_GT(min.z, -1e-3f * harmonics[0].z);
  EXPECT_LT(min.z, 0.01f * harmonics[0].z);
  EXPECT_NEAR(harmonics[0].x / harmonics[0].z, harmonics[3].x / harmonics[3].z, 1e-5f) << "the hue is kept";
}

TEST(FilamentHarmonics, TheTextComesBack) {
  const FilamentHarmonics harmonics = harmonicsOf(Environment(threeBands, 128));
  EXPECT_EQ(filamentHarmonicsIn(textOf(harmonics)), harmonics);
  // cmgen breaks lines.
  std::string lines;
  for (int i = 0; i < 9; ++i) lines += "0.5 -0.25 1e-05\n";
  const auto read = filamentHarmonicsIn(lines);
  ASSERT_TRUE(read);
  EXPECT_EQ((*read)[8], glm::vec3(0.5f, -0.25f, 1e-5f));
  EXPECT_FALSE(filamentHarmonicsIn(""));
  EXPECT_FALSE(filamentHarmonicsIn(lines + "1"));
  EXPECT_FALSE(filamentHarmonicsIn(lines.substr(8)));
  EXPECT_FALSE(filamentHarmonicsIn("light" + lines.substr(3)));
}

}  // namespace
}  // namespace mirrorball
