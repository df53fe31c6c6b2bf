// Animations of glTF files: nodes, morph targets, and what JSON pointers lead to. Skins: gltf_skin_test.cpp.

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_animation_testing.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

using testing::AnimationMaker;
using testing::decodedPose;
using testing::decodedScene;
using ::testing::ElementsAre;
using testing::expectFinite;
using testing::expectOutside;
using testing::expectPlace;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::placeOf;
using testing::TriangleFile;

TEST(GltfAnimation, MovesNodesAndWhatHangsOnThem) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":1,"path":"translation")", {0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3")
      .move(R"("node":0,"path":"scale")", {1, 3}, {1, 1, 1, 3, 3, 3}, "VEC3");
  const Scene rest = decodedScene(
      file.json(R"("nodes":[{"children":[1],"translation":[0,0,5]},{"children":[2]},{"mesh":0}],"animations":[)" +
                walk.json() + "]"));
  EXPECT_THAT(rest.warnings, IsEmpty());
  ASSERT_EQ(rest.rig.animations.size(), 1u);
  EXPECT_EQ(rest.rig.animations[0].name, "Walk");
  EXPECT_EQ(rest.rig.animations[0].length_s, 3.0f);
  expectPlace(placeOf(rest, 0, 1), {1, 0, 5});
  expectPlace(placeOf(decodedPose(rest, 0.0), 0, 1), {1, 0, 5});
  expectPlace(placeOf(decodedPose(rest, 1.0), 0, 1), {3, 0, 5});
  expectPlace(placeOf(decodedPose(rest, 2.0), 0, 1), {2 * 5, 0, 5});
  expectPlace(placeOf(decodedPose(rest, 99.0), 0, 1), {3 * 5, 0, 5});
  EXPECT_TRUE(decodedPose(rest, 1.0).rig.animations.empty()) << "a moment has no other moments";
}

TEST(GltfAnimation, NodesAreATreeThatCanBeMovedByHand) {
  TriangleFile file;
  Scene scene = decodedScene(
      file.json(R"("nodes":[{"name":"arm","children":[1,2]},{"mesh":0,"name":"hand"},{"mesh":0,"scale":[-1,1,1]}])"));
  ASSERT_EQ(scene.rig.nodes.size(), 3u);
  EXPECT_EQ(scene.rig.nodes[0].name, "arm");
  EXPECT_EQ(scene.rig.nodes[1].name, "hand");
  EXPECT_EQ(scene.rig.nodes[1].parent, 0);
  EXPECT_EQ(scene.instances[1].node, 2);
  const std::size_t meshes = scene.meshes.size();
  ASSERT_TRUE(placeNode(scene, 0, {.translation = {0, 7, 0}}));
  expectPlace(placeOf(scene, 0, 1), {1, 7, 0});
  expectPlace(placeOf(scene, 1, 1), {-1, 7, 0});
  expectOutside(scene);
  EXPECT_EQ(scene.meshes.size(), meshes) << "the mirror image is there already";
  const auto failed = placeNode(scene, 1, {.scale = glm::dvec3(1e40)});
  ASSERT_FALSE(failed);
  expectPlace(placeOf(scene, 0, 1), {1, 7, 0});
}

// What an animation shows at a time can be moved on from there.
TEST(GltfAnimation, AMomentHasItsNodesWhereTheyAreThen) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"translation")", {0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3");
  const Scene rest =
      decodedScene(file.json(R"("nodes":[{"children":[1]},{"mesh":0}],"animations":[)" + walk.json() + "]"));
  Scene moment = decodedPose(rest, 1.0);
  EXPECT_EQ(moment.rig.nodes.at(0).place.translation, glm::dvec3(2, 0, 0));
  ASSERT_TRUE(placeNode(moment, 1, {.translation = {0, 0, 1}}));
  expectPlace(placeOf(moment, 0, 0), {2, 0, 1});
}

TEST(GltfAnimation, StandsUprightAtAnyTime) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"translation")", {0, 1}, {0, 0, 0, 0, 0, 7}, "VEC3");
  Scene rest = decodedScene(file.json(R"("animations":[)" + walk.json() + "]"));
  standUpright(rest, UpAxis::z);
  Scene later = decodedPose(rest, 1.0);
  expectPlace(placeOf(later, 0, 1), {1, 7, 0});
}

