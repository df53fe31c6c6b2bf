#include "mirrorball/bake/prefilter/mip_chain.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

EnvironmentMap cubeOf(const RadianceFunction& radiance, int side) {
  return *convert(Environment(radiance, 2 * side), Projection::cube, side);
}

/// One level as a map of its own.
EnvironmentMap levelOf(const ImageSet& chain, int level, Projection projection) {
  ImageSet images(1, chain.faces());
  for (int face = 0; face < chain.faces(); ++face) images.at(0, face) = chain.at(level, face);
  return EnvironmentMap(projection, std::move(images));
}

double flux(const ImageSet& chain, int level) { return testing::fluxOf(levelOf(chain, level, Projection::cube)); }

TEST(MipChain, LevelsHalveDownToOneRoundingDown) {
  for (const int side : {1, 2, 64, 11}) {
    const ImageSet chain = mipChain(cubeOf([](glm::vec3) { return glm::vec3(1.0f); }, side));
    for (int level = 0; level < chain.levels(); ++level) EXPECT_EQ(chain.at(level, 5).width(), side >> level);
    EXPECT_EQ(chain.at(chain.levels() - 1, 0).width(), 1);
  }
}

TEST(MipChain, WhiteStaysWhiteOnEveryLevel) {
  const ImageSet chain = mipChain(cubeOf([](glm::vec3) { return glm::vec3(1.0f); }, 44));
  for (int level = 0; level < chain.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      for (const float sample : chain.at(level, face).samples()) EXPECT_NEAR(sample, 1.0f, 1e-6f);
}

// A single bright texel keeps its flux wherever it lies on a face: with a plain box it would lose half of it in the
// middle and gain 2.7 times its due in a corner.
TEST(MipChain, KeepsTheFluxOfASingleTexel) {
  for (const glm::ivec2 place : {glm::ivec2(0, 0), glm::ivec2(16, 15), glm::ivec2(31, 3)}) {
    ImageSet faces(1, 6);
    for (int face = 0; face < 6; ++face) faces.at(0, face) = Image(32, 32, 3);
    faces.at(0, 2).texel(place.x, place.y)[0] = 1000.0f;
    const ImageSet chain = mipChain(EnvironmentMap(Projection::cube, std::move(faces)));
    for (int level = 1; level < chain.levels(); ++level)
      EXPECT_NEAR(flux(chain, level) / flux(chain, 0), 1.0, 1e-5) << "level " << level;
  }
}

TEST(MipChain, TheLastLevelIsEachFacesMean) {
  const ImageSet chain = mipChain(cubeOf([](glm::vec3 d) { return glm::vec3(1.0f + d.z); }, 22));
  // The mean of z over the face +Z, weighted by solid angle, by brute force.
  double sum = 0.0;
  double total = 0.0;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) {
      const double weight = double(texelSolidAngle(Projection::cube, glm::ivec2(400), {x, y}));
      sum += weight * double(directionAt(Projection::cube, {4, (glm::vec2(x, y) + 0.5f) / 400.0f}).z);
      total += weight;
    }
  EXPECT_NEAR(rgbAt(chain.at(chain.levels() - 1, 4), 0, 0).x, 1.0 + sum / total, 1e-3);
}

TEST(MipChain, KeepsTheFluxOfAPanorama) {
  const EnvironmentMap panorama = *convert(Environment(testing::smoothRadiance, 64), Projection::equirect, 64);
  const double whole = testing::fluxOf(panorama);
  const ImageSet chain = mipChain(panorama);
  // From 2 × 1 texels on the next level is no panorama of ours.
  for (int level = 1; level < chain.levels() - 1; ++level)
    EXPECT_NEAR(testing::fluxOf(levelOf(chain, level, Projection::equirect)) / whole, 1.0, 1e-5) << "level " << level;
}

TEST(MipChain, ABoxIsThePlainMeanOfFour) {
  const EnvironmentMap cube = cubeOf(testing::waves, 32);
  const ImageSet chain = mipChain(cube, MipWeights::box);
  float farthest = 0.0f;  // from the mean by solid angle
  const ImageSet weighted = mipChain(cube);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const Image& source = cube.face(face);
        const glm::vec3 sum = rgbAt(source, 2 * x, 2 * y) + rgbAt(source, 2 * x + 1, 2 * y) +
                              rgbAt(source, 2 * x, 2 * y + 1) + rgbAt(source, 2 * x + 1, 2 * y + 1);
        const float box = rgbAt(chain.at(1, face), x, y).x;
        EXPECT_NEAR(box, sum.x / 4.0f, 1e-6f);
        farthest = std::max(farthest, std::abs(box - rgbAt(weighted.at(1, face), x, y).x));
      }
  EXPECT_GT(farthest, 1e-3f);
}

// A step is 0.3 mrad. On a level of n² texels neighbours differ by up to about 2 / n; a seam would jump by as much.
TEST(MipChain, LevelsHaveNoSeams) {
  for (const Projection projection :
       {Projection::equirect, Projection::cube, Projection::octahedral, Projection::equal_area, Projection::eac})
    for (const MipWeights weights : {MipWeights::solid_angle, MipWeights::box}) {
      const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 64), projection, 64);
      const ImageSet chain = mipChain(map, weights);
      for (int level = 0; levelSide(map.size(), level) >= 4; ++level) {
        const EnvironmentMap of_level = levelOf(chain, level, projection);
        const float step = testing::largestStep(of_level, [](glm::vec3) { return true; });
        EXPECT_LT(step, 0.3f / static_cast<float>(of_level.size())) << nameOf(projection) << " level " << level;
      }
    }
}

}  // namespace
}  // namespace mirrorball
