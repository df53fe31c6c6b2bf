// What a build without Draco and meshoptimizer answers: linked instead of those that read their meshes.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

std::string answerTo(const std::string& json) {
  const Result<Scene> scene = decodeGltf(Bytes(json.begin(), json.end()), "model.gltf");
  return scene ? "is read" : scene.error().message;
}

TEST(GltfAbsent, ACompressedMeshIsAnsweredByOneLine) {
  testing::GltfMaker draco;
  draco.view(Bytes(8));
  draco.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3"})");
  EXPECT_EQ(
      answerTo(draco.gltf(R"({"attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":)"
                          R"({"bufferView":0,"attributes":{"POSITION":0}}}})")),
      "meshes[0].primitives[0]: this build reads no meshes compressed by Draco; one with MIRRORBALL_DRACO=ON does");

  EXPECT_EQ(answerTo(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"data:;base64,AAAAAA=="}],)"
                     R"("bufferViews":[{"buffer":0,"byteLength":16,"extensions":{"EXT_meshopt_compression":)"
                     R"({"buffer":0,"byteLength":4,"byteStride":16,"count":1,"mode":"ATTRIBUTES"}}}]})"),
            "bufferViews[0]: this build reads no meshes compressed by meshoptimizer; one with "
            "MIRRORBALL_MESHOPTIMIZER=ON does");
}

TEST(GltfAbsent, AMeshThatIsThereUncompressedAsWellIsRead) {
  testing::GltfMaker both;
  both.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::string json = both.gltf(R"({"attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":)"
                                     R"({"bufferView":0,"attributes":{"POSITION":0}}}})");
  testing::expectTold(decodeGltf(Bytes(json.begin(), json.end()), "model.gltf"),
                      "compressed by Draco; one with MIRRORBALL_DRACO=ON does; the compressed form of the primitive is "
                      "left out");
}

TEST(GltfAbsent, OtherMeshesAreRead) {
  testing::GltfMaker plain;
  plain.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  EXPECT_EQ(answerTo(plain.gltf(R"({"attributes":{"POSITION":0}})")), "is read");
}

}  // namespace
}  // namespace mirrorball
