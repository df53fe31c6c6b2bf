#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using testing::GltfMaker;

TEST(GltfWebp, ReadsThePictureThatTheWebpExtensionNames) {
  const Bytes webp = testing::encodedWebp(Image8(1, 1, 3, 77), 101);
  for (const std::string beside : {"", R"("source":0,)"}) {
    GltfMaker maker;
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const std::string json = maker.gltf(R"({"attributes":{"POSITION":0},"material":0})",
                                        R"("extensionsRequired":["EXT_texture_webp"],"images":[{"uri":"no_such.png"},)"
                                        R"({"mimeType":"image/webp","uri":"data:image/webp;base64,)" +
                                            GltfMaker::base64(webp) + R"("}],"textures":[{)" + beside +
                                            R"("extensions":{"EXT_texture_webp":{"source":1}}}],)"
                                            R"("materials":[{"emissiveTexture":{"index":0}}])");
    const Result<Scene> scene = decodeGltf(Bytes(json.begin(), json.end()), ::testing::TempDir() + "model.gltf");
    ASSERT_TRUE(scene) << scene.error().message;
    ASSERT_EQ(scene->textures.size(), 1u);
    EXPECT_THAT(scene->textures[0].image.samples(), ElementsAre(77, 77, 77, 255));
  }
}

}  // namespace
}  // namespace mirrorball