TEST(GltfAnimation, CamerasAndLightsMoveWithTheirNodes) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  const float half = std::sqrt(0.5f);
  walk.move(R"("node":1,"path":"rotation")", {0, 1}, {0, 0, 0, 1, 0, half, 0, half}, "VEC4")
      .move(R"("node":1,"path":"translation")", {0, 1}, {0, 0, 0, 2, 0, 0}, "VEC3");
  const Scene rest = decodedScene(
      file.json(R"("extensionsUsed":["KHR_lights_punctual"],)"
                R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot"}]}},)"
                R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":1}}],"nodes":[{"mesh":0},)"
                R"({"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}],"animations":[)" +
                walk.json() + "]"));
  const Scene later = decodedPose(rest, 1.0);
  // Turned by 90° about +Y, −Z goes to −X.
  expectPlace(-glm::vec3(later.cameras.at(0).world_from_view[2]), {-1, 0, 0});
  expectPlace(glm::vec3(later.cameras.at(0).world_from_view[3]), {2, 0, 0});
  expectPlace(later.lights.at(0).direction, {-1, 0, 0});
  expectPlace(later.lights.at(0).position, {2, 0, 0});
}

TEST(GltfAnimation, AScaleOfNothingHidesAndBelowItMirrors) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"scale")", {0, 1, 2}, {0, 0, 0, 1, 1, 1, -1, 1, 1}, "VEC3");
  const std::string nodes = R"("nodes":[{"mesh":0,"scale":[0,0,0]},{"mesh":0,"translation":[0,0,9]}],"animations":[)";
  const Scene rest = decodedScene(file.json(nodes + walk.json() + "]"));
  EXPECT_EQ(rest.instances.size(), 1u);
  EXPECT_EQ(decodedPose(rest, 0.0).instances.size(), 1u);
  const Scene shown = decodedPose(rest, 1.0);
  ASSERT_EQ(shown.instances.size(), 2u);
  expectOutside(shown);
  const Scene flat = decodedPose(rest, 1.5);
  EXPECT_EQ(flat.instances.size(), 1u) << "what is flat has no outside";
  const Scene mirrored = decodedPose(rest, 2.0);
  ASSERT_EQ(mirrored.instances.size(), 2u);
  EXPECT_NE(mirrored.instances[0].mesh, mirrored.instances[1].mesh);
  expectOutside(mirrored);
  EXPECT_EQ(mirrored.meshes[std::size_t(mirrored.instances[0].mesh)]->vertices[0].tangent.w,
            -mirrored.meshes[std::size_t(mirrored.instances[1].mesh)]->vertices[0].tangent.w);
}

TEST(GltfAnimation, AllPosesTogetherAreSeenAtOnce) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"translation")", {0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3");
  const Scene rest = decodedScene(file.json(R"("animations":[)" + walk.json() + "]"));
  const std::vector<double> times{0.0, 1.0, 2.0};
  const Result<Scene> all = posesTogether(rest, 0, times);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->instances.size(), 3u);
  EXPECT_EQ(all->meshes.size(), 1u) << "what does not bend is there once";
  EXPECT_EQ(boundingBox(*all).high.x, 5.0f);
}

TEST(GltfAnimation, AChangedSceneIsNotPosed) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"weights")", {0}, {1}, "SCALAR");
  Scene rest = decodedScene(file.json(R"("animations":[)" + walk.json() + "]", file.targets(file.raised(1))));
  rest.meshes[0].edit().vertices.emplace_back();
  const Result<Scene> refused = posed(rest, 0, 0.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_shape);
}

// --- morph targets

