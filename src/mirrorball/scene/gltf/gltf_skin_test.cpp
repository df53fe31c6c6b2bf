// Skins of glTF files.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/gltf/gltf_animation_testing.h"

namespace mirrorball {
namespace {

using testing::AnimationMaker;
using testing::decodedPose;
using testing::decodedScene;
using testing::decodedText;
using ::testing::ElementsAre;
using testing::expectFinite;
using testing::expectOutside;
using testing::expectPlace;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::placeOf;
using testing::TriangleFile;

/// The attributes of a triangle whose corners hang on joints.
std::string hanging(TriangleFile& file, const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
  const int on = file.maker.accessor(joints, "VEC4"), by = file.maker.accessor(weights, "VEC4");
  return ",\"JOINTS_0\":" + std::to_string(on) + ",\"WEIGHTS_0\":" + std::to_string(by);
}

/// Each corner hangs on its own joint.
std::string eachOnItsOwn(TriangleFile& file) {
  return hanging(file, {0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
}

/// A matrix that moves by −x, column by column.
std::vector<float> back(float x) { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, 0, 0, 1}; }

std::string matrices(TriangleFile& file, const std::vector<std::vector<float>>& list) {
  std::vector<float> all;
  for (const std::vector<float>& each : list) all.insert(all.end(), each.begin(), each.end());
  return "\"inverseBindMatrices\":" + std::to_string(file.maker.accessor(all, "MAT4"));
}

TEST(GltfSkin, TheJointsAloneMoveIt) {
  TriangleFile file;
  const std::string attributes = eachOnItsOwn(file);
  const std::string skin = matrices(file, {back(0), back(1), back(0)}) + ",\"joints\":[1,2,3]";
  // The mesh's own node is far away, and mirrors, or hides what has no skin: none of it counts.
  for (const char* scale : {"-9,1,1", "0,0,0"}) {
    Scene scene =
        decodedScene(file.json(R"("nodes":[{"mesh":0,"skin":0,"translation":[50,0,0],"scale":[)" + std::string(scale) +
                                   R"(]},{},{"translation":[1,0,4]},{}],"skins":[{)" + skin + "}]",
                               "", "", attributes));
    EXPECT_THAT(scene.warnings, IsEmpty());
    ASSERT_EQ(scene.instances.size(), 1u) << scale;
    expectPlace(placeOf(scene, 0, 0), {0, 0, 0});
    expectPlace(placeOf(scene, 0, 1), {1, 0, 4});
    expectPlace(placeOf(scene, 0, 2), {0, 1, 0});
    expectOutside(scene);
    ASSERT_TRUE(placeNode(scene, 2, {.translation = {1, 0, 6}})) << "a joint by hand";
    expectPlace(placeOf(scene, 0, 0), {0, 0, 0});
    expectPlace(placeOf(scene, 0, 1), {1, 0, 6});
  }
}

TEST(GltfSkin, WeighsItsJoints) {
  TriangleFile file;
  const std::string attributes =
      hanging(file, {0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 7, 0}, {0.25, 0.75, 0, 0, 2, 6, 0, 0, 0, 0, 0, 0});
  const Scene scene = decodedScene(file.json(
      R"("nodes":[{"mesh":0,"skin":0},{},{"translation":[0,0,4]}],"skins":[{"joints":[1,2]}])", "", "", attributes));
  expectPlace(placeOf(scene, 0, 0), {0, 0, 3});
  expectPlace(placeOf(scene, 0, 1), {1, 0, 3});  // weights are shares
  expectPlace(placeOf(scene, 0, 2), {0, 1, 4});  // without a weight the first joint carries it
}

TEST(GltfSkin, HasMoreThan64Joints) {
  constexpr int kJoints = 70;
  TriangleFile file;
  const std::string attributes =
      hanging(file, {0, 0, 0, 0, 69, 0, 0, 0, 65, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  // A chain: each joint is the child of the one before it, 1 unit farther.
  std::string nodes = R"("nodes":[{"mesh":0,"skin":0})", joints;
  std::vector<std::vector<float>> binds;
  for (int i = 1; i <= kJoints; ++i) {
    const std::string child = i < kJoints ? ",\"children\":[" + std::to_string(i + 1) + "]" : "";
    nodes += R"(,{"translation":[)" + std::to_string(i == 1 ? 0 : 1) + ",0,0]" + child + "}";
    joints += (i == 1 ? "" : ",") + std::to_string(i);
    binds.push_back(back(static_cast<float>(i - 1)));
  }
  const std::string skin = matrices(file, binds) + ",\"joints\":[" + joints + "]";
  AnimationMaker walk(file.maker);
  walk.move(R"("node":67,"path":"translation")", {0, 1}, {1, 0, 0, 1, 0, 5}, "VEC3");
  const Scene rest = decodedScene(
      file.json(nodes + R"(],"skins":[{)" + skin + R"(}],"animations":[)" + walk.json() + "]", "", "", attributes));
  expectPlace(placeOf(rest, 0, 1), {1, 0, 0});
  const Scene later = decodedPose(rest, 1.0);
  expectPlace(placeOf(later, 0, 0), {0, 0, 0});
  expectPlace(placeOf(later, 0, 1), {1, 0, 5});  // joint 69 is below the one that moves
  expectPlace(placeOf(later, 0, 2), {0, 1, 0});  // joint 65 is above it
}

TEST(GltfSkin, HasMoreThanFourJointsAVertex) {
  TriangleFile file;
  const std::vector<std::uint8_t> first{0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0}, second{4, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const std::string set0 = hanging(file, first, {0.1f, 0.1f, 0.1f, 0.1f, 1, 0, 0, 0, 1, 0, 0, 0});
  const int on = file.maker.accessor(second, "VEC4");
  const int by = file.maker.accessor(std::vector<float>{0.2f, 0.4f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  std::string nodes = R"("nodes":[{"mesh":0,"skin":0})";
  for (int i = 0; i < 6; ++i) nodes += R"(,{"translation":[0,0,)" + std::to_string(i) + "]}";
  const Scene scene =
      decodedScene(file.json(nodes + R"(],"skins":[{"joints":[1,2,3,4,5,6]}])", "", "",
                             set0 + ",\"JOINTS_1\":" + std::to_string(on) + ",\"WEIGHTS_1\":" + std::to_string(by)));
  expectPlace(placeOf(scene, 0, 0), {0, 0, 0.1f * (0 + 1 + 2 + 3) + 0.2f * 4 + 0.4f * 5});
}

TEST(GltfSkin, TwoSkinsShareJointsAndTheMesh) {
  TriangleFile file;
  const std::string attributes = eachOnItsOwn(file);
  const std::string near = matrices(file, {back(0), back(0), back(0)}),
                    far = matrices(file, {back(9), back(9), back(9)});
  AnimationMaker walk(file.maker);
  walk.move(R"("node":2,"path":"scale")", {0, 1}, {1, 1, 1, 3, 3, 3}, "VEC3");
  const Scene rest = decodedScene(file.json(
      R"("nodes":[{"mesh":0,"skin":0},{"mesh":0,"skin":1},{},{"mesh":0,"translation":[0,0,1]}],"skins":[{)" + near +
          R"(,"joints":[2,2,3]},{)" + far + R"(,"joints":[2,3,2]}],"animations":[)" + walk.json() + "]",
      "", "", attributes));
  ASSERT_EQ(rest.instances.size(), 3u);
  EXPECT_NE(rest.instances[0].mesh, rest.instances[1].mesh);
  const Scene later = decodedPose(rest, 1.0);
  expectPlace(placeOf(later, 0, 1), {3, 0, 0});
  expectPlace(placeOf(later, 0, 2), {0, 1, 1});
  expectPlace(placeOf(later, 1, 0), {-27, 0, 0});
  expectPlace(placeOf(later, 1, 1), {1 - 9, 0, 1});
  expectPlace(placeOf(later, 1, 2), {-27, 3, 0});
  expectPlace(placeOf(later, 2, 1), {1, 0, 1});  // without a skin it is as it was
}

TEST(GltfSkin, NormalsFollowScalesThatAreNotUniform) {
  TriangleFile file;
  const float half = std::sqrt(0.5f);
  const int slanted = file.maker.accessor(std::vector<float>{half, 0, half, half, 0, half, half, 0, half}, "VEC3");
  const int tangents =
      file.maker.accessor(std::vector<float>{half, 0, -half, 1, half, 0, -half, 1, half, 0, -half, 1}, "VEC4");
  const std::string attributes = hanging(file, std::vector<std::uint8_t>(12, 0), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}) +
                                 ",\"TANGENT\":" + std::to_string(tangents) + ",\"NORMAL\":" + std::to_string(slanted);
  file.has_normals = false;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":1,"path":"scale")", {0, 1, 2, 3, 4}, {2, 1, 1, -2, 1, 1, 0, 1, 1, 0, 0, 0, 1, 0, 1}, "VEC3");
  const Scene rest = decodedScene(
      file.json(R"("nodes":[{"mesh":0,"skin":0},{}],"skins":[{"joints":[1]}],"animations":[)" + walk.json() + "]", "",
                "", attributes));
  const Vertex stretched = decodedPose(rest, 0.0).meshes.at(0)->vertices.at(0);
  expectPlace(stretched.normal, glm::normalize(glm::vec3(0.5f, 0, 1)));
  expectPlace(glm::vec3(stretched.tangent), glm::normalize(glm::vec3(2, 0, -1)));
  EXPECT_EQ(stretched.tangent.w, 1.0f);
  const Scene mirrored = decodedPose(rest, 1.0);
  expectPlace(mirrored.meshes.at(0)->vertices.at(0).normal, glm::normalize(glm::vec3(-0.5f, 0, 1)));
  EXPECT_EQ(mirrored.meshes.at(0)->vertices.at(0).tangent.w, -1.0f);
  expectOutside(mirrored);
  for (const double flattened : {2.0, 3.0, 4.0}) expectFinite(decodedPose(rest, flattened));
  expectPlace(decodedPose(rest, 2.0).meshes.at(0)->vertices.at(0).normal, {1, 0, 0});  // flat across X
}

TEST(GltfSkin, MorphsBeforeItHangs) {
  TriangleFile file;
  const std::string attributes = hanging(file, std::vector<std::uint8_t>(12, 0), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const Scene scene = decodedScene(
      file.json(R"("nodes":[{"mesh":0,"skin":0,"weights":[1]},{"scale":[1,1,5]}],"skins":[{"joints":[1]}])",
                file.targets(file.raised(2)), "", attributes));
  expectPlace(placeOf(scene, 0, 2), {0, 1, 5});
}

TEST(GltfSkin, AFlatMeshStaysFlat) {
  TriangleFile file;
  file.has_normals = false;
  const std::string attributes = eachOnItsOwn(file);
  for (const char* lifted : {"0,0,2", "0,0,-2"}) {
    const Scene scene = decodedScene(file.json(R"("nodes":[{"mesh":0,"skin":0},{},{},{"translation":[)" +
                                                   std::string(lifted) + R"(]}],"skins":[{"joints":[1,2,3]}])",
                                               "", "", attributes));
    expectOutside(scene);
    EXPECT_NEAR(std::abs(scene.meshes.at(0)->vertices.at(0).normal.y), 2.0f / std::sqrt(5.0f), 1e-6f);
  }
}

TEST(GltfSkin, WithoutAllOfItsJointsInTheSceneIsLeftOut) {
  TriangleFile file;
  const std::string attributes = eachOnItsOwn(file);
  const Scene scene =
      decodedScene(file.json(R"("scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},{},{}],)"
                             R"("skins":[{"joints":[1,1,2]}])",
                             "", "", attributes));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("skins[0], of whose joints the scene has not all, is left out")));
  expectPlace(placeOf(scene, 0, 1), {1, 0, 0});
}

/// The mesh is shown where its node is.
void expectSkinTold(TriangleFile& file, const std::string& rest, const std::string& attributes,
                    const std::string& part) {
  const Result<Scene> scene = decodedText(file.json(rest, "", "", attributes));
  testing::expectTold(scene, part);
  if (scene) expectPlace(placeOf(*scene, 0, 1), {1, 0, 0});
}

TEST(GltfSkin, NamesTheKeyOfWhatIsWrong) {
  TriangleFile file;
  const std::string good = eachOnItsOwn(file);
  const std::string two_matrices = matrices(file, {back(0), back(0)});
  const std::string nan_matrix = matrices(file, {back(0), back(std::nanf("")), back(0)});
  const std::string nodes = R"("nodes":[{"mesh":0,"skin":0},{}],)";
  const auto reported = [&](const std::string& skins, const std::string& part) {
    expectSkinTold(file, nodes + "\"skins\":[" + skins + "]", good, part);
  };
  reported("", "nodes[0].skin is 0, but there are 0 skins");
  reported("{}", "skins[0].joints is missing");
  reported(R"({"joints":[]})", "skins[0].joints is empty");
  reported(R"({"joints":[1,1,9]})", "skins[0].joints is 9, but there are 2 nodes");
  reported(R"({"joints":[1,1]})",
           "meshes[0].primitives[0].attributes.JOINTS_0 names the joint 2, but its skin has 2 joints");
  reported("{" + two_matrices + R"(,"joints":[1,1,1]})",
           "skins[0].inverseBindMatrices has 2 elements, but there are 3 joints");
  reported("{" + nan_matrix + R"(,"joints":[1,1,1]})", "holds NaN or infinity in element 1");
  reported(R"({"inverseBindMatrices":0,"joints":[1,1,1]})", "skins[0].inverseBindMatrices has 3 components");
  reported(R"({"inverseBindMatrices":99,"joints":[1,1,1]})", "skins[0].inverseBindMatrices is 99, but there are");

  const std::string skin = nodes + R"("skins":[{"joints":[1,1,1]}])";
  const std::string only_joints = good.substr(0, good.find(",\"WEIGHTS_0"));
  expectSkinTold(file, skin, only_joints, "attributes.WEIGHTS_0 is missing, and JOINTS_0 is there");
  expectSkinTold(file, skin, ",\"JOINTS_0\":0,\"WEIGHTS_0\":0", "attributes.JOINTS_0 has 3 components");
  const int halves = file.maker.accessor(std::vector<float>(12, 0.5f), "VEC4");
  const int huge = file.maker.accessor(std::vector<float>(12, 1e9f), "VEC4");
  const int few = file.maker.accessor(std::vector<float>(8, 0.0f), "VEC4");
  const auto on = [](int joints) {
    return ",\"JOINTS_0\":" + std::to_string(joints) + ",\"WEIGHTS_0\":" + std::to_string(joints);
  };
  expectSkinTold(file, skin, on(halves), "attributes.JOINTS_0 names the joint 0.5");
  expectSkinTold(file, skin, on(huge), "attributes.JOINTS_0 names the joint 1e+09");
  expectSkinTold(file, skin, on(few), "attributes.JOINTS_0 has 2 elements, but POSITION has 3");
}

}  // namespace
}  // namespace mirrorball
