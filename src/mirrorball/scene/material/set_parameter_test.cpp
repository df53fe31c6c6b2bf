#include "mirrorball/scene/material/set_parameter.h"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/left_out_testing.h"
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
    Scene scene = meshScene(sphereMesh());
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

/// A picture of one texel of light, in the test's folder.
std::string slopeFile(glm::vec3 texel) {
  const std::string path = ::testing::TempDir() + "set_parameter_slope.exr";
  Image image(1, 1, 3);
  for (int channel = 0; channel < 3; ++channel) image.texel(0, 0)[channel] = texel[channel];
  EXPECT_TRUE(writeImage(path, image));
  return path;
}

// Numbers of 16 bits keep them; what is seen as a colour has 8 bits, and its alpha.
TEST(SetParameter, DataMapsKeepSixteenBits) {
  const std::string path = ::testing::TempDir() + "set_parameter_fine.ppm";
  const std::string header = "P6 1 1 65535\n";
  Bytes bytes(header.begin(), header.end());
  for (const int code : {32768, 1000, 65535}) {
    bytes.push_back(static_cast<std::uint8_t>(code >> 8));
    bytes.push_back(static_cast<std::uint8_t>(code & 255));
  }
  ASSERT_TRUE(writeFile(path, bytes));
  for (const MaterialMap& map : materialMaps()) {
    Scene scene = meshScene(sphereMesh());
    ASSERT_TRUE(setParameter(scene, std::string(map.name) + "=" + path)) << map.name;
    const SharedPicture& picture = scene.textures.at(0).image;
    ASSERT_EQ(picture.hasNumbers(), !map.srgb) << map.name;
    const glm::vec4 exact = glm::vec4(32768, 1000, 65535, 65535) / 65535.0f;
    EXPECT_LT(glm::distance(picture.at(0, 0), exact), map.srgb ? 3e-3f : 1e-6f) << map.name;
    EXPECT_THAT(scene.warnings, ::testing::IsEmpty()) << map.name;
  }
}

TEST(SetParameter, MapsOfFloatsAreReadAsTheyAre) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  const std::string path = slopeFile({-0.6f, 0.0f, 0.8f});
  Scene scene = meshScene(sphereMesh());
  ASSERT_TRUE(setParameter(scene, "normal_map=" + path));
  EXPECT_EQ(scene.materials[0].normal_zero, 0.0f);
  EXPECT_LT(glm::distance(scene.textures[0].image.at(0, 0), glm::vec4(-0.6f, 0.0f, 0.8f, 1.0f)), 1e-6f);
  EXPECT_THAT(scene.warnings, ::testing::IsEmpty());
  ASSERT_TRUE(setParameter(scene, "base_color_map=" + path));
  EXPECT_FALSE(scene.textures[1].srgb);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("outside of 0 to 1")));
  ASSERT_TRUE(setParameter(scene, "emission_map=" + slopeFile({1.0f, 20.0f, 300.0f})));
  EXPECT_LT(glm::distance(scene.textures[2].image.at(0, 0), glm::vec4(1.0f, 20.0f, 300.0f, 1.0f)), 1e-3f);
}

TEST(SetParameter, ANormalMapsZeroIsFoundAndSaidByHand) {
  const std::string path = ::testing::TempDir() + "set_parameter_flat.png";
  Image8 flat(2, 2, 3, 128);
  for (std::size_t i = 2; i < flat.samples().size(); i += 3) flat.samples()[i] = 255;
  ASSERT_TRUE(savePicture(path, flat));
  Scene scene = meshScene(sphereMesh());
  ASSERT_TRUE(setParameter(scene, "normal_map=" + path));
  EXPECT_EQ(scene.materials[0].normal_zero, 128.0f);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("normal_zero=127.5")));
  ASSERT_TRUE(setParameter(scene, "normal_zero=127.5"));
  EXPECT_EQ(scene.materials[0].normal_zero, 127.5f);
}