TEST(GltfMorph, WeighsSparseTargets) {
  TriangleFile file;
  const int raised = file.raised(2);  // sparse: the third vertex alone
  const int pushed = file.maker.accessor(std::vector<float>{0, 0, 0, 2, 0, 0, 0, 0, 0}, "VEC3");
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"weights")", {0, 1}, {0, 0, 0.5, 2}, "SCALAR");
  const std::string targets = file.targets(raised) + ",{\"POSITION\":" + std::to_string(pushed) + "}";
  const Scene rest = decodedScene(file.json(R"("animations":[)" + walk.json() + "]", targets));
  EXPECT_THAT(rest.warnings, IsEmpty());
  const Scene later = decodedPose(rest, 1.0);
  expectPlace(placeOf(later, 0, 0), {0, 0, 0});
  expectPlace(placeOf(later, 0, 1), {1 + 2 * 2, 0, 0});
  expectPlace(placeOf(later, 0, 2), {0, 1, 0.5});
  const Scene between = decodedPose(rest, 0.5);
  expectPlace(placeOf(between, 0, 1), {3, 0, 0});
  expectPlace(placeOf(between, 0, 2), {0, 1, 0.25});
}

TEST(GltfMorph, WeightsCountAtRest) {
  TriangleFile file;
  const std::string targets = file.targets(file.raised(2));
  const Scene of_node =
      decodedScene(file.json(R"("nodes":[{"mesh":0,"weights":[3]},{"mesh":0},{"mesh":0,"weights":[-1]}])", targets));
  ASSERT_EQ(of_node.instances.size(), 3u);
  expectPlace(placeOf(of_node, 0, 2), {0, 1, 3});
  expectPlace(placeOf(of_node, 1, 2), {0, 1, 0});
  expectPlace(placeOf(of_node, 2, 2), {0, 1, -1});
  EXPECT_EQ(of_node.rig.nodes.at(2).weights, std::vector<float>{-1.0f});
  EXPECT_EQ(decodedScene(file.json("", targets)).meshes.size(), 1u);
}

TEST(GltfMorph, TurnsNormalsAndTangents) {
  TriangleFile file;
  const int turned = file.maker.accessor(std::vector<float>{0, 1, -1, 0, 1, -1, 0, 1, -1}, "VEC3");
  const Scene scene =
      decodedScene(file.json(R"("nodes":[{"mesh":0,"weights":[1]}])", "{\"NORMAL\":" + std::to_string(turned) + "}"));
  for (const Vertex& vertex : scene.meshes.at(0)->vertices) {
    expectPlace(vertex.normal, {0, 1, 0});
    EXPECT_NEAR(glm::dot(vertex.normal, glm::vec3(vertex.tangent)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-6f);
  }
}

TEST(GltfMorph, AFlatMeshStaysFlat) {
  TriangleFile file;
  file.has_normals = false;
  // The third corner goes up until the triangle stands: (1,0,0) × (0,1,2).
  const Scene scene = decodedScene(file.json(R"("nodes":[{"mesh":0,"weights":[2]}])", file.targets(file.raised(2))));
  for (const Vertex& vertex : scene.meshes.at(0)->vertices)
    expectPlace(vertex.normal, glm::normalize(glm::vec3(0, -2, 1)));
  // What is bent to a line has no normal, and keeps one.
  const int onto_x = file.maker.accessor(std::vector<float>{0, 0, 0, 0, 0, 0, 1, -1, 0}, "VEC3");
  const Scene line =
      decodedScene(file.json(R"("nodes":[{"mesh":0,"weights":[1]}])", "{\"POSITION\":" + std::to_string(onto_x) + "}"));
  expectFinite(line);
}

TEST(GltfMorph, VerticesThatTangentsSplitMoveTogether) {
  GltfMaker maker;
  // A square whose right half shows the picture in a mirror: its middle vertices are split.
  maker.accessor(std::vector<float>{-1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  maker.accessor(std::vector<float>{0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0}, "VEC2");
  maker.accessor(std::vector<std::uint8_t>{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, "SCALAR");
  maker.accessor(std::vector<float>{0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0}, "VEC3");
  const Scene scene = decodedScene(
      maker.gltf(R"({"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"targets":[{"POSITION":4}]})",
                 R"("nodes":[{"mesh":0,"weights":[1]}])"));
  const std::vector<Vertex>& vertices = scene.meshes.at(0)->vertices;
  ASSERT_EQ(vertices.size(), 8u);
  for (const Vertex& vertex : vertices) EXPECT_EQ(vertex.position.z, vertex.position.x == 0.0f ? 3.0f : 0.0f);
}

TEST(GltfMorph, TheMirrorImageMorphsToo) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"weights")", {0, 1}, {0, 2}, "SCALAR")
      .move(R"("node":0,"path":"scale")", {0, 1}, {1, 1, 1, -1, 1, 1}, "VEC3", "STEP");
  const Scene rest = decodedScene(file.json(
      R"("nodes":[{"mesh":0,"scale":[-1,1,1]}],"animations":[)" + walk.json() + "]", file.targets(file.raised(2))));
  expectOutside(rest);
  const float rest_w = rest.meshes.at(0)->vertices.at(0).tangent.w;
  const Scene begin = decodedPose(rest, 0.0), end = decodedPose(rest, 1.0);
  expectOutside(begin);
  expectOutside(end);
  EXPECT_EQ(begin.meshes.at(0)->vertices.at(0).tangent.w, -rest_w);
  EXPECT_EQ(end.meshes.at(0)->vertices.at(0).tangent.w, rest_w);
}

