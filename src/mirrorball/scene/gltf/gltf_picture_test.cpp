// Pictures of glTF files that are missing, damaged, or of coordinates that few files have: docs/files.md.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::expectTold;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A folder for a model, with pictures in it.
class GltfPicture : public ::testing::Test {
 protected:
  GltfPicture() {
    fs::create_directories(folder_ / "Textures");
    EXPECT_TRUE(savePicture(folder_ / "Textures" / "Wood Floor.png", Image8(1, 1, 3, 100)));
    EXPECT_TRUE(savePicture(folder_ / "beside.png", Image8(1, 1, 3, 200)));
    EXPECT_TRUE(savePicture(folder_ / "50%25.png", Image8(1, 1, 3, 50)));
  }
  ~GltfPicture() override { fs::remove_all(folder_); }

  Result<Scene> decoded(const std::string& json) const {
    return decodeGltf(Bytes(json.begin(), json.end()), folder_ / "model.gltf");
  }

  /// A triangle whose base colour is an image.
  Result<Scene> withImage(const std::string& image) const {
    GltfMaker maker;
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    return decoded(maker.gltf(R"({"attributes":{"POSITION":0},"material":0})",
                              R"("images":[)" + image + R"(],"textures":[{"source":0}],"materials":[)" +
                                  R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])"));
  }
  Result<Scene> withUri(const std::string& uri) const { return withImage(R"({"uri":")" + uri + "\"}"); }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("gltf_picture_" + std::to_string(::getpid()));
};

TEST_F(GltfPicture, ThatIsMissingOrDamagedIsLeftOutWithOneRemark) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"uri":"textures/not_there.png"})", "images[0].uri 'textures/not_there.png' is missing; put it beside"},
      {R"({"uri":"https://example.org/a.png"})", "'https://example.org/a.png' lies in a network; fetch it and put it"},
      {R"({"uri":"C:\\Users\\me\\tex.png"})", "is no path from the model's folder; put the file beside the model"},
      {R"({"uri":""})", "images[0].uri '' names no file"},
      {R"({"uri":"data:image/png;base64,iVBORw0KGgo="})", "images[0]: "},
      {R"({"uri":"data:image/png;base64,"})", "images[0] is empty"},
      {R"({"uri":"data:image/ktx2;base64,q0tUWCAyMLsNChoKAAAAAAEAAAA="})", "images[0]: "},
      {R"({"bufferView":0,"mimeType":"image/x-unheard"})", "images[0]: "},
      {R"({"bufferView":77})", "images[0].bufferView is 77"},
      {R"({"name":"of an extension"})", "images[0] has neither a bufferView nor a uri"}};
  for (const auto& [image, remark] : cases) {
    const Result<Scene> scene = withImage(image);
    expectTold(scene, remark);
    EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("; the picture is left out"))) << image;
    EXPECT_THAT(scene->textures, IsEmpty()) << image;
    EXPECT_EQ(scene->materials.at(0).base_color_map.texture, -1) << image;
    EXPECT_EQ(scene->materials[0].base_color, glm::vec3(1.0f)) << image;
  }
}

TEST_F(GltfPicture, IsFoundAsOtherSystemsNameIt) {
  struct Case {
    const char* uri;
    int code;
    const char* remark;  // empty: none
  };
  for (const auto& [uri, code, remark] : std::vector<Case>{
           {"Textures/Wood%20Floor.png", 100, ""},
           {"Textures/Wood Floor.png", 100, ""},
           {"Textures\\\\Wood Floor.png", 100, ""},
           {"textures/wood%20floor.PNG", 100, "is read from 'Textures/Wood Floor.png' in the model's folder"},
           {"50%25.png", 50, ""},
           {"C:\\\\Users\\\\me\\\\Beside.png", 200, "is read from 'beside.png' in the model's folder"},
           {"file:///home/me/beside.png", 200, "is read from 'beside.png'"},
           {"https://example.org/maps/beside.png", 200, "is read from 'beside.png'"},
           {"lost/beside.png", 200, "'lost/beside.png' is read from 'beside.png'"}}) {
    const Result<Scene> scene = withUri(uri);
    ASSERT_TRUE(scene) << uri << ": " << scene.error().message;
    ASSERT_EQ(scene->textures.size(), 1u) << uri;
    EXPECT_EQ(scene->textures[0].image.codes().texel(0, 0)[0], code) << uri;
    if (*remark != '\0')
      EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr(remark))) << uri;
    else
      EXPECT_THAT(scene->warnings, IsEmpty()) << uri;
  }
}

