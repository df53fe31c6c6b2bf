#include "mirrorball/output/baked/playcanvas_atlas.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

BakedMaps mapsOfAtlas(RadianceFunction light) {
  return *bake(Environment(std::move(light), 128),
               {.size = 128, .levels = kAtlasLevels, .mip_mapping = MipMapping::linear});
}

/// spherical.js and envAtlas.js: where the shader looks a direction up in a part of the atlas [share of its side].
glm::vec2 placeIn(glm::vec4 part, glm::vec3 ours) {
  constexpr float kSeam = 1.0f / 512.0f;
  const glm::vec2 uv(0.5f + std::atan2(-ours.x, ours.z) / (2.0f * formula::kPi),
                     0.5f - std::asin(ours.y) / formula::kPi);
  return {glm::mix(part.x + kSeam, part.x + part.z - kSeam, uv.x),
          glm::mix(part.y + kSeam, part.y + part.w - kSeam, uv.y)};
}

glm::vec3 seenIn(const Image& atlas, glm::vec2 place) {
  return glm::vec3(bilinear(place * 512.0f, [&](int x, int y) { return rgbaAt(atlas, x, y); }));
}

/// The mean of light under the lobe of a level, by the exact chain.
EnvironmentMap levelOfChain(const BakedMaps& maps, int level) {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = maps.specular.at(level, face);
  return {Projection::cube, std::move(faces)};
}

TEST(PlayCanvasAtlas, TheShadersLookUpsFindTheLight) {
  const BakedMaps maps = mapsOfAtlas(testing::smoothRadiance);
  const Image atlas = atlasOf(maps);
  for (int level = 0; level < kAtlasLevels; ++level) {
    const float t = std::exp2(-float(level));
    const EnvironmentMap blurred = levelOfChain(maps, level);
    for (const glm::vec3 d : testing::manyDirections(200)) {
      // A step of its small panoramas is 2π / 14: what is between is interpolated.
      const float tolerance = level < 4 ? 0.01f : 0.04f;
      const float unfiltered_tolerance = 2.5f * tolerance;
      const glm::vec3 shiny = seenIn(atlas, placeIn({1.0f - t, 1.0f - t, t, t / 2.0f}, d));
      EXPECT_LT(glm::length(shiny - testing::smoothRadiance(d)), unfiltered_tolerance) << level;
      if (level == 0) continue;
      const glm::vec3 rough = seenIn(atlas, placeIn({0.0f, 1.0f - t, t, t / 2.0f}, d));
      EXPECT_LT(glm::length(rough - blurred.radiance(d)), tolerance) << level;
    }
  }
  for (const glm::vec3 d : testing::manyDirections(200)) {
    const glm::vec3 ambient = seenIn(atlas, placeIn({128.0f / 512, 384.0f / 512, 64.0f / 512, 32.0f / 512}, d));
    EXPECT_LT(glm::length(ambient - maps.irradiance.radiance(d)), 0.005f);
  }
}

TEST(PlayCanvasAtlas, SeamsGoOnAroundAndOverThePoles) {
  const Image atlas = atlasOf(mapsOfAtlas(testing::smoothRadiance));
  for (int y = 1; y < 127; ++y)
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(atlas.texel(0, 256 + y)[c], atlas.texel(254, 256 + y)[c], 1e-4f);
      EXPECT_NEAR(atlas.texel(255, 256 + y)[c], atlas.texel(1, 256 + y)[c], 1e-4f);
    }
  for (int x = 1; x < 128; ++x)
    EXPECT_NEAR(atlas.texel(x, 256)[0], atlas.texel(x + 127, 257)[0], 1e-4f) << "the other side of the pole";
}

TEST(PlayCanvasAtlas, IsAPngOf512) {
  const auto packed = playcanvasAtlas(mapsOfAtlas([](glm::vec3 d) { return glm::vec3(d.y > 0.9f ? 1e3f : 1.0f); }));
  ASSERT_TRUE(packed) << packed.error().message;
  const Image8 picture = *decodePngTexture(packed->bytes);
  EXPECT_EQ(picture.width(), 512);
  EXPECT_EQ(picture.height(), 512);
  EXPECT_EQ(picture.channels(), 4);
  EXPECT_EQ(packed->brightest, 64.0f);
  EXPECT_GT(packed->lost.share(), 0.8);
}

}  // namespace
}  // namespace mirrorball
