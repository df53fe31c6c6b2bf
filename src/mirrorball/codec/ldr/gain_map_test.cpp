#include "mirrorball/codec/ldr/gain_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::Each;
using ::testing::FloatNear;
using ::testing::HasSubstr;

constexpr GainMap kTwoStops{.min_log2 = glm::vec3(-1.0f),
                            .max_log2 = {2.0f, 4.0f, 16.0f},
                            .gamma = {1.0f, 2.0f, 0.5f},
                            .offset_sdr = glm::vec3(0.25f),
                            .offset_hdr = glm::vec3(0.125f)};

TEST(GainMap, LiftsEachChannelByTheFormula) {
  const Image picture(1, 1, 3, 0.5f);
  Image8 codes(1, 1, 3);
  codes.samples()[0] = 255;
  codes.samples()[1] = 64;
  codes.samples()[2] = 128;
  const Image light = lightByGainMap(picture, codes, kTwoStops);
  EXPECT_FLOAT_EQ(light.samples()[0], 0.75f * 4.0f - 0.125f);
  EXPECT_NEAR(light.samples()[1], 0.75 * std::exp2(-1.0 + 5.0 * std::sqrt(64.0 / 255.0)) - 0.125, 1e-4);
  EXPECT_NEAR(light.samples()[2], 0.75 * std::exp2(-1.0 + 17.0 * std::pow(128.0 / 255.0, 2.0)) - 0.125, 1e-4);
}

TEST(GainMap, ASmallerMapIsInterpolatedBetweenItsCentres) {
  Image8 codes(2, 1, 1);
  codes.samples()[1] = 255;
  const GainMap map{.max_log2 = glm::vec3(8.0f), .offset_sdr = glm::vec3(0.0f), .offset_hdr = glm::vec3(0.0f)};
  const Image light = lightByGainMap(Image(4, 2, 1, 1.0f), codes, map);
  ASSERT_EQ(light.channels(), 1);
  for (int y = 0; y < 2; ++y) {
    EXPECT_FLOAT_EQ(light.texel(0, y)[0], 1.0f);
    EXPECT_NEAR(light.texel(1, y)[0], 4.0f, 1e-5f);
    EXPECT_NEAR(light.texel(2, y)[0], 64.0f, 1e-4f);
    EXPECT_FLOAT_EQ(light.texel(3, y)[0], 256.0f);
  }
}

TEST(GainMap, GreyAndColouredOnesGoTogether) {
  EXPECT_EQ(lightByGainMap(Image(2, 2, 1, 1.0f), Image8(1, 1, 3, 255), {}).channels(), 3);
  EXPECT_EQ(lightByGainMap(Image(2, 2, 3, 1.0f), Image8(1, 1, 1, 255), {}).channels(), 3);
  const Image light = lightByGainMap(Image(2, 2, 1, 1.0f), Image8(1, 1, 3, 255), {});
  EXPECT_THAT(light.samples(), Each(FloatNear(2.0f + 1.0f / 64.0f, 1e-5f)));
}

TEST(GainMap, LightIsNotBelowZero) {
  const GainMap map{.min_log2 = glm::vec3(-8.0f), .max_log2 = glm::vec3(-4.0f)};
  EXPECT_THAT(lightByGainMap(Image(3, 1, 3, 0.0f), Image8(3, 1, 3, 0), map).samples(), Each(0.0f));
}

TEST(MadeGainMap, TakesAPictureToAnyLight) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  // The last three are no light.
  const std::vector<float> wanted{0.0f, 1e-3f, 0.02f, 0.5f, 1.0f, 3.0f, 200.0f, 6e4f, 1e5f, -1.0f, kNan, -kInfinity};
  Image light(static_cast<int>(wanted.size()), 1, 3);
  Image picture = light;
  for (std::size_t i = 0; i < light.samples().size(); ++i) {
    light.samples()[i] = wanted[i / 3];
    picture.samples()[i] = wanted[i / 3] > 0.0f ? std::min(wanted[i / 3], 1.0f) : 0.0f;
  }
  const MadeGainMap made = gainMapFor(picture, light);
  EXPECT_TRUE(checkGainMap(made.numbers));
  EXPECT_NEAR(made.numbers.max_log2.x, std::log2(1e5f), 0.01f) << "the brightest is not cut off";
  const Image back = lightByGainMap(picture, made.codes, made.numbers);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const float right = wanted[i] > 0.0f ? wanted[i] : 0.0f;
    EXPECT_NEAR(back.texel(static_cast<int>(i), 0)[0], right, 0.05f * right + 1e-4f) << wanted[i];
  }
}

TEST(MadeGainMap, OfOneGainHasOneCode) {
  for (const float radiance : {0.0f, 0.25f, 8.0f, 1e9f}) {
    const Image light(3, 2, 1, radiance);
    const MadeGainMap made = gainMapFor(Image(3, 2, 3, 0.25f), light);
    EXPECT_TRUE(checkGainMap(made.numbers)) << radiance;
    EXPECT_LT(made.numbers.headroom_min_log2, made.numbers.headroom_max_log2) << "readers divide by their difference";
    const float back = lightByGainMap(Image(3, 2, 3, 0.25f), made.codes, made.numbers).samples()[0];
    EXPECT_NEAR(back, radiance, 1e-4f * radiance + 1e-6f);
  }
}

TEST(MadeGainMap, InfiniteLightIsNotLost) {
  const Image light(2, 2, 3, std::numeric_limits<float>::infinity());
  const MadeGainMap made = gainMapFor(Image(2, 2, 3, 1.0f), light);
  EXPECT_TRUE(checkGainMap(made.numbers));
  EXPECT_GT(lightByGainMap(Image(2, 2, 3, 1.0f), made.codes, made.numbers).samples()[0], 1e14f);
}

TEST(GainMap, NumbersThatNoWriterMeansAreRefused) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(checkGainMap({}));
  EXPECT_TRUE(checkGainMap(kTwoStops));
  const auto refused = [](const GainMap& map, const char* what) {
    const auto checked = checkGainMap(map);
    ASSERT_FALSE(checked) << what;
    EXPECT_EQ(checked.error().code, ErrorCode::bad_file);
    EXPECT_THAT(checked.error().message, HasSubstr(what));
  };
  refused({.gamma = {1.0f, 0.0f, 1.0f}}, "gamma");
  refused({.gamma = glm::vec3(-1.0f)}, "gamma");
  refused({.gamma = glm::vec3(kNan)}, "gamma");
  refused({.gamma = glm::vec3(kInfinity)}, "gamma");
  refused({.max_log2 = glm::vec3(1e9f)}, "gains");
  refused({.min_log2 = {0.0f, 0.0f, kNan}}, "gains");
  refused({.min_log2 = glm::vec3(2.0f)}, "least gain");
  refused({.offset_sdr = glm::vec3(kInfinity)}, "offsets");
  refused({.offset_hdr = glm::vec3(-1e6f)}, "offsets");
  refused({.headroom_max_log2 = kNan}, "headroom");
}

}  // namespace
}  // namespace mirrorball
