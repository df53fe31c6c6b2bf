#include <random>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mirrorball