// --- JSON pointers

TEST(GltfPointer, MovesMaterials) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.point("/materials/0/pbrMetallicRoughness/baseColorFactor", {0, 1}, {0, 0, 0, 0, 1, 0.5, 0, 1}, "VEC4")
      .point("/materials/0/pbrMetallicRoughness/roughnessFactor", {0, 1}, {0, 9}, "SCALAR")
      .point("/materials/0/emissiveFactor", {0, 1}, {0, 0, 0, 2, 4, 6}, "VEC3")
      .point("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", {0, 1}, {1, 3}, "SCALAR")
      .point("/materials/0/extensions/KHR_materials_transmission/transmissionFactor", {0, 1}, {0, 1}, "SCALAR")
      .point("/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset", {0, 1},
             {0, 0, 4, 8}, "VEC2")
      .point("/materials/0/pbrMetallicRoughness/metallicRoughnessTexture/extensions/KHR_texture_transform/rotation",
             {0, 1}, {0, 2}, "SCALAR");
  const Scene rest = decodedScene(file.json(
      R"("materials":[{"alphaMode":"BLEND","emissiveFactor":[0.5,0.25,0]},{}],"animations":[)" + walk.json() + "]", "",
      ",\"material\":0"));
  EXPECT_THAT(rest.warnings, IsEmpty());
  const Material half = decodedPose(rest, 0.5).materials.at(0);
  expectPlace(half.base_color, {0.5, 0.25, 0});
  EXPECT_NEAR(half.opacity, 0.5f, 1e-6f);
  EXPECT_EQ(half.perceptual_roughness, 1.0f) << "cut to its range";
  expectPlace(half.emission, glm::vec3(1, 2, 3) * 2.0f);
  EXPECT_EQ(half.transmission, 0.5f);
  EXPECT_TRUE(half.thin_walled) << "it has no thickness";
  EXPECT_EQ(half.base_color_map.offset, glm::vec2(2, 4));
  EXPECT_EQ(half.metallic_map.rotation_rad, 1.0f);
  EXPECT_EQ(half.roughness_map.rotation_rad, 1.0f);
  // Another material for all stays what it is.
  Scene gold = rest;
  ASSERT_TRUE(changeMaterials(gold, {.material = "gold"}));
  const glm::vec3 color = gold.materials.at(0).base_color;
  EXPECT_EQ(decodedPose(gold, 0.5).materials.at(0).base_color, color);
}