// Of three textures the second is lost; the others keep their materials' slots.
TEST_F(GltfPicture, OthersKeepTheirPlacesAndALostOneDoesNotGlow) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const Result<Scene> scene = decoded(maker.gltf(
      R"({"attributes":{"POSITION":0},"material":0})",
      R"("images":[{"uri":"beside.png"},{"uri":"lost.png"},{"uri":"Textures/Wood Floor.png"},{"uri":"lost too.png"}],)"
      R"("textures":[{"source":0},{"source":1},{"source":2},{"source":3}],"materials":[{"pbrMetallicRoughness":)"
      R"({"baseColorTexture":{"index":0}},"normalTexture":{"index":1},"occlusionTexture":{"index":2},)"
      R"("emissiveFactor":[1,1,1],"emissiveTexture":{"index":3}}])"));
  expectTold(scene,
             "images[1].uri 'lost.png' is missing; put it beside the model; the picture is left out, and so is "
             "another");
  ASSERT_EQ(scene->textures.size(), 2u);
  const Material& material = scene->materials.at(0);
  EXPECT_EQ(scene->textures.at(std::size_t(material.base_color_map.texture)).image.codes().texel(0, 0)[0], 200);
  EXPECT_EQ(material.normal_map.texture, -1);
  EXPECT_EQ(scene->textures.at(std::size_t(material.occlusion_map.texture)).image.codes().texel(0, 0)[0], 100);
  EXPECT_EQ(material.emission_map.texture, -1);
  EXPECT_EQ(material.emission, glm::vec3(0.0f));
}

// One picture of Display P3, as base colour and as roughness: the former is converted, the latter is what the file
// holds.
TEST_F(GltfPicture, ThatShowsColorsAndNumbersIsReadAsEither) {
  const testing::BmpForm p3{.header = 124, .width = 1, .height = 1, .profile = testing::iccDisplayP3()};
  ASSERT_TRUE(writeFile(folder_ / "p3.bmp", testing::bmpFile(p3, {60, 120, 200, 0})));
  for (const auto& [file, is_converted] : {std::pair("p3.bmp", true), {"beside.png", false}}) {
    GltfMaker maker;
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const Result<Scene> scene = decoded(maker.gltf(
        R"({"attributes":{"POSITION":0},"material":0})",
        R"("images":[{"uri":")" + std::string(file) + R"("}],"textures":[{"source":0}],"materials":[{)" +
            R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}}}])"));
    ASSERT_TRUE(scene) << scene.error().message;
    const auto pictureIn = [&](const TextureSlot& slot) -> const SharedPicture& {
      return scene->textures.at(std::size_t(slot.texture)).image;
    };
    const SharedPicture& colors = pictureIn(scene->materials.at(0).base_color_map);
    const SharedPicture& numbers = pictureIn(scene->materials.at(0).roughness_map);
    EXPECT_EQ(colors.isSameAs(numbers), !is_converted);
    EXPECT_EQ(colors.codes().texel(0, 0)[0], is_converted ? 213 : 200);
    EXPECT_EQ(numbers.codes().texel(0, 0)[0], 200);
  }
}

TEST(GltfRemarks, OfAllPartsThatAreAlikeIsOne) {
  gltf::Remarks remarks;
  remarks.tellOnce("images[0]", "is turned upright");
  remarks.tellOnce("images[1]", "has a profile");
  remarks.tell("is odd");
  remarks.tellOnce("images[3]", "is turned upright");
  remarks.leaveOut({ErrorCode::io, "a is damaged"}, "texture");
  for (const char* more : {"b", "c"}) remarks.leaveOut({ErrorCode::bad_file, more}, "texture");
  EXPECT_THAT(remarks.lines(),
              ElementsAre("images[0]: is turned upright, and so is another", "images[1]: has a profile", "is odd",
                          "a is damaged; the texture is left out, and so are 2 more"));
  EXPECT_EQ(remarks.firstDamage()->code, ErrorCode::io);
}

