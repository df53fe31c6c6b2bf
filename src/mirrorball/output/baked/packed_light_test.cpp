#include "mirrorball/output/baked/packed_light.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball {
namespace {

/// Babylon.js, helperFunctions.fx: fromRGBD.
glm::vec3 fromRgbd(const std::uint8_t* code) {
  glm::vec3 light;
  for (int c = 0; c < 3; ++c)
    light[c] = std::pow(static_cast<float>(code[c]) / 255.0f, 2.2f) / (static_cast<float>(code[3]) / 255.0f);
  return light;
}

/// PlayCanvas, decode.js: decodeRGBP.
glm::vec3 fromRgbp(const std::uint8_t* code) {
  glm::vec3 light;
  for (int c = 0; c < 3; ++c) {
    const float root = static_cast<float>(code[c]) / 255.0f * (8.0f - 7.0f * static_cast<float>(code[3]) / 255.0f);
    light[c] = root * root;
  }
  return light;
}

glm::vec3 through(const LightCode& code, glm::vec3 (*decode)(const std::uint8_t*), glm::vec3 light) {
  Image image(1, 1, 3);
  std::copy_n(&light.x, 3, image.texel(0, 0));
  return decode(encoded(image, code).texel(0, 0));
}

/// The largest error of a grey, as a share of it, from one radiance to another.
float worstBetween(float least, float most, const LightCode& code, glm::vec3 (*decode)(const std::uint8_t*)) {
  float worst = 0.0f;
  for (float grey = least; grey <= most; grey *= 1.003f)
    worst = std::max(worst, std::abs(through(code, decode, glm::vec3(grey)).x / grey - 1.0f));
  return worst;
}

TEST(LightCodes, HoldLightToAFewPercent) {
  // Half a step of the encoded number, times the power by which it is decoded; the darker, the coarser.
  EXPECT_LT(worstBetween(0.5f, 255.0f, rgbd(), fromRgbd), 0.012f);
  EXPECT_LT(worstBetween(0.01f, 0.5f, rgbd(), fromRgbd), 0.04f);
  EXPECT_LT(worstBetween(0.5f, 64.0f, rgbp(), fromRgbp), 0.007f);
  EXPECT_LT(worstBetween(0.01f, 0.5f, rgbp(), fromRgbp), 0.045f);
}

TEST(LightCodes, KeepBlackAndColours) {
  EXPECT_EQ(through(rgbd(), fromRgbd, glm::vec3(0.0f)), glm::vec3(0.0f));
  EXPECT_EQ(through(rgbp(), fromRgbp, glm::vec3(-1.0f)), glm::vec3(0.0f)) << "filters leave some below 0";
  const glm::vec3 warm = through(rgbd(), fromRgbd, {90.0f, 45.0f, 9.0f});
  EXPECT_NEAR(warm.y / warm.x, 0.5f, 0.01f);
  EXPECT_NEAR(warm.z / warm.x, 0.1f, 0.004f);
  EXPECT_EQ(through(rgbp(), fromRgbp, {1.0f, 0.0f, 1.0f}), glm::vec3(1.0f, 0.0f, 1.0f));
}

TEST(LightCodes, LowerWhatIsTooBrightAndKeepItsHue) {
  const glm::vec3 sun = through(rgbd(), fromRgbd, {1e5f, 5e4f, 1e4f});
  EXPECT_NEAR(sun.x, 255.0f, 0.01f);
  EXPECT_NEAR(sun.y / sun.x, 0.5f, 0.01f);
  const glm::vec3 lamp = through(rgbp(), fromRgbp, {256.0f, 64.0f, 0.0f});
  EXPECT_NEAR(lamp.x, 64.0f, 0.01f);
  EXPECT_NEAR(lamp.y, 16.0f, 0.2f);
}

TEST(LightCodes, TellWhichShareOfTheLightIsLost) {
  ImageSet cube(1, 6);
  for (int face = 0; face < 6; ++face) cube.at(0, face) = Image(8, 8, 3, 1.0f);
  EXPECT_EQ(lostLight(cube, rgbd()).share(), 0.0);
  for (int c = 0; c < 3; ++c) cube.at(0, 2).texel(3, 3)[c] = 1e5f;
  const double before = lostLight(cube, rgbd()).share();
  EXPECT_GT(before, 0.99);
  EXPECT_EQ(cube.at(0, 2).texel(3, 3)[0], 1e5f) << "asking changes nothing";
  EXPECT_GT(lostLight(cube, rgbp()).share(), before);
}

/// Two levels whose texels all differ.
ImageSet cubeOfNumbers() {
  ImageSet cube(2, 6);
  float number = 0.0f;
  for (int level = 0; level < 2; ++level)
    for (int face = 0; face < 6; ++face) {
      cube.at(level, face) = Image(8 >> level, 8 >> level, 3);
      for (float& sample : cube.at(level, face).samples()) sample = number += 0.1f;
    }
  return cube;
}

TEST(EncodedCube, HasTheImagesOfAnArrangementLevelByLevel) {
  const ImageSet cube = cubeOfNumbers();
  for (const char* program : {"babylon", "unreal"}) {
    const CubeArrangement arrangement = *presetNamed(program)->cube;
    const ImageSet images = arranged(cube, arrangement);
    const auto pngs = encodedCube(cube, arrangement, rgbd());
    ASSERT_TRUE(pngs) << pngs.error().message;
    ASSERT_EQ(pngs->size(), 12u);
    for (int i = 0; i < 12; ++i)
      EXPECT_EQ((*pngs)[std::size_t(i)], *encodedPng(images.at(i / 6, i % 6), rgbd())) << program << ", image " << i;
    const testing::OneThread one;
    EXPECT_EQ(*encodedCube(cube, arrangement, rgbd()), *pngs);
  }
}

TEST(EncodedCube, AsksForEachImageAndStops) {
  const ImageSet cube = cubeOfNumbers();
  std::atomic<int> asked = 0;
  ASSERT_TRUE(encodedCube(cube, {}, rgbd(), [&](std::size_t, std::size_t total) {
    ++asked;
    return total == 12;
  }));
  EXPECT_GE(asked, 12);
  for (const std::size_t last : {0u, 1u, 7u}) {
    const auto stopped = encodedCube(cube, {}, rgbd(), [last](std::size_t done, std::size_t) { return done < last; });
    ASSERT_FALSE(stopped) << last;
    EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  }
}

}  // namespace
}  // namespace mirrorball
