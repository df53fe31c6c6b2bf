#include "mirrorball/bake/light_check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter_testing.h"

namespace mirrorball {
namespace {

TEST(LightCheck, TakesTheFinestDetailWhereverItIs) {
  constexpr int kPart = 16;  // texels a side, of a panorama of 512 × 256
  const std::set<std::pair<int, int>> patches{{3, 4}, {31, 8}, {17, 14}};
  Image image(512, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) {
      const bool is_fine = patches.contains({x / kPart, y / kPart});
      const float value = 1.0f + 0.3f * std::sin(0.05f * static_cast<float>(x + y));
      for (int c = 0; c < 3; ++c) image.texel(x, y)[c] = is_fine && (x + y) % 2 == 0 ? 0.0f : value;
    }
  const std::vector<glm::ivec2> texels =
      doubtfulTexels(EnvironmentMap(Projection::equirect, ImageSet(std::move(image))));
  ASSERT_EQ(texels.size(), 16u);
  for (const auto& [column, row] : patches)
    EXPECT_TRUE(std::ranges::any_of(
        texels, [&](glm::ivec2 texel) { return texel.x / kPart == column && texel.y / kPart == row; }))
        << column << " " << row;
}

TEST(LightCheck, TakesTexelsAllOverTheSphere) {
  const EnvironmentMap panorama = panoramaOf(128, 64, [](glm::vec3) { return glm::vec3(1.0f); });
  const std::vector<glm::ivec2> texels = doubtfulTexels(panorama);
  const std::vector<glm::vec3> directions = directionsOf(texels, panorama.extent());
  ASSERT_EQ(directions.size(), texels.size());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(std::ranges::any_of(directions, [&](glm::vec3 d) { return d[axis] > 0.5f; })) << axis;
    EXPECT_TRUE(std::ranges::any_of(directions, [&](glm::vec3 d) { return d[axis] < -0.5f; })) << axis;
  }
}

struct Reflection {
  Distribution distribution;
  LobeKernel (*kernel)(double perceptual_roughness);
};

class LightCheckSum : public testing::TestWithParam<Reflection> {};

TEST_P(LightCheckSum, IsThatOverAllTexels) {
  const auto& [distribution, kernel] = GetParam();
  const EnvironmentMap panorama = panoramaOf(202, 101, landscapeWithSun);  // no whole number of vectors
  const EnvironmentMap white = panoramaOf(202, 101, [](glm::vec3) { return glm::vec3(1.0f); });
  const std::vector<glm::ivec2> texels{{0, 0}, {201, 50}, {57, 31}, {8, 100}, {100, 12}};
  const std::vector<glm::vec3> directions = directionsOf(texels, panorama.extent());
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    const Lobe lobe = Lobe::reflection(distribution, roughness);
    const std::vector<glm::vec3> found = sumOverTexels(panorama, lobe, texels);
    const std::vector<glm::vec3> weights = sumOverTexels(white, lobe, texels);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      EXPECT_NEAR(weights[i].x, 1.0f, 0.02f);  // two of them touch a pole
      const glm::dvec3 truth = meanOfTexels(panorama, kernel(static_cast<double>(roughness)), directions[i]);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[i][c] / weights[i][c] / static_cast<float>(truth[c]), 1.0f, 3e-5f) << roughness << " " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Distributions, LightCheckSum,
                         testing::Values(Reflection{Distribution::ggx, ggxKernel},
                                         Reflection{Distribution::phong, phongKernel},
                                         Reflection{Distribution::blinn, blinnKernel},
                                         Reflection{Distribution::charlie, charlieKernel}));

}  // namespace
}  // namespace mirrorball