TEST(SetParameter, ADerivativeMapIsSignedOrEncoded) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  Scene scene = meshScene(sphereMesh());
  ASSERT_TRUE(setParameter(scene, "derivative_map=" + slopeFile({-2.0f, 0.0f, 0.5f})));
  EXPECT_EQ(scene.materials[0].slope_texture, 0);
  EXPECT_EQ(rgbAt(scene.slope_textures.at(0), 0, 0), glm::vec3(-2.0f, 0.0f, 0.5f));
  ASSERT_TRUE(setParameter(scene, "Derivative-Map=" + onePixel()));  // of 255, 100, 255
  EXPECT_EQ(scene.materials[0].slope_texture, 1);
  EXPECT_EQ(rgbAt(scene.slope_textures.at(1), 0, 0), glm::vec3(1.0f, 0.0f, 1.0f));
  const std::string neutral = ::testing::TempDir() + "set_parameter_neutral.png";
  ASSERT_TRUE(savePicture(neutral, Image8(1, 1, 3, 128)));
  ASSERT_TRUE(setParameter(scene, "derivative_map=" + neutral));
  EXPECT_EQ(rgbAt(scene.slope_textures.at(2), 0, 0), glm::vec3(0.0f)) << "as `surface --to derivative` writes 0";
  ASSERT_TRUE(setParameter(scene, "derivative_map=" + slopeFile({1e30f, 7.0f, -1e30f})));
  EXPECT_EQ(rgbAt(scene.slope_textures.at(3), 0, 0), glm::vec3(1e4f, 0.0f, -1e4f)) << "as steep as pictures show";
  EXPECT_EQ(scene.files.size(), 4u);
  ASSERT_TRUE(setParameter(scene, "derivative_map=none"));
  EXPECT_EQ(scene.materials[0].slope_texture, -1);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(SetParameter, ADerivativeMapMustBeNumbersInColour) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  Scene scene = meshScene(sphereMesh());
  const auto said = [&](const std::string& value) {
    return setParameter(scene, "derivative_map" + value).error().message;
  };
  EXPECT_THAT(said(""), HasSubstr("derivative_map=FILE"));
  EXPECT_THAT(said("=none.exr"), HasSubstr("none.exr"));
  EXPECT_THAT(said("=" + slopeFile({0.0f, 0.0f, std::numeric_limits<float>::quiet_NaN()})),
              HasSubstr("slope at (0, 0) is no number"));
  const std::string grey = ::testing::TempDir() + "set_parameter_grey.exr";
  ASSERT_TRUE(writeImage(grey, Image(1, 1, 1)));
  EXPECT_THAT(said("=" + grey), HasSubstr("grey"));
  EXPECT_TRUE(scene.slope_textures.empty());
  Material alone;
  EXPECT_THAT(setParameter(alone, "derivative_map=x.exr").error().message, HasSubstr("needs a picture, and a model"));
}

TEST(SetParameter, SetsNumbersOfAllMaterials) {
  Scene scene = meshScene(sphereMesh());
  scene.materials.resize(2);
  ASSERT_TRUE(setParameter(scene, "metallic=0.25"));
  for (const Material& material : scene.materials) EXPECT_EQ(material.metallic, 0.25f);
}

// What is in a picture is not read: of large ones that takes seconds.
TEST(CheckParameter, SaysTheSameWithoutReadingPictures) {
  const std::string garbage = ::testing::TempDir() + "set_parameter_garbage.png";
  ASSERT_TRUE(writeFile(garbage, std::vector<std::uint8_t>{1, 2, 3}));
  for (const std::string name : {"base_color_map", "height", "derivative_map"}) {
    Scene scene = meshScene(sphereMesh());
    EXPECT_FALSE(setParameter(scene, name + "=" + garbage));
    EXPECT_TRUE(checkParameter(name + "=" + garbage));
    EXPECT_TRUE(checkParameter(name + "=" + onePixel()));
    for (const std::string wrong : {"./no_such_file.png", ""}) {
      const auto checked = checkParameter(name + "=" + wrong), set = setParameter(scene, name + "=" + wrong);
      ASSERT_FALSE(checked) << name << "=" << wrong;
      EXPECT_EQ(checked.error().message, set.error().message);
    }
  }
  EXPECT_TRUE(checkParameter("height=brick"));
  EXPECT_TRUE(checkParameter("perceptual_roughness=0.5"));
  EXPECT_FALSE(checkParameter("no_such_parameter=1"));
}

TEST(SetParameter, SaysWhatIsWrong) {
  Scene scene = meshScene(sphereMesh());
  EXPECT_THAT(setParameter(scene, "base_color_map").error().message, HasSubstr("base_color_map=FILE"));
  EXPECT_THAT(setParameter(scene, "base_color_map=none.png").error().message, HasSubstr("none.png"));
  EXPECT_THAT(setParameter(scene, "base_colour_map=x.png").error().message, HasSubstr("base_color_map"));
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] = glm::vec2(0.0f);
  ASSERT_TRUE(setParameter(scene, "normal_map=" + onePixel()));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no texture coordinates")));
}

}  // namespace
}  // namespace mirrorball
