#include "mirrorball/scene/model_origin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/scene/animation/deformation.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/place_text.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A tetrahedron of about the size of 1, and where a grid of a country may have it. Its middle is no round number.
constexpr glm::dvec3 kAway(4400000.125, -3100000.5, 2.25);
const std::array<glm::dvec3, 4> kCorners{glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(1.1, 0.2, 0.3),
                                         glm::dvec3(0.1, 1.3, 0.3), glm::dvec3(0.1, 0.2, 1.5)};
constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

Scene loaded(const std::string& name, const Bytes& bytes) {
  const std::string path = ::testing::TempDir() + "mirrorball_origin_" + name;
  EXPECT_TRUE(writeFile(path, bytes));
  Result<Scene> scene = loadModel(path);
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene{};
}
Scene loaded(const std::string& name, const std::string& text) { return loaded(name, Bytes(text.begin(), text.end())); }

std::string spaced(glm::dvec3 place) {
  std::string text = writtenPlace(place);
  for (char& letter : text)
    if (letter == ',') letter = ' ';
  return text;
}

std::string objAt(glm::dvec3 away) {
  std::string text;
  for (const glm::dvec3& corner : kCorners) text += "v " + spaced(corner + away) + "\n";
  for (const auto& face : kFaces)
    text += "f " + std::to_string(face[0] + 1) + " " + std::to_string(face[1] + 1) + " " + std::to_string(face[2] + 1) +
            "\n";
  return text;
}

std::string stlAt(glm::dvec3 away) {
  std::string text = "solid a\n";
  for (const auto& face : kFaces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : face) text += "vertex " + spaced(kCorners[std::size_t(corner)] + away) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a\n";
}

/// A binary PLY of numbers of that type.
template <typename Number>
Bytes plyAt(glm::dvec3 away) {
  const std::string type = sizeof(Number) == 4 ? "float" : "double";
  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty " + type +
                             " x\nproperty " + type + " y\nproperty " + type +
                             " z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  Bytes bytes(header.begin(), header.end());
  const auto put = [&](auto number) {
    const auto* const begin = reinterpret_cast<const std::uint8_t*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof number);
  };
  for (const glm::dvec3& corner : kCorners)
    for (int axis = 0; axis < 3; ++axis) put(static_cast<Number>(corner[axis] + away[axis]));
  for (const auto& face : kFaces) {
    put(std::uint8_t{3});
    for (const int corner : face) put(std::int32_t{corner});
  }
  return bytes;
}

/// The members of a glTF's root, with those nodes, of which the first is the root.
Bytes gltfWith(const std::string& nodes, glm::dvec3 away = glm::dvec3(0.0)) {
  GltfMaker maker;
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  for (const glm::dvec3& corner : kCorners)
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(corner[axis] + away[axis]));
  for (const auto& face : kFaces)
    for (const int corner : face) indices.push_back(std::uint32_t(corner));
  maker.accessor(positions, "VEC3");
  maker.accessor(indices, "SCALAR");
  const std::string lamp = R"("extensionsUsed":["KHR_lights_punctual"],)"
                           R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}},)";
  const std::string camera = R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)";
  return maker.glb(R"({"attributes":{"POSITION":0},"indices":1})",
                   lamp + camera + R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "]");
}

/// The places of a scene's triangles in its file's coordinates, as what draws them has them.
std::vector<glm::dvec3> placesIn(const Scene& scene) {
  std::vector<glm::dvec3> places;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    for (const std::uint32_t index : mesh.indices) {
      const glm::vec4 place = instance.world_from_object * glm::vec4(mesh.vertices[index].position, 1.0f);
      places.push_back(glm::dvec3(place) + scene.origin);
    }
  }
  return places;
}

/// Whether a scene has the tetrahedron there, and numbers that floats hold.
void expectTetrahedronAt(const Scene& scene, glm::dvec3 away, double error) {
  const std::vector<glm::dvec3> places = placesIn(scene);
  ASSERT_EQ(places.size(), 12u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 right = kCorners[std::size_t(kFaces[i / 3][i % 3])] + away;
    EXPECT_LT(glm::distance(places[i], right), error) << i;
  }
  for (const Mesh& mesh : scene.meshes)
    for (const Vertex& vertex : mesh.vertices) EXPECT_LT(glm::length(vertex.position), 8.0f);
}

