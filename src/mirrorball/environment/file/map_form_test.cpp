#include "mirrorball/environment/file/map_form.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/base/range.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

TEST(Picture, EveryProjectionComesBack) {
  for (const Projection projection : testing::kEveryProjection) {
    const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 32), projection, 16);
    const MapForm form{projection, CubeLayout::vcross};
    const EnvironmentMap back = *mapOfPicture(pictureOf(map, form), form);
    EXPECT_EQ(back.projection(), projection);
    ASSERT_EQ(back.faces(), map.faces());
    for (int face = 0; face < map.faces(); ++face)
      EXPECT_TRUE(std::equal(map.face(face).samples().begin(), map.face(face).samples().end(),
                             back.face(face).samples().begin()))
          << textOf(form) << " face " << face;
  }
}

TEST(Picture, CubesInAnyArrangementComeBackFromAnyLayout) {
  const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 32), Projection::eac, 6);
  const CubeArrangement z_up = inWorld(CubeArrangement{}, {SignedAxis::plus_x, SignedAxis::plus_z, SignedAxis::plus_y});
  for (const CubeArrangement& arrangement : {asSeen(CubeArrangement{}), flipped(z_up, Flip::vertical), z_up})
    for (std::size_t layout = 1; layout < cubeLayoutNames().size(); ++layout) {
      const MapForm form{Projection::eac, static_cast<CubeLayout>(layout), arrangement};
      const EnvironmentMap back = *mapOfPicture(pictureOf(map, form), form);
      for (int face = 0; face < 6; ++face)
        EXPECT_TRUE(areEqual(map.face(face).samples(), back.face(face).samples())) << textOf(form);
    }
}

// In whatever way a program has them, texels are moved, not resampled.
TEST(Picture, EveryPresetsFormComesBackToTheLastBit) {
  for (const Preset& preset : presets())
    for (const Projection projection : {Projection::cube, Projection::equirect}) {
      const auto form = formFor(preset, projection, CubeLayout::hcross);
      if (!form || form->has_texels_on_edges) continue;
      const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 32), projection, 16);
      const EnvironmentMap back = *mapOfPicture(pictureOf(map, *form), *form);
      for (int face = 0; face < map.faces(); ++face)
        EXPECT_TRUE(areEqual(map.face(face).samples(), back.face(face).samples())) << preset.name;
    }
}

// A quarter of 2 · 33 columns is no whole number of them.
TEST(Picture, APanoramaOfOddHeightIsResampled) {
  const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 256), Projection::equirect, 33);
  for (const SignedAxis centre : {SignedAxis::plus_x, SignedAxis::minus_x, SignedAxis::minus_z}) {
    MapForm form;
    form.centre = centre;
    const Image picture = pictureOf(map, form);
    // The middle row is the horizon, and the middle lies between its texels 32 and 33.
    const glm::vec3 middle = 0.5f * (rgbAt(picture, 32, 16) + rgbAt(picture, 33, 16));
    EXPECT_LT(glm::length(middle - testing::smoothRadiance(vectorOf(centre))), 5e-3f) << nameOf(centre);
    const EnvironmentMap back = *mapOfPicture(picture, form);
    for (const glm::vec3 d : testing::manyDirections(300))
      EXPECT_LT(glm::length(back.radiance(d) - map.radiance(d)), 1e-3f) << nameOf(centre);
  }
}

// 30 x 15, 15 x 7, 7 x 3, 3 x 1, 1 x 1: not only quarters are no whole columns, but a level is no map.
TEST(Picture, LevelsOfAnOddPanoramaComeBack) {
  ImageSet levels(5, 1);
  for (int level = 0; level < 5; ++level) {
    Image& image = levels.at(level, 0) = Image(levelSide(30, level), levelSide(15, level), 3);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const float angle = 6.2831853f * (static_cast<float>(x) + 0.5f) / static_cast<float>(image.width());
        const glm::vec3 light(2.0f + std::cos(angle), 2.0f + std::sin(angle), 1.0f + static_cast<float>(y));
        std::copy_n(&light.x, 3, image.texel(x, y));
      }
  }
  for (const SignedAxis centre : {SignedAxis::plus_x, SignedAxis::minus_z}) {
    MapForm form;
    form.centre = centre;
    const ImageSet back = levelsOfImages(imagesOf(levels, form), form);
    for (int level = 0; level < 3; ++level) {
      const Image& image = levels.at(level, 0);
      // A cubic is off by more, the fewer texels a wave has.
      const float max = level == 0 ? 0.01f : level == 1 ? 0.05f : 0.3f;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          EXPECT_LT(glm::length(rgbAt(back.at(level, 0), x, y) - rgbAt(image, x, y)), max) << level;
    }
    EXPECT_EQ(rgbAt(back.at(4, 0), 0, 0), rgbAt(levels.at(4, 0), 0, 0));
  }
}

TEST(Picture, TheFrontOfAParaboloidMapIsOnTheLeft) {
  ImageSet images(1, 2);
  images.at(0, 0) = Image(4, 4, 3, 1.0f);
  images.at(0, 1) = Image(4, 4, 3, 2.0f);
  const Image picture = pictureOf(EnvironmentMap(Projection::paraboloid, std::move(images)), {Projection::paraboloid});
  EXPECT_EQ(glm::ivec2(picture.width(), picture.height()), glm::ivec2(8, 4));
  EXPECT_EQ(rgbAt(picture, 3, 2), glm::vec3(1.0f));
  EXPECT_EQ(rgbAt(picture, 4, 2), glm::vec3(2.0f));
}

}  // namespace
}  // namespace mirrorball
