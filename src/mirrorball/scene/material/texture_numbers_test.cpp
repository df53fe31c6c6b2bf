#include "mirrorball/scene/material/texture_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Image8 codes(int side, glm::ivec3 code) {
  Image8 image(side, side, 4, 255);
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    if (i % 4 < 3) image.samples()[i] = static_cast<std::uint8_t>(code[int(i % 4)]);
  return image;
}

/// Normals that lean by up to `slope`, as `encode` writes them.
template <typename Encode>
Image numbers(float slope, const Encode& encode) {
  Image image(8, 8, 4, 1.0f);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const glm::vec2 lean = slope * (glm::vec2(x, y) / 3.5f - 1.0f);
      const glm::vec3 stored = encode(glm::normalize(glm::vec3(lean, 1.0f)));
      for (int channel = 0; channel < 3; ++channel) image.texel(x, y)[channel] = stored[channel];
    }
  return image;
}

glm::vec3 signedNumbers(glm::vec3 n) { return n; }
glm::vec3 halved(glm::vec3 n) { return 0.5f + 0.5f * n; }

TEST(NormalZero, OfCodesIs128WhereMostTexelsAreFlatThere) {
  EXPECT_EQ(findNormalZero(codes(4, {128, 128, 255})), 128.0f);
  EXPECT_EQ(findNormalZero(codes(4, {127, 127, 255})), 127.5f);
  EXPECT_EQ(findNormalZero(codes(4, {128, 128, 254})), 127.5f);
  EXPECT_EQ(findNormalZero(Image8()), 127.5f);
  Image8 mostly = codes(4, {128, 128, 255});
  for (int x = 0; x < 4; ++x) mostly.texel(x, 0)[0] = 90;
  EXPECT_EQ(findNormalZero(mostly), 128.0f);
  Image8 hardly = codes(4, {90, 128, 255});
  for (int x = 0; x < 4; ++x) hardly.texel(x, 0)[0] = 128;
  EXPECT_EQ(findNormalZero(hardly), 127.5f) << "another texel is more frequent";
}

TEST(NormalZero, OfFloatsThatWereEightBitsIs128Too) {
  EXPECT_EQ(findNormalZero(fractionsFromCodes(codes(4, {128, 128, 255}))), 128.0f);
  EXPECT_EQ(findNormalZero(fractionsFromCodes(codes(4, {129, 128, 255}))), 127.5f);
}

TEST(NormalZero, OfFloatsIs0WhereTheyAreSigned) {
  for (const float slope : {0.0f, 0.02f, 1.5f}) {
    EXPECT_EQ(findNormalZero(numbers(slope, signedNumbers)), 0.0f) << slope;
    EXPECT_EQ(findNormalZero(numbers(slope, halved)), 127.5f) << slope;
  }
}

// Short normals, as filters leave them, and what lies beside the charts.
TEST(NormalZero, OfSixteenBitsIsNever0) {
  const auto code = [](glm::vec3 stored) { return glm::round(65535.0f * stored) / 65535.0f; };
  const Image shorter = numbers(0.05f, [&](glm::vec3 n) { return code(0.5f + 0.5f * 0.75f * n); });
  EXPECT_EQ(findNormalZero(shorter), 127.5f);
  Image padded = numbers(1.5f, signedNumbers);
  for (int x = 0; x < 8; ++x)
    for (int y = 1; y < 8; ++y)
      for (int channel = 0; channel < 3; ++channel) padded.texel(x, y)[channel] = 0.0f;
  EXPECT_EQ(findNormalZero(padded), 0.0f);
}

TEST(NormalZero, OfOneMapLeavesThatOfAnother) {
  Scene scene = meshScene(Mesh());
  scene.textures = {{.image = codes(2, {128, 128, 255})}};
  scene.materials[0].normal_map.texture = scene.materials[0].clearcoat_normal_map.texture = 0;
  const MaterialMap& map = *std::find_if(materialMaps().begin(), materialMaps().end(),
                                         [](const MaterialMap& each) { return each.slot == &Material::normal_map; });
  findNormalZeros(scene, "a.png", &map);
  EXPECT_EQ(scene.materials[0].normal_zero, 128.0f);
  EXPECT_EQ(scene.materials[0].clearcoat_normal_zero, 127.5f);
}

TEST(NormalZero, OfASceneIsFoundForEachMapAndToldOnce) {
  Scene scene = meshScene(Mesh());
  scene.materials.resize(3);
  scene.textures = {{.image = codes(2, {128, 128, 255})}, {.image = numbers(0.1f, signedNumbers)}};
  scene.materials[0].normal_map.texture = scene.materials[1].clearcoat_normal_map.texture = 0;
  scene.materials[2].normal_map.texture = 1;
  findNormalZeros(scene, "ball.glb");
  EXPECT_EQ(scene.materials[0].normal_zero, 128.0f);
  EXPECT_EQ(scene.materials[0].clearcoat_normal_zero, 127.5f);
  EXPECT_EQ(scene.materials[1].clearcoat_normal_zero, 128.0f);
  EXPECT_EQ(scene.materials[2].normal_zero, 0.0f);
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("ball.glb: the most frequent texel of a normal map is 128 128 255")));
}

