// Small files that ask for much memory.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_json_text.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using testing::GltfMaker;
using ::testing::HasSubstr;

constexpr std::uint64_t kMega = std::uint64_t{1} << 20;

/// A folder with pictures beside a model; so much memory may be used as a test says.
class GltfMemory : public ::testing::Test {
 protected:
  GltfMemory() { fs::create_directories(folder_); }
  ~GltfMemory() override {
    setMemoryLimit(usual_);
    fs::remove_all(folder_);
  }

  /// A picture whose texels take 4 · side² bytes as they are kept, and 5 times as many while it is read.
  void write(const std::string& name, int side) const {
    ASSERT_TRUE(savePicture(folder_ / name, Image8(side, side, 3, 100)));
  }

  static std::string glowing(std::size_t texture) {
    return R"("emissiveTexture":{"index":)" + std::to_string(texture) + "}";
  }

  /// A model with a triangle and a material for each texture.
  ///
  /// images    by their uris
  /// textures  by their members
  ///
  /// materialOfTexture   a material's members for the texture of that index
  Result<Scene> read(const std::vector<std::string>& images, const std::vector<std::string>& textures,
                     const std::string& samplers = "[]",
                     const std::function<std::string(std::size_t)>& materialOfTexture = glowing) const {
    GltfMaker maker;
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    std::string primitives, materials, listed, uris;
    for (std::size_t i = 0; i < textures.size(); ++i) {
      const std::string comma = i > 0 ? "," : "", index = std::to_string(i);
      primitives += comma + R"({"attributes":{"POSITION":0},"material":)" + index + "}";
      materials += comma + "{" + materialOfTexture(i) + "}";
      listed += comma + "{" + textures[i] + "}";
    }
    for (const std::string& uri : images) uris += (uris.empty() ? "" : ",") + (R"({"uri":")" + uri + "\"}");
    const std::string json =
        maker.gltf(primitives, R"("images":[)" + uris + R"(],"textures":[)" + listed + R"(],"materials":[)" +
                                   materials + R"(],"samplers":)" + samplers);
    return decodeGltf(Bytes(json.begin(), json.end()), folder_ / "model.gltf");
  }

  const std::uint64_t usual_ = memoryLimit();
  const fs::path folder_ = fs::path(::testing::TempDir()) / ("gltf_memory_" + std::to_string(::getpid()));
};

// What grows would take up to thrice as much on its way.
TEST_F(GltfMemory, AMendedTextIsMadeAsLargeAsItGets) {
  std::string json = "[1,";
  for (int i = 0; i < 10'000; ++i) json += "+1,\"a\tb\",";
  const auto mended = gltf::mendJson(json + "NaN]");
  ASSERT_TRUE(mended);
  EXPECT_GT(mended->text.size(), json.size());
  EXPECT_EQ(mended->text.capacity(), mended->text.size());
}

TEST_F(GltfMemory, APictureOfManyNamesIsOneTexture) {
  write("a.png", 512);
  setMemoryLimit(8 * kMega);
  std::vector<std::string> images, textures;
  const std::string spellings[] = {"a.png", "./a.png", "%61.png"};
  for (int i = 0; i < 200; ++i) {
    images.push_back(spellings[i % 3]);
    textures.push_back(R"("source":)" + std::to_string(i));
  }
  const auto scene = read(images, textures);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->textures.size(), 1u);
  EXPECT_EQ(scene->materials.size(), 200u);
  EXPECT_EQ(scene->textures[0].image.width(), 512);
}

// Each of them would fit.
TEST_F(GltfMemory, PicturesThatAreTooLargeTogetherAreRefused) {
  std::vector<std::string> images, textures;
  for (int i = 0; i < 40; ++i) {
    write(std::to_string(i) + ".png", 256);
    images.push_back(std::to_string(i) + ".png");
    textures.push_back(R"("source":)" + std::to_string(i));
  }
  const auto all = read(images, textures);
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all->textures.size(), 40u);
  setMemoryLimit(8 * kMega);
  EXPECT_TRUE(read({images[0]}, {textures[0]}));
  const auto refused = read(images, textures);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_THAT(refused.error().message, HasSubstr("8 MB may be used"));
}

// There is a texture for each way in which a picture can go on beyond its edges, but the texels are the same.
TEST_F(GltfMemory, TexturesOfOnePictureShareItsTexels) {
  write("a.png", 512);
  std::string samplers;
  std::vector<std::string> textures;
  for (const char* wrap_s : {"10497", "33071", "33648"})
    for (const char* wrap_t : {"10497", "33071", "33648"})
      for (const char* filter : {"9728", "9729"}) {
        textures.push_back(R"("source":0,"sampler":)" + std::to_string(textures.size()));
        samplers += std::string(samplers.empty() ? "" : ",") + R"({"wrapS":)" + wrap_s + R"(,"wrapT":)" + wrap_t +
                    R"(,"magFilter":)" + filter + "}";
      }
  setMemoryLimit(8 * kMega);
  const auto all = read({"a.png"}, textures, "[" + samplers + "]");
  ASSERT_TRUE(all) << all.error().message;
  ASSERT_EQ(all->textures.size(), 18u);
  for (const Texture& each : all->textures) EXPECT_TRUE(each.image.isSameAs(all->textures[0].image));
}

