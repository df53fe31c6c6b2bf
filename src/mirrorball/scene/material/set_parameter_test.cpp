#include "mirrorball/scene/material/set_parameter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A picture of one texel, in the test's folder.
std::string onePixel() {
  const std::string path = ::testing::TempDir() + "set_parameter_pixel.png";
  Image8 image(1, 1, 4, 255);
  image.texel(0, 0)[1] = 100;
  EXPECT_TRUE(savePicture(path, image));
  return path;
}

TEST(SetParameter, EveryMapTakesAPicture) {
  const std::string path = onePixel();
  for (const MaterialMap& map : materialMaps()) {
    Scene scene = sceneOf(sphereMesh());
    scene.materials.resize(2);
    ASSERT_TRUE(setParameter(scene, std::string(map.name) + "=" + path)) << map.name;
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].srgb, map.srgb) << map.name;
    EXPECT_EQ(scene.textures[0].image.texel(0, 0)[1], 100) << "as stored";
    for (const Material& material : scene.materials) EXPECT_EQ((material.*map.slot).texture, 0) << map.name;
    EXPECT_THAT(scene.files, ElementsAre(path));
    EXPECT_TRUE(scene.warnings.empty());
  }
}

TEST(SetParameter, SetsNumbersOfAllMaterials) {
  Scene scene = sceneOf(sphereMesh());
  scene.materials.resize(2);
  ASSERT_TRUE(setParameter(scene, "metallic=0.25"));
  for (const Material& material : scene.materials) EXPECT_EQ(material.metallic, 0.25f);
}

TEST(SetParameter, SaysWhatIsWrong) {
  Scene scene = sceneOf(sphereMesh());
  EXPECT_THAT(setParameter(scene, "base_color_map").error().message, HasSubstr("base_color_map=FILE"));
  EXPECT_THAT(setParameter(scene, "base_color_map=none.png").error().message, HasSubstr("none.png"));
  EXPECT_THAT(setParameter(scene, "base_colour_map=x.png").error().message, HasSubstr("base_color_map"));
  for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv[0] = glm::vec2(0.0f);
  ASSERT_TRUE(setParameter(scene, "normal_map=" + onePixel()));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no texture coordinates")));
}

}  // namespace
}  // namespace mirrorball