TEST(ModelOrigin, IsZeroForAModelThatIsNotFarAway) {
  EXPECT_EQ(originFor(DoubleBox{}), glm::dvec3(0.0));
  EXPECT_EQ(originFor(DoubleBox{glm::dvec3(-1.0), glm::dvec3(1.0)}), glm::dvec3(0.0));
  EXPECT_EQ(originFor(DoubleBox{glm::dvec3(98, -1, -1), glm::dvec3(100, 1, 1)}), glm::dvec3(0.0));
  const Scene near = loaded("near.obj", objAt(glm::dvec3(0.0)));
  EXPECT_EQ(near.origin, glm::dvec3(0.0));
  EXPECT_THAT(near.warnings, IsEmpty());
  EXPECT_EQ(near.meshes[0]->vertices[near.meshes[0]->indices[0]].position, glm::vec3(0.1f, 0.2f, 0.3f));
}

TEST(ModelOrigin, HasFewDigitsAndIsNearTheMiddle) {
  EXPECT_EQ(originFor(DoubleBox{glm::dvec3(4400000.2, 0.0, -0.4), glm::dvec3(4400001.9, 1.0, 0.6)}),
            glm::dvec3(4400001.0, 1.0, 0.0));
  EXPECT_EQ(writtenPlace(originFor(DoubleBox{glm::dvec3(0.43211, 5.0, 0.0), glm::dvec3(0.43213, 5.00001, 0.0)})),
            "0.43212,5.00001,0");
  EXPECT_EQ(originFor(DoubleBox{glm::dvec3(7.0), glm::dvec3(7.0)}), glm::dvec3(7.0)) << "a single point";
  const std::array<glm::dvec3, 3> some{glm::dvec3(NAN), glm::dvec3(5e6, 0.0, 0.0), glm::dvec3(5e6, 2.0, 0.0)};
  EXPECT_EQ(originFor(some), glm::dvec3(5e6, 1.0, 0.0));
}

TEST(ModelOrigin, TextsAndDoublesAreReadAsPreciselyAsNearTheOrigin) {
  for (const Scene& scene :
       {loaded("far.obj", objAt(kAway)), loaded("far.stl", stlAt(kAway)), loaded("far.ply", plyAt<double>(kAway))}) {
    expectTetrahedronAt(scene, kAway, 1e-6);
    EXPECT_NE(scene.origin, glm::dvec3(0.0));
    EXPECT_EQ(scene.vertex_step, 0.0);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0],
                HasSubstr("radii from the origin of its coordinates: drawn about 4400000.7,-3099999.8,3.2"));
  }
}

TEST(ModelOrigin, FloatsAreAsTheyWereRoundedAndThatIsTold) {
  const auto rounded = [](glm::dvec3 place) { return glm::dvec3(glm::vec3(place)); };
  for (const Scene& scene :
       {loaded("floats.ply", plyAt<float>(kAway)), loaded("floats.glb", gltfWith(R"({"mesh":0})", kAway))}) {
    const std::vector<glm::dvec3> places = placesIn(scene);
    ASSERT_EQ(places.size(), 12u);
    for (std::size_t i = 0; i < places.size(); ++i)
      EXPECT_LT(glm::distance(places[i], rounded(kCorners[std::size_t(kFaces[i / 3][i % 3])] + kAway)), 1e-6);
    for (const Vertex& vertex : scene.meshes[0]->vertices) EXPECT_LT(glm::length(vertex.position), 8.0f);
    EXPECT_EQ(scene.vertex_step, 0.5) << "from 2^22 to 2^23";
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], HasSubstr("its 32-bit vertices are rounded to 0.5"));
  }
}

