#include "mirrorball/scene/material/builtin_picture.h"

#include <gtest/gtest.h>

#include "mirrorball/scene/material/set_parameter.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

TEST(BuiltinPicture, StripesAreHalfWhiteAndTile) {
  const Image8 stripes = builtinPicture("stripes");
  int white = 0;
  for (int x = 0; x < stripes.width(); ++x) {
    EXPECT_EQ(stripes.texel(x, 0)[0], stripes.texel(x, stripes.height() - 1)[0]);
    EXPECT_EQ(stripes.texel(x, 0)[3], 255);
    white += stripes.texel(x, 0)[0] / 255;
  }
  EXPECT_EQ(white, stripes.width() / 2);
  EXPECT_NE(stripes.texel(0, 0)[0], stripes.texel(stripes.width() - 1, 0)[0]);
}

TEST(BuiltinPicture, EveryMapTakesOneByItsName) {
  for (const std::string_view name : builtinPictureNames()) {
    Scene scene = meshScene(sphereMesh());
    ASSERT_TRUE(setParameter(scene, "base_color_map=" + std::string(name)));
    EXPECT_EQ(scene.textures.at(0).image.width(), 1024);
    EXPECT_TRUE(scene.textures[0].srgb);
    EXPECT_TRUE(scene.files.empty());
  }
  Scene scene = meshScene(sphereMesh());
  EXPECT_FALSE(setParameter(scene, "base_color_map=strypes"));
}

}  // namespace
}  // namespace mirrorball