TEST(GltfPointer, MovesLightsAndCameras) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  const std::string lamp = "/extensions/KHR_lights_punctual/lights/0/";
  walk.point(lamp + "intensity", {0, 1}, {0, 10}, "SCALAR")
      .point(lamp + "range", {0, 1}, {2, 4}, "SCALAR")
      .point(lamp + "spot/outerConeAngle", {0, 1}, {0.5f, 0.7f}, "SCALAR")
      .point("/extensions/KHR_lights_punctual/lights/1/color", {0, 1}, {1, 1, 1, 0, 0, 1}, "VEC3")
      .point("/cameras/0/perspective/yfov", {0, 1}, {0.4f, 0.8f}, "SCALAR")
      .point("/cameras/1/orthographic/ymag", {0, 1}, {1, 5}, "SCALAR")
      .point("/nodes/0/translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "VEC3");
  const Scene rest = decodedScene(
      file.json(R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","color":[1,0.5,0],"intensity":0},)"
                R"({"type":"point","intensity":6}]}},)"
                R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":1}},)"
                R"({"type":"orthographic","orthographic":{"xmag":4,"ymag":2,"znear":0,"zfar":9}}],)"
                R"("nodes":[{"mesh":0},{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}},)"
                R"({"camera":1,"extensions":{"KHR_lights_punctual":{"light":1}}},)"
                R"({"extensions":{"KHR_lights_punctual":{"light":1}}}],"animations":[)" +
                walk.json() + "]"));
  const Scene half = decodedPose(rest, 0.5);
  expectPlace(half.lights.at(0).color, {5, 2.5, 0});
  EXPECT_NEAR(half.lights[0].range, 3.0f, 1e-6f);
  EXPECT_NEAR(half.lights[0].cosine_outer, std::cos(0.6f), 1e-6f);
  EXPECT_EQ(half.lights[0].cosine_inner, 1.0f);
  for (const std::size_t light : {1, 2}) expectPlace(half.lights.at(light).color, {3, 3, 6});
  EXPECT_NEAR(half.cameras.at(0).fov_rad, 0.6f, 1e-6f);
  EXPECT_NEAR(half.cameras.at(1).height, 6.0f, 1e-6f);
  EXPECT_NEAR(half.cameras[1].aspect * half.cameras[1].height, 8.0f, 1e-5f) << "as wide as before";
  expectPlace(placeOf(half, 0, 0), {1, 0, 0});
}

TEST(GltfPointer, LeavesOutTheRestWithOneRemark) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  for (const char* pointer : {"/nodes/0/extras/speed", "/nodes/1/extras/speed", "/materials/0/extras", "/asset/version",
                              "nonsense", "/nodes/0", "/nodes/0/extensions/KHR_node_visibility/visible"})
    walk.point(pointer, {0, 1}, {0, 1}, "SCALAR");
  walk.move(R"("node":0,"path":"colour")", {0, 1}, {0, 1}, "SCALAR")
      .move(R"("path":"translation")", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3")
      .move(R"("node":0,"path":"translation")", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3")
      .move(R"("node":0,"path":"translation")", {0, 1}, {0, 0, 0, 5, 0, 0}, "VEC3")
      .move(R"("node":1,"path":"translation")", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3");
  const Scene rest = decodedScene(
      file.json(R"("materials":[{}],"nodes":[{"mesh":0},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,3,0,0,1]}],"animations":[)" +
                walk.json() + "]"));
  EXPECT_THAT(rest.warnings,
              ElementsAre(HasSubstr("what its animations change by /nodes/N/extras/speed, /materials/N/extras, "
                                    "/asset/version, nonsense, /nodes/N, "
                                    "/nodes/N/extensions/KHR_node_visibility/visible and /nodes/N/colour is left out"),
                          HasSubstr("change the same, all but the first are left out"),
                          HasSubstr("nodes that have a matrix stand still")));
  expectPlace(placeOf(decodedPose(rest, 1.0), 0, 0), {1, 0, 0});
}

TEST(GltfAnimation, NamesAreUnlikeEachOther) {
  TriangleFile file;
  const std::string still = AnimationMaker(file.maker).json(), nameless = R"({"samplers":[],"channels":[]})";
  const Scene rest =
      decodedScene(file.json(R"("animations":[)" + still + "," + still + "," + nameless + "," + nameless + "]"));
  std::vector<std::string> names;
  for (const Animation& animation : rest.rig.animations) names.push_back(animation.name);
  EXPECT_THAT(names, ElementsAre("Walk", "Walk 2", "animation", "animation 2"));
  expectPlace(placeOf(decodedPose(rest, 1.0), 0, 1), {1, 0, 0});
}

}  // namespace
}  // namespace mirrorball
