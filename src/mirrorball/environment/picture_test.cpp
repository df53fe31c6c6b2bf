#include "mirrorball/environment/picture.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert.h"
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
