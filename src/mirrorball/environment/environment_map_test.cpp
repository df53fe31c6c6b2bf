#include "mirrorball/environment/environment_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using testing::kEveryProjection;

EnvironmentMap smoothMap(Projection projection, int size) {
  return *convert(Environment(testing::smoothRadiance, 256), projection, size);
}

TEST(EnvironmentMap, TexelCentresAnswerWithTheTexelItself) {
  for (const Projection projection : kEveryProjection) {
    const EnvironmentMap map = smoothMap(projection, 16);
    const glm::ivec2 size(map.face(0).width(), map.size());
    for (int face = 0; face < map.faces(); ++face)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(size);
          if (!covers(projection, uv)) continue;
          const glm::vec3 light = map.radiance(directionAt(projection, {face, uv}));
          EXPECT_LT(glm::length(light - rgbAt(map.face(face), x, y)), 2e-4f)
              << nameOf(projection) << " face " << face << " (" << x << ", " << y << ")";
        }
  }
}

// A wrong neighbour jumps by about a texel's difference, here 0.05 and more; a step is a hundredth of a texel.
TEST(EnvironmentMap, DoesNotJumpAcrossSeams) {
  for (const Projection projection : kEveryProjection) {
    const auto isNoEnd = [&](glm::vec3 d) { return !testing::isEnd(projection, d); };
    EXPECT_LT(testing::largestStep(smoothMap(projection, 32), isNoEnd), 0.01f) << nameOf(projection);
  }
}

TEST(EnvironmentMap, NothingFromBesideADiscIsMixedIn) {
  for (const Projection projection : kEveryProjection) {
    if (!hasDisc(projection)) continue;
    ImageSet images(1, faceCount(projection));
    for (int face = 0; face < images.faces(); ++face) {
      Image& image = images.at(0, face) = Image(16, 16, 4);
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
          const bool inside = covers(projection, (glm::vec2(x, y) + 0.5f) / 16.0f);
          std::fill_n(image.texel(x, y), 4, inside ? 1.0f : -100.0f);
        }
    }
    const EnvironmentMap map(projection, std::move(images));
    for (const glm::vec3 direction : testing::manyDirections(5000))
      EXPECT_NEAR(map.radiance(direction).x, 1.0f, 1e-5f) << textOf(projection);
    EXPECT_NEAR(map.radiance({0, 0, -1}).x, 1.0f, 1e-5f) << textOf(projection);
  }
}

TEST(EnvironmentMap, AHalfHasNoLightInTheOther) {
  const EnvironmentMap half(Projection::hemioctahedral, ImageSet(Image(8, 8, 3, 1.0f)));
  for (const glm::vec3 direction : testing::manyDirections(5000))
    EXPECT_NEAR(half.radiance(direction).x, direction.z >= 0.0f ? 1.0f : 0.0f, 1e-6f);
}

// A spot at every edge and corner is seen from both sides of it: an edge sewn to the wrong one would show another.
TEST(EnvironmentMap, SeesTheTexelBeyondAFold) {
  for (const Projection projection : {Projection::octahedral, Projection::equal_area}) {
    Image image(16, 16, 3, 0.0f);
    std::fill_n(image.texel(3, 0), 3, 1.0f);
    const EnvironmentMap map(projection, ImageSet(std::move(image)));
    // The edge's other half runs the other way: column 12 of the row beyond it is this texel.
    EXPECT_NEAR(map.radiance(directionAt(projection, {0, {3.5f / 16.0f, 0.0f}})).x, 0.5f, 1e-4f);
    EXPECT_NEAR(map.radiance(directionAt(projection, {0, {12.5f / 16.0f, 0.0f}})).x, 0.5f, 1e-4f);
    EXPECT_NEAR(map.radiance(directionAt(projection, {0, {12.5f / 16.0f, 1.0f}})).x, 0.0f, 1e-4f);
  }
}

// Rows shrink towards a pole: by weights as of rows of one size a bright first row gained 8 %.
TEST(EnvironmentMap, ABrightRowKeepsItsLight) {
  constexpr int kHeight = 16;
  constexpr int kSteps = 4096;
  for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::bicubic})
    for (const int row : {0, 1, 2, kHeight / 2, kHeight - 1}) {
      EnvironmentMap panorama(Projection::equirect, ImageSet(Image(2 * kHeight, kHeight, 3)));
      const auto texels = panorama.face(0).row(row);
      std::fill(texels.begin(), texels.end(), 1.0f);
      double flux = 0.0;
      for (int step = 0; step < kSteps; ++step) {
        const double polar = (step + 0.5) / kSteps * glm::pi<double>();
        const glm::vec3 towards(0.0, std::cos(polar), std::sin(polar));
        flux += glm::two_pi<double>() * std::sin(polar) * glm::pi<double>() / kSteps *
                double(panorama.radiance(towards, interpolation).x);
      }
      EXPECT_NEAR(flux / testing::fluxOf(panorama), 1.0, 0.002) << "row " << row;
    }
}

TEST(EnvironmentMap, OneTexelAnswersEverywhere) {
  const EnvironmentMap cube(Projection::cube, [] {
    ImageSet faces(1, 6);
    for (int face = 0; face < 6; ++face) faces.at(0, face) = Image(1, 1, 1, 3.0f);
    return faces;
  }());
  EXPECT_EQ(cube.radiance(glm::normalize(glm::vec3(1, 1, 1))), glm::vec3(3.0f));
  const EnvironmentMap panorama(Projection::equirect, ImageSet(Image(2, 1, 3, 3.0f)));
  EXPECT_EQ(panorama.radiance({0, 1, 0}), glm::vec3(3.0f));
}

TEST(RaiseNegativeLight, LeavesAlphaAndLightAsTheyAre) {
  Image image(2, 1, 4, 0.5f);
  image.texel(1, 0)[0] = -1.0f;
  image.texel(1, 0)[3] = -2.0f;
  EnvironmentMap map(Projection::equirect, ImageSet(std::move(image)));
  EXPECT_EQ(raiseNegativeLight(map), 1u);
  EXPECT_EQ(map.face(0).texel(1, 0)[0], 0.0f);
  EXPECT_EQ(map.face(0).texel(1, 0)[3], -2.0f);
  EXPECT_EQ(map.face(0).texel(0, 0)[1], 0.5f);
}

}  // namespace
}  // namespace mirrorball