// Each glossiness makes another roughness of the picture.
TEST_F(GltfMemory, PicturesThatAreChangedCountEachTime) {
  write("a.png", 512);
  const auto glossy = [](std::size_t texture) {
    return R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":)" +
           std::to_string(0.01 * double(texture + 1)) + R"(,"specularGlossinessTexture":{"index":)" +
           std::to_string(texture) + "}}}";
  };
  const std::vector<std::string> textures(20, R"("source":0)");
  ASSERT_TRUE(read({"a.png"}, textures, "[]", glossy));
  setMemoryLimit(8 * kMega);
  const auto refused = read({"a.png"}, textures, "[]", glossy);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
}

/// A list of so many equal elements.
std::string listOf(const std::string& element, int count) {
  std::string list = "[" + element;
  for (int i = 1; i < count; ++i) list += "," + element;
  return list + "]";
}

/// A model of a triangle, with more members of its root.
Result<Scene> readTriangle(const std::string& members) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::string json = maker.gltf(R"({"attributes":{"POSITION":0}})", members);
  return decodeGltf(Bytes(json.begin(), json.end()), "model.gltf");
}

// Each takes much more memory than its text.
TEST_F(GltfMemory, ManySmallPartsAreRefusedBeforeTheirMemoryIsTaken) {
  for (const std::string& part :
       {R"("extras":)" + listOf("{}", 100000), R"("extras":)" + listOf("[]", 100000),
        R"("extras":)" + listOf("0", 400000), R"("materials":)" + listOf("{}", 20000),
        R"("textures":)" + listOf("{}", 100000), R"("skins":)" + listOf(R"({"joints":[0]})", 50000),
        R"("animations":)" + listOf(R"({"channels":[],"samplers":[]})", 50000)}) {
    setMemoryLimit(8 * kMega);
    const auto refused = readTriangle(part);
    ASSERT_FALSE(refused) << part.substr(0, 50);
    EXPECT_EQ(refused.error().code, ErrorCode::too_large) << part.substr(0, 50);
    EXPECT_THAT(refused.error().message, HasSubstr("8 MB may be used")) << part.substr(0, 50);
    setMemoryLimit(usual_);
    EXPECT_TRUE(readTriangle(part)) << part.substr(0, 50);
  }
}

TEST_F(GltfMemory, ManyNodesAreRefusedBeforeTheirMemoryIsTaken) {
  constexpr int kNodes = 20000;
  const std::string flat = R"("nodes":[{"mesh":0})" + ("," + listOf("{}", kNodes).substr(1));
  std::string chain = R"("scenes":[{"nodes":[0,1]}],"scene":0,"nodes":[{"mesh":0})";
  for (int i = 2; i < kNodes; ++i) chain += R"(,{"children":[)" + std::to_string(i) + "]}";
  chain += ",{}]";
  for (const std::string& nodes : {flat, chain}) {
    setMemoryLimit(8 * kMega);
    const auto refused = readTriangle(nodes);
    ASSERT_FALSE(refused) << nodes.substr(0, 80);
    EXPECT_EQ(refused.error().code, ErrorCode::too_large) << nodes.substr(0, 80);
    setMemoryLimit(64 * kMega);
    const auto read = readTriangle(nodes);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_GE(read->rig.nodes.size(), std::size_t(kNodes));
  }
}

// The parser copies it, and it is decoded.
TEST_F(GltfMemory, ABufferInTheJsonCountsWithItsCopies) {
  const std::string image =
      R"("images":[{"uri":"data:image/png;base64,)" + std::string(std::size_t{2} << 20, 'A') + R"("}])";
  setMemoryLimit(8 * kMega);
  const auto refused = readTriangle(image);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  setMemoryLimit(usual_);
  EXPECT_TRUE(readTriangle(image));
}

// A file is asked for its size before it is read: this one has a hole of 3 GB, and takes no room on the disk.
TEST_F(GltfMemory, AFileThatDoesNotFitIsNotRead) {
  write("a.png", 4);
  fs::resize_file(folder_ / "a.png", std::uintmax_t{3} << 30u);
  setMemoryLimit(8 * kMega);
  const auto refused = read({"a.png"}, {R"("source":0)"});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("needs 3.0 GB of memory"));
}

}  // namespace
}  // namespace mirrorball