TEST(TextureNumbers, CodesStayAndFloatsAreLinear) {
  Texture texture{.srgb = true};
  EXPECT_THAT(*setTexels(codes(1, {1, 2, 3}), TextureUse::factors, texture), IsEmpty());
  EXPECT_TRUE(texture.srgb);
  EXPECT_THAT(texture.image.samples(), ElementsAre(1, 2, 3, 255));
  EXPECT_THAT(*setTexels(Image(1, 1, 4, 0.5f), TextureUse::factors, texture), IsEmpty());
  EXPECT_FALSE(texture.srgb);
  EXPECT_EQ(texture.image.at(0, 0), glm::vec4(0.5f));
}

TEST(TextureNumbers, AreCutToWhatTheyCanBe) {
  Image wild(2, 1, 4, 0.5f);
  wild.texel(0, 0)[0] = -3.0f;
  wild.texel(1, 0)[1] = 1e9f;
  Texture texture;
  EXPECT_THAT(*setTexels(wild, TextureUse::factors, texture), ElementsAre(HasSubstr("outside of 0 to 1")));
  EXPECT_EQ(texture.image.at(0, 0), glm::vec4(0.0f, 0.5f, 0.5f, 0.5f));
  EXPECT_EQ(texture.image.at(1, 0).y, 1.0f);
  EXPECT_THAT(*setTexels(wild, TextureUse::light, texture), ElementsAre(HasSubstr("outside of 0 to 65504")));
  EXPECT_EQ(texture.image.at(1, 0).y, 65504.0f);
  wild.texel(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(*setTexels(wild, TextureUse::normals, texture), ElementsAre(HasSubstr("not finite")));
  EXPECT_EQ(texture.image.at(0, 0).x, 0.5f) << "its neighbour's";
  EXPECT_FALSE(setTexels(Image(1, 1, 4, std::numeric_limits<float>::infinity()), TextureUse::normals, texture));
}

TEST(TextureNumbers, GreyNormalsAreTold) {
  Texture texture;
  EXPECT_THAT(*setTexels(codes(2, {90, 90, 90}), TextureUse::normals, texture), ElementsAre(HasSubstr("is grey")));
  EXPECT_THAT(*setTexels(codes(2, {90, 90, 90}), TextureUse::factors, texture), IsEmpty());
}

TEST(TextureNumbers, NormalsAreKnownByTheirLengthAndDirection) {
  const auto looks = [](glm::ivec3 code) { return looksLikeNormals(SharedPicture(codes(4, code))); };
  EXPECT_TRUE(looks({128, 128, 255}));
  EXPECT_TRUE(looks({200, 128, 232}));
  EXPECT_FALSE(looks({201, 200, 201})) << "a grey of length 1";
  EXPECT_FALSE(looks({150, 100, 60})) << "wood";
  EXPECT_FALSE(looks({255, 0, 0}));
  EXPECT_FALSE(looks({0, 0, 0}));
  EXPECT_FALSE(looksLikeNormals(SharedPicture()));
  EXPECT_TRUE(looksLikeNormals(SharedPicture(numbers(0.5f, halved))));
  EXPECT_TRUE(looksLikeNormals(SharedPicture(numbers(0.5f, signedNumbers))));
  Image8 charts = codes(4, {0, 0, 0});
  charts.texel(1, 1)[0] = charts.texel(1, 1)[1] = 128;
  charts.texel(1, 1)[2] = 255;
  EXPECT_TRUE(looksLikeNormals(SharedPicture(charts))) << "black lies beside the charts";
}

TEST(TextureNumbers, NormalsAreDecodedToThreeSignedNumbers) {
  const Image decoded = decodedNormals(numbers(0.5f, halved), 127.5f);
  EXPECT_EQ(decoded.channels(), 3);
  EXPECT_LT(glm::distance(rgbAt(decoded, 2, 5), rgbAt(numbers(0.5f, signedNumbers), 2, 5)), 1e-6f);
}

// BC5 and files of two channels keep x and y alone.
TEST(TextureNumbers, NormalsWithoutBlueAreOfLength1) {
  for (const auto encode : {signedNumbers, halved}) {
    Image flat = numbers(0.8f, encode);
    const Image whole = flat;
    for (std::size_t i = 2; i < flat.samples().size(); i += 4) flat.samples()[i] = 0.0f;
    Texture texture;
    EXPECT_THAT(*setTexels(flat, TextureUse::normals, texture), ElementsAre(HasSubstr("no blue")));
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(texture.image.at(x, 3).z, whole.texel(x, 3)[2], 1e-6f) << x;
  }
}

}  // namespace
}  // namespace mirrorball