TEST(ModelOrigin, NodesAreMultipliedBeforeItIsTakenOff) {
  const std::string there = R"("translation":[4400000.125,-3100000.5,2.25])";
  expectTetrahedronAt(loaded("node.glb", gltfWith(R"({"mesh":0,)" + there + "}")), kAway, 1e-6);
  const std::string nested =
      R"({"children":[1],"translation":[4400000,-3100000,-1e6]},)"
      R"({"children":[2],"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0.125,-0.5,1000002.25,1]},{"mesh":0})";
  expectTetrahedronAt(loaded("nested.glb", gltfWith(nested)), kAway, 1e-6);
  // Numbers of which floats have no digit at the model's size: 10⁹ away.
  expectTetrahedronAt(loaded("farther.glb", gltfWith(R"({"mesh":0,"translation":[3e9,0.25,-5e9]})")),
                      glm::dvec3(3e9, 0.25, -5e9), 2e-6);
}

// What CAD programs write whose models have the coordinates of a map: vertices there, and a node that brings them back.
TEST(ModelOrigin, VerticesThatANodeBringsBackAreRoundedOnceAlone) {
  const Scene scene = loaded("back.glb", gltfWith(R"({"mesh":0,"translation":[-4400000,3100000,0]})", kAway));
  EXPECT_EQ(scene.origin, glm::dvec3(0.0));
  EXPECT_EQ(scene.vertex_step, 0.5);
  const glm::dvec3 right = glm::dvec3(glm::vec3(kCorners[0] + kAway)) + glm::dvec3(-4400000, 3100000, 0);
  EXPECT_LT(glm::distance(placesIn(scene)[0], right), 1e-6);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("far from the origin of its nodes")));
  // It moves with its node.
  Scene moved = scene;
  NodePlace place = moved.rig.nodes[0].place;
  place.translation.x += 1.0;
  ASSERT_TRUE(placeNode(moved, 0, place));
  EXPECT_LT(glm::distance(placesIn(moved)[0], right + glm::dvec3(1, 0, 0)), 1e-6);
}

// Of a node that mirrors, what is drawn is the mesh's mirror image, and that lies as far away.
TEST(ModelOrigin, MirrorImagesOfFarVerticesStayInTheirPlace) {
  const glm::dvec3 right = glm::dvec3(glm::vec3(kCorners[0] + kAway));
  const glm::dvec3 mirrored(-right.x + 4400003.0, right.y + 3100000.0, right.z);
  const std::string upright_node = R"({"mesh":0,"translation":[-4400000,3100000,0]})";
  const std::string mirror_node = R"({"mesh":0,"scale":[-1,1,1],"translation":[4400003,3100000,0]})";
  const auto hasCornerAt = [](const Scene& scene, std::size_t instance, glm::dvec3 place) {
    const auto places = placesIn(scene);
    ASSERT_GE(places.size(), 12 * instance + 12);
    double nearest = 1e30;
    for (std::size_t i = 12 * instance; i < 12 * instance + 12; ++i)
      nearest = std::min(nearest, glm::distance(places[i], place));
    EXPECT_LT(nearest, 1e-6);
  };
  const Scene alone = loaded("mirror.glb", gltfWith(mirror_node, kAway));
  hasCornerAt(alone, 0, mirrored);
  EXPECT_EQ(alone.vertex_step, 0.5);
  for (const std::string& nodes : {upright_node + "," + mirror_node, mirror_node + "," + upright_node}) {
    const bool begins_upright = nodes.starts_with(upright_node);
    const Scene both = loaded("both.glb", gltfWith(R"({"children":[1,2]},)" + nodes, kAway));
    hasCornerAt(both, begins_upright ? 0 : 1, right + glm::dvec3(-4400000, 3100000, 0));
    hasCornerAt(both, begins_upright ? 1 : 0, mirrored);
    EXPECT_EQ(both.meshes.size(), 2u) << "the mesh and its image, and no image of what it was before";
    for (const Mesh& mesh : both.meshes)
      for (const Vertex& vertex : mesh.vertices) EXPECT_LT(glm::length(vertex.position), 8.0f);
  }
}