/// A triangle with as many sets of coordinates, the first corner of set i at (i, 0), whose textures use some of them.
std::string withSets(int count, const std::vector<int>& used) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  std::string attributes = R"("POSITION":0)";
  for (int i = 0; i < count; ++i)
    attributes += ",\"TEXCOORD_" + std::to_string(i) +
                  "\":" + std::to_string(maker.accessor(std::vector<float>{float(i), 0, 1, 1, 0, 1}, "VEC2"));
  const char* const maps[] = {"normalTexture", "occlusionTexture", "emissiveTexture"};
  std::string material;
  for (std::size_t i = 0; i < used.size(); ++i)
    material += (i > 0 ? "," : "") + ("\"" + std::string(maps[i])) + R"(":{"index":0,"texCoord":)" +
                std::to_string(used[i]) + "}";
  return maker.gltf(R"({"attributes":{)" + attributes + R"(},"material":0})",
                    R"("images":[{"uri":"beside.png"}],"textures":[{"source":0}],"materials":[{)" + material + "}]");
}

TEST_F(GltfPicture, AThirdSetOfCoordinatesIsReadWhereTwoAreUsed) {
  const auto firstU = [](const Scene& scene, const TextureSlot& slot) {
    return scene.meshes.at(0)->vertices.at(0).uv[slot.uv_set].x;
  };
  for (const auto& used : std::vector<std::vector<int>>{{0, 2}, {2, 0}, {2, 3}, {3}, {1, 1}, {2}, {0, 1}}) {
    const Result<Scene> scene = decoded(withSets(4, used));
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_THAT(scene->warnings, IsEmpty());
    EXPECT_EQ(firstU(*scene, scene->materials.at(0).normal_map), float(used[0]));
    if (used.size() > 1) EXPECT_EQ(firstU(*scene, scene->materials.at(0).occlusion_map), float(used[1]));
  }
}

TEST_F(GltfPicture, OfThreeUsedSetsOfCoordinatesTheLastIsLeftOut) {
  const Result<Scene> scene = decoded(withSets(4, {3, 0, 1}));
  expectTold(scene,
             "materials[0].normalTexture.texCoord is 3, and only the sets 0 and 1 of the model are read; the "
             "texture on other coordinates is left out");
  EXPECT_EQ(scene->materials.at(0).normal_map.texture, -1);
  EXPECT_GE(scene->materials[0].occlusion_map.texture, 0);
  expectTold(decoded(withSets(1, {2147483647, 0, 1})), "texCoord is 2147483647");
}

TEST_F(GltfPicture, OfAnUnreadFormatIsTakenWhereThereIsNoOther) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const auto withTexture = [&](const std::string& texture) {
    return decoded(maker.gltf(R"({"attributes":{"POSITION":0},"material":0})",
                              R"("extensionsRequired":["KHR_texture_basisu"],"images":[{"uri":"beside.png"},)"
                              R"({"uri":"data:image/ktx2;base64,q0tUWCAyMLsNChoKAAAAAAEAAAA="}],"textures":[{)" +
                                  texture + R"(}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":)" +
                                  R"({"index":0}}}])"));
  };
  const std::string basis = R"("extensions":{"KHR_texture_basisu":{"source":1}})";
  const Result<Scene> both = withTexture(R"("source":0,)" + basis);
  expectTold(both, "what it says by KHR_texture_basisu is left out");
  EXPECT_EQ(both->textures.size(), 1u);
  const Result<Scene> alone = withTexture(basis);
  expectTold(alone, "images[1]: ");
  EXPECT_THAT(alone->textures, IsEmpty());
}

}  // namespace
}  // namespace mirrorball
