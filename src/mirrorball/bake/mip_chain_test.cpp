#include "mirrorball/bake/mip_chain.h"

#include <gtest/gtest.h>

#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

EnvironmentMap cubeOf(const RadianceFunction& radiance, int side) {
  return *convert(Environment(radiance, 2 * side), Projection::cube, side);
}

double flux(const ImageSet& chain, int level) {
  double sum = 0.0;
  for (int face = 0; face < 6; ++face) {
    const Image& image = chain.at(level, face);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        sum +=
            double(rgbAt(image, x, y).x) * double(texelSolidAngle(Projection::cube, glm::ivec2(image.width()), {x, y}));
  }
  return sum;
}

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

}  // namespace
}  // namespace mirrorball