/// A triangle at a place that floats hold, which morphs halfway by a hundredth, or hangs on a joint.
///
/// joint   how the joint lies in the world, column by column, and where that is undone
Scene bentAt(glm::dvec3 away, bool hangs, const std::string& joint = "",
             const std::vector<float>& joint_from_mesh = {}) {
  GltfMaker maker;
  std::vector<float> places;
  for (const glm::dvec3 corner : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
    for (int axis = 0; axis < 3; ++axis) places.push_back(static_cast<float>(corner[axis] + away[axis]));
  maker.accessor(places, "VEC3");
  if (!hangs) {
    maker.accessor(std::vector<float>{0, 0, 0.01f, 0, 0, 0, 0, 0, 0.03f}, "VEC3");
    return loaded("morphed.glb", maker.glb(R"({"attributes":{"POSITION":0},"targets":[{"POSITION":1}]})",
                                           R"("nodes":[{"mesh":0,"weights":[0.5]}])"));
  }
  maker.accessor(std::vector<std::uint8_t>(12, 0), "VEC4");
  maker.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  maker.accessor(joint_from_mesh, "MAT4");
  return loaded("hanging.glb", maker.glb(R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})",
                                         R"("nodes":[{"mesh":0,"skin":0},{)" + joint +
                                             R"(}],"skins":[{"joints":[1],"inverseBindMatrices":3}])"));
}

// A hundredth of the model is a fiftieth of what floats there can tell.
TEST(ModelOrigin, FarMorphTargetsMoveAsTheyDoNearTheOrigin) {
  const glm::dvec3 away(4400000, -3100000, 2);
  const Scene scene = bentAt(away, false);
  const std::vector<glm::dvec3> places = placesIn(scene);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_LT(glm::distance(places[0], away + glm::dvec3(0, 0, 0.005)), 1e-6);
  EXPECT_LT(glm::distance(places[1], away + glm::dvec3(1, 0, 0)), 1e-6);
  EXPECT_LT(glm::distance(places[2], away + glm::dvec3(0, 1, 0.015)), 1e-6);
  EXPECT_EQ(scene.vertex_step, 0.5);
}

TEST(ModelOrigin, FarSkinsTurnAsTheyDoNearTheOrigin) {
  const glm::dvec3 away(4400000, -3100000, 2);
  // By 30 degrees about +Z where the mesh is.
  const std::string turned =
      R"("translation":[4400000,-3100000,2],"rotation":[0,0,0.25881904510252074,0.9659258262890683])";
  const Scene scene = bentAt(away, true, turned, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4400000, 3100000, -2, 1});
  const std::vector<glm::dvec3> places = placesIn(scene);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_LT(glm::distance(places[0], away), 1e-6);
  EXPECT_LT(glm::distance(places[1], away + glm::dvec3(0.8660254037844387, 0.5, 0)), 1e-6);
  EXPECT_LT(glm::distance(places[2], away + glm::dvec3(-0.5, 0.8660254037844387, 0)), 1e-6);
  EXPECT_EQ(scene.vertex_step, 0.5);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("its 32-bit vertices are rounded to 0.5")));
}

// Their matrices are of 32 bits, as vertices are, and so what hangs on them is where they were rounded to.
TEST(ModelOrigin, WhatFarJointsAreRoundedToIsTold) {
  const std::string far = R"("translation":[4400000.125,0,0])";
  const Scene scene = bentAt(glm::dvec3(0.0), true, far, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4400000.125f, 0, 0, 1});
  EXPECT_EQ(scene.vertex_step, 0.5);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("lies far from the origin of its nodes; its 32-bit vertices are "
                                                    "rounded to 0.5")));
  const Scene near = bentAt(glm::dvec3(0.0), true, "", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4, 0, 0, 1});
  EXPECT_EQ(near.vertex_step, 0.0);
  EXPECT_THAT(near.warnings, IsEmpty());
}

// As a pole of inverse kinematics is, in whose direction a knee bends.
TEST(ModelOrigin, AFarJointThatNothingHangsOnIsNoMatter) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>(12, 0), "VEC4");
  maker.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  maker.accessor(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,        0, 0, 1,
                                    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1000.5f, 0, 0, 1},
                 "MAT4");
  const Scene scene = loaded("pole.glb", maker.glb(R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})",
                                                   R"("nodes":[{"mesh":0,"skin":0},{},{"translation":[1000.5,0,0]}],)"
                                                   R"("skins":[{"joints":[1,2],"inverseBindMatrices":3}])"));
  EXPECT_EQ(scene.vertex_step, 0.0);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

