#include <memory>
#include <random>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::expectSafe;
using testing::GltfMaker;

TEST(GltfDraco, ACompressedMeshSurvivesRandomDamage) {
  const auto path = testing::sharedData("FlightHelmet/FlightHelmet.bin");
  if (!path) GTEST_SKIP() << "FlightHelmet is not in the shared data folder";
  const Result<Bytes> buffers = readFile(*path);
  ASSERT_TRUE(buffers);
  // The smallest of its meshes: bytes 159484 to 164359.
  const Bytes compressed(buffers->begin() + 159484, buffers->begin() + 164359);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    Bytes damaged = compressed;
    if (i > 0) damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    GltfMaker maker;
    maker.view(damaged);
    maker.rawAccessor("{\"componentType\":5126,\"count\":436,\"type\":\"VEC3\"}");
    maker.rawAccessor("{\"componentType\":5123,\"count\":2208,\"type\":\"SCALAR\"}");
    const Result<Scene> scene = decodeGltf(
        maker.glb("{\"attributes\":{\"POSITION\":0},\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":"
                  "{\"bufferView\":0,\"attributes\":{\"TEXCOORD_0\":0,\"NORMAL\":1,\"TANGENT\":2,\"POSITION\":3}}}}"),
        "model.glb");
    if (i == 0) {
      ASSERT_TRUE(scene) << scene.error().message;
    }
    if (scene) expectSafe(*scene);
  }
}

/// A triangle whose colours a compressed mesh holds as bytes: encoders do not say there that they are normalized.
Bytes compressedTriangle() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int colors = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
  const float p[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::uint8_t c[] = {255, 51, 0, 255};
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), p[0], p[1], p[2]);
  builder.SetAttributeValuesForFace(colors, draco::FaceIndex(0), c, c, c);
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(draco::Encoder().EncodeMeshToBuffer(*mesh, &buffer).ok());
  return Bytes(buffer.data(), buffer.data() + buffer.size());
}

// Cesium issue 6561: colours that gltf-pipeline had compressed were 255 times too bright.
TEST(GltfDraco, WhatIsNormalizedIsWhatTheAccessorSays) {
  for (const bool says_so : {true, false}) {
    GltfMaker maker;
    maker.view(compressedTriangle());
    maker.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3"})");
    maker.rawAccessor(R"({"componentType":5121,"count":3,"type":"VEC4")" +
                      std::string(says_so ? R"(,"normalized":true})" : "}"));
    maker.rawAccessor(R"({"componentType":5123,"count":3,"type":"SCALAR"})");
    const Result<Scene> scene = decodeGltf(
        maker.glb(R"({"attributes":{"POSITION":0,"COLOR_0":1},"indices":2,"extensions":{"KHR_draco_mesh_compression":)"
                  R"({"bufferView":0,"attributes":{"POSITION":0,"COLOR_0":1}}}})"),
        "model.glb");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
    EXPECT_EQ(scene->warnings.size(), says_so ? 0u : 1u);
  }
}

// Found by a fuzzer: the name was shown as it is.
TEST(GltfDraco, ControlCharactersOfAnAttributesNameAreNotShown) {
  GltfMaker maker;
  maker.view(compressedTriangle());
  maker.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3"})");
  maker.rawAccessor(R"({"componentType":5123,"count":3,"type":"SCALAR"})");
  const Result<Scene> scene =
      decodeGltf(maker.glb(R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":)"
                           R"({"bufferView":0,"attributes":{"BE\u0007L":9}}}})"),
                 "model.glb");
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message.find("no attribute 9"), std::string::npos) << scene.error().message;
  EXPECT_EQ(scene.error().message, printable(scene.error().message));
}

}  // namespace
}  // namespace mirrorball
