#include "mirrorball/output/baked/playcanvas_atlas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"
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
  const Image atlas = *atlasOf(maps);
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
  const Image atlas = *atlasOf(mapsOfAtlas(testing::smoothRadiance));
  for (int y = 1; y < 127; ++y)
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(atlas.texel(0, 256 + y)[c], atlas.texel(254, 256 + y)[c], 1e-4f);
      EXPECT_NEAR(atlas.texel(255, 256 + y)[c], atlas.texel(1, 256 + y)[c], 1e-4f);
    }
  for (int x = 1; x < 128; ++x)
    EXPECT_NEAR(atlas.texel(x, 256)[0], atlas.texel(x + 127, 257)[0], 1e-4f) << "the other side of the pole";
}

/// A chain that is black but for a lamp of 3² texels at a place of face +Z.
BakedMaps lampAt(int size, glm::ivec2 corner) {
  BakedMaps maps;
  maps.specular = ImageSet(kAtlasLevels, 6);
  for (int level = 0; level < kAtlasLevels; ++level)
    for (int face = 0; face < 6; ++face)
      maps.specular.at(level, face) = Image(levelSide(size, level), levelSide(size, level), 3);
  for (int i = 0; i < 9; ++i) std::fill_n(maps.specular.at(0, 4).texel(corner.x + i % 3, corner.y + i / 3), 3, 1e5f);
  ImageSet irradiance(1, 6);
  for (int face = 0; face < 6; ++face) irradiance.at(0, face) = Image(4, 4, 3);
  maps.irradiance = EnvironmentMap(Projection::cube, std::move(irradiance));
  return maps;
}

/// The integral of red over the sphere in the panorama of a level, without its seams.
double lightOfPart(const Image& atlas, int level) {
  const int width = 512 >> level;
  const int columns = width - 2;
  const int rows = width / 2 - 2;
  double sum = 0.0;
  for (int y = 0; y < rows; ++y) {
    const double theta = double(formula::kPi) / rows;
    const double angle = (std::cos(y * theta) - std::cos((y + 1) * theta)) * 2.0 * double(formula::kPi) / columns;
    for (int x = 0; x < columns; ++x) sum += angle * double(atlas.texel(512 - width + 1 + x, 512 - width + 1 + y)[0]);
  }
  return sum;
}

// Each panorama is made of a cube of its own fineness: no texel of it is missed, however large the first one is.
TEST(PlayCanvasAtlas, ASmallLampKeepsItsLightInAllPanoramas) {
  for (const int size : {600, 1024})
    for (const glm::ivec2 corner : {glm::ivec2(size / 2 + 1), glm::ivec2(size / 10, size / 12)}) {
      const glm::ivec2 middle = corner + 1;
      const double light = 1e5 * 9.0 * double(texelSolidAngle(Projection::cube, glm::ivec2(size), middle));
      const Image atlas = *atlasOf(lampAt(size, corner));
      for (int level = 0; level < 5; ++level)
        EXPECT_NEAR(lightOfPart(atlas, level) / light, 1.0, 0.2) << size << ", level " << level << ", " << corner.x;
    }
}

TEST(PlayCanvasAtlas, IsTheSameForOneThread) {
  const BakedMaps maps = mapsOfAtlas(testing::smoothRadiance);
  const Bytes many = playcanvasAtlas(maps)->bytes;
  const testing::OneThread one;
  EXPECT_EQ(playcanvasAtlas(maps)->bytes, many);
}

TEST(PlayCanvasAtlas, StopsAtAnyPanorama) {
  const BakedMaps maps = lampAt(64, {3, 5});
  for (const std::size_t last : {0u, 3u, 9u}) {
    const auto stopped = playcanvasAtlas(maps, [last](std::size_t done, std::size_t) { return done < last; });
    ASSERT_FALSE(stopped) << last;
    EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  }
}

TEST(PlayCanvasAtlas, IsAPngOf512) {
  const auto packed = playcanvasAtlas(mapsOfAtlas([](glm::vec3 d) { return glm::vec3(d.y > 0.9f ? 1e3f : 1.0f); }));
  ASSERT_TRUE(packed) << packed.error().message;
  const Image8 picture = *decodeTexture(packed->bytes);
  EXPECT_EQ(picture.width(), 512);
  EXPECT_EQ(picture.height(), 512);
  EXPECT_EQ(picture.channels(), 4);
  EXPECT_EQ(packed->brightest, 64.0f);
  EXPECT_GT(packed->lost.share(), 0.8);
}

}  // namespace
}  // namespace mirrorball