/// A mesh far from its two nodes, which morphs.
Result<Scene> shownTwice() {
  GltfMaker maker;
  maker.accessor(std::vector<float>{4400000, 0, 0, 4400001, 0, 0, 4400000, 1, 0}, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 0, 0, 0, 0}, "VEC3");
  const std::string json = maker.gltf(R"({"attributes":{"POSITION":0},"targets":[{"POSITION":1}]})",
                                      R"("nodes":[{"mesh":0,"weights":[0.5],"translation":[-4400000,0,0]},)"
                                      R"({"mesh":0,"weights":[0.25],"translation":[-4399998,0,0]}])");
  return decodeGltf(Bytes(json.begin(), json.end()), "twice.gltf");
}

TEST(ModelOrigin, WhatPartsShareIsMovedOnceAndInItsPlace) {
  auto scene = shownTwice();
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->rig.parts.size(), 2u);
  const auto* const before = scene->rig.parts[0].deformation.get();
  ASSERT_EQ(scene->rig.parts[1].deformation.get(), before);
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(1);
  EXPECT_TRUE(drawAboutMiddle(*scene)) << "nothing is copied";
  setMemoryLimit(usual);
  for (const RigPart& part : scene->rig.parts) {
    EXPECT_EQ(part.deformation.get(), before);
    EXPECT_NE(part.mesh_origin, glm::dvec3(0.0));
  }
  const std::vector<glm::dvec3> places = placesIn(*scene);
  ASSERT_EQ(places.size(), 6u);
  EXPECT_LT(glm::distance(places[0], glm::dvec3(0, 0, 0.5)), 1e-6);
  EXPECT_LT(glm::distance(places[3], glm::dvec3(2, 0, 0.25)), 1e-6);
}

TEST(ModelOrigin, WhatOtherScenesShareIsCopiedWhereItFits) {
  auto scene = shownTwice();
  ASSERT_TRUE(scene) << scene.error().message;
  const Scene other = *scene;
  Scene refused = *scene;
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(1);
  const Result<void> moved = drawAboutMiddle(refused);
  setMemoryLimit(usual);
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().code, ErrorCode::too_large);
  ASSERT_TRUE(drawAboutMiddle(*scene));
  EXPECT_EQ(scene->rig.parts[0].deformation, scene->rig.parts[1].deformation) << "one copy of both";
  EXPECT_EQ(other.rig.parts[0].deformation->vertices[0].position.x, 4400000.0f);
  EXPECT_LT(scene->rig.parts[0].deformation->vertices[0].position.x, 2.0f);
}

TEST(ModelOrigin, CamerasAndLightsKeepTheirPlacesAtTheModel) {
  const Scene scene =
      loaded("lit.glb", gltfWith(R"({"children":[1,2,3],"translation":[4400000.125,-3100000.5,2.25]},{"mesh":0},)"
                                 R"({"camera":0,"translation":[0.5,0,4.125]},)"
                                 R"({"extensions":{"KHR_lights_punctual":{"light":0}},"translation":[0,2.0625,0]})"));
  ASSERT_EQ(scene.cameras.size(), 1u);
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto awayFrom = [&](glm::vec3 place) { return glm::dvec3(place) + scene.origin - kAway; };
  EXPECT_LT(glm::distance(awayFrom(glm::vec3(scene.cameras[0].world_from_view[3])), glm::dvec3(0.5, 0, 4.125)), 1e-6);
  EXPECT_LT(glm::distance(awayFrom(scene.lights[0].position), glm::dvec3(0, 2.0625, 0)), 1e-6);
}

TEST(ModelOrigin, TurnsUprightWithTheModel) {
  Scene scene = loaded("upright.obj", objAt(kAway));
  const std::vector<glm::dvec3> before = placesIn(scene);
  standUpright(scene, UpAxis::z);
  const std::vector<glm::dvec3> after = placesIn(scene);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(glm::distance(after[i], glm::dvec3(before[i].x, before[i].z, -before[i].y)), 1e-6);
}

TEST(ModelOrigin, IsGivenBackByWhatIsWritten) {
  const Scene scene = loaded("export.obj", objAt(kAway));
  const auto written = encodeGlb(scene);
  ASSERT_TRUE(written);
  const Scene again = loaded("export.glb", written->bytes);
  expectTetrahedronAt(again, kAway, 1e-6);
  EXPECT_LT(glm::distance(again.origin, scene.origin), 1.0);
}

// Whole numbers of 64 bits end there.
TEST(ModelOrigin, OfAPlaceBeyondWholeNumbersIsLeftOutOfWhatIsWritten) {
  Scene scene = loaded("beyond.obj", objAt(kAway));
  for (const double away : {9e18, -9e18, 1e19, -1e29}) {
    scene.origin = glm::dvec3(0.0, away, 0.0);
    const auto written = encodeGlb(scene);
    ASSERT_TRUE(written);
    const Scene again = loaded("beyond.glb", written->bytes);
    if (std::abs(away) < 1e19) {
      EXPECT_THAT(written->left_out, IsEmpty());
      EXPECT_EQ(again.origin.y, away);
    } else {
      EXPECT_THAT(written->left_out,
                  ElementsAre(HasSubstr("is left out, as all beyond 9e+18 are: it stands about 0,0,0")));
      EXPECT_EQ(again.origin, glm::dvec3(0.0));
    }
  }
}

TEST(ModelOrigin, MovesWhatHasNoNodesToo) {
  Scene scene = loaded("moved.obj", objAt(kAway));
  scene.rig = {};
  scene.cameras.resize(1);
  scene.lights.resize(1);
  const glm::dvec3 by(8, -4, 2);
  const std::vector<glm::dvec3> before = placesIn(scene);
  ASSERT_TRUE(moveOrigin(scene, scene.origin + by));
  EXPECT_LT(glm::distance(placesIn(scene)[5], before[5]), 1e-6);
  EXPECT_EQ(glm::vec3(scene.cameras[0].world_from_view[3]), glm::vec3(-by));
  EXPECT_EQ(scene.lights[0].position, glm::vec3(-by));
}

TEST(ModelOrigin, PlacesOfOptionsAreInTheFilesCoordinates) {
  const Scene scene = loaded("places.obj", objAt(kAway));
  const BoundingSphere bounds = boundingSphere(scene);
  CameraOptions options;
  options.target = kAway + glm::dvec3(0.5, 0.25, 0.0);
  options.distance = 4.0f;
  const auto camera = framedCamera(scene, bounds, options, {64, 64});
  ASSERT_TRUE(camera) << camera.error().message;
  const glm::dvec3 looked_at =
      glm::dvec3(camera->position) + double(4.0f * bounds.radius) * glm::dvec3(camera->forward) + scene.origin;
  EXPECT_LT(glm::distance(looked_at, *options.target), 2e-6);

  const auto box = parseProxy("--proxy", "box:4399990.125,-3100010.5,-8,4400010.125,-3099990.5,12");
  ASSERT_TRUE(box);
  const auto proxy = placedProxy(*box, scene);
  ASSERT_TRUE(proxy) << proxy.error().message;
  EXPECT_LT(glm::distance(glm::dvec3(proxy->low) + scene.origin, glm::dvec3(4399990.125, -3100010.5, -8)), 2e-6);
  EXPECT_EQ(writtenProxy(*box), "box:4399990.125,-3100010.5,-8,4400010.125,-3099990.5,12");
}

TEST(PlaceText, ReadsBackWhatItWrites) {
  EXPECT_EQ(writtenPlace(glm::dvec3(0.5, -1e20, 4400000.1)), "0.5,-1e+20,4400000.1");
  EXPECT_EQ(writtenPlace(placeInFile(glm::vec3(0.3f), glm::dvec3(0.0))), "0.3,0.3,0.3") << "of a float, as that";
  EXPECT_EQ(writtenPlace(glm::dvec3(-3099999.75)), "-3099999.75,-3099999.75,-3099999.75");
  const OptionText text{.name = "at", .min_count = 3, .max_count = 3};
  EXPECT_THAT(*parseExactNumbers(text, "4400000.1,2,0.3"), ElementsAre(4400000.1, 2.0, 0.3));
  EXPECT_FALSE(parseExactNumbers(text, "1,2"));
  EXPECT_FALSE(parseExactNumbers(text, "1,2,x"));
}

}  // namespace
}  // namespace mirrorball
