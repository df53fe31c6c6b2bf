#include "mirrorball/rays/occlusion_refinement.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

std::vector<MeshRefinement> refinementsOf(const Scene& scene) {
  const auto geometry = Geometry::make(scene);
  EXPECT_TRUE(geometry);
  auto refinements = occlusionRefinements(scene, *geometry);
  EXPECT_TRUE(refinements);
  EXPECT_EQ(refinements->size(), scene.meshes.size());
  return std::move(*refinements);
}

/// A floor of two triangles, and a ball of radius 1 that stands on it.
Scene ballOnFloor(float half, glm::vec2 at) {
  Mesh floor;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)})
    floor.vertices.push_back({.position = half * glm::vec3(corner.x, 0.0f, corner.y), .normal = {0, 1, 0}});
  floor.indices = {0, 1, 2, 0, 2, 3};
  Scene scene = meshScene(std::move(floor));
  scene.meshes.push_back(sphereMesh(16, 32));
  scene.instances.push_back({.mesh = 1});
  scene.instances[1].world_from_object[3] = glm::vec4(at.x, 1.0f, at.y, 1.0f);
  return scene;
}

// Wherever it stands, the floor is cut around it and not far from it; the ball, which is fine, less than the floor.
TEST(OcclusionRefinement, AFloorIsCutWhereABallStands) {
  for (const glm::vec2 at : {glm::vec2(0.0f), glm::vec2(7.0f, -5.0f), glm::vec2(-2.0f, 9.0f)}) {
    Scene scene = ballOnFloor(12.0f, at);
    const std::vector<MeshRefinement> refinements = refinementsOf(scene);
    refine(scene.meshes[0].edit(), refinements[0]);
    std::size_t near = 0, far = 0;
    for (const Vertex& vertex : scene.meshes[0]->vertices) {
      const float distance = glm::distance(glm::vec2(vertex.position.x, vertex.position.z), at);
      near += distance < 2.0f ? 1 : 0;
      far += distance > 8.0f ? 1 : 0;
    }
    EXPECT_GT(near, 30u) << at.x;
    EXPECT_LT(far, near) << at.x;
    EXPECT_LT(refinements[1].parents.size(), refinements[0].parents.size());
  }
}

TEST(OcclusionRefinement, WhatNothingHidesIsNotCut) {
  for (const char* model : {"cube", "sphere", "plane"})
    for (const MeshRefinement& refinement : refinementsOf(*loadModel(model))) EXPECT_TRUE(refinement.empty()) << model;
}

// A ball below it, of which the side of its normal sees nothing.
TEST(OcclusionRefinement, ASheetIsCutForWhatItsBackSees) {
  Scene scene = ballOnFloor(12.0f, glm::vec2(0.0f));
  scene.instances[1].world_from_object[3].y = -1.0f;
  EXPECT_TRUE(refinementsOf(scene)[0].empty());
  scene.materials.emplace_back().double_sided = true;
  scene.meshes[0].edit().material = 1;
  EXPECT_GT(refinementsOf(scene)[0].parents.size(), 30u);
}

TEST(OcclusionRefinement, GlassIsNotCut) {
  Scene scene = ballOnFloor(12.0f, glm::vec2(0.0f));
  scene.materials[0].transmission = 1.0f;
  for (const MeshRefinement& refinement : refinementsOf(scene)) EXPECT_TRUE(refinement.empty());
}

/// Of the edges of two meshes along x = 0, in the order of z: where their ends are.
std::vector<float> endsAlongX0(const Mesh& mesh) {
  std::vector<float> ends;
  for (const std::uint32_t index : mesh.indices)
    if (const glm::vec3 p = mesh.vertices[index].position; p.x == 0.0f) ends.push_back(p.z);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

// A floor whose halves are of two materials, and a ball on one of them: where the halves meet, both are cut alike.
TEST(OcclusionRefinement, MeshesThatShareAnEdgeAreCutTogether) {
  for (const bool glass : {false, true}) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].transmission = glass ? 1.0f : 0.0f;
    for (int side = 0; side < 2; ++side) {
      Mesh half;
      half.material = side;
      for (const glm::vec2 corner :
           {glm::vec2(-side, -1), glm::vec2(-side, 1), glm::vec2(1 - side, 1), glm::vec2(1 - side, -1)})
        half.vertices.push_back({.position = 12.0f * glm::vec3(corner.x, 0.0f, corner.y), .normal = {0, 1, 0}});
      half.indices = {0, 1, 2, 0, 2, 3};
      scene.meshes.push_back(std::move(half));
      scene.instances.push_back({.mesh = side});
    }
    scene.meshes.push_back(sphereMesh(16, 32));
    scene.instances.push_back({.mesh = 2});
    scene.instances[2].world_from_object[3] = glm::vec4(1.5f, 1.0f, 2.0f, 1.0f);
    const std::vector<MeshRefinement> refinements = refinementsOf(scene);
    for (int side = 0; side < 2; ++side) refine(scene.meshes[std::size_t(side)].edit(), refinements[std::size_t(side)]);
    EXPECT_GT(endsAlongX0(scene.meshes[0]).size(), 4u);
    EXPECT_EQ(endsAlongX0(scene.meshes[0]), endsAlongX0(scene.meshes[1])) << (glass ? "glass" : "opaque");
  }
}

// Beside itself in half its size, so that what one place cuts is a half of what the other has: this once had no end.
TEST(OcclusionRefinement, AMeshBesideItselfInHalfItsSizeIsCutOnlySoFar) {
  for (const float far : {0.0f, 1e7f}) {
    Scene scene = ballOnFloor(12.0f, glm::vec2(1.5f));
    for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.position += glm::vec3(12.0f, 0.0f, 12.0f);
    scene.instances.push_back(scene.instances[0]);
    scene.instances.back().world_from_object = glm::mat4(0.5f);
    scene.instances.back().world_from_object[3][3] = 1.0f;
    scene.instances[1].world_from_object[3] += glm::vec4(1.5f, 0.0f, 1.5f, 0.0f);
    for (Instance& instance : scene.instances) instance.world_from_object[3].x += far;
    EXPECT_LT(refinementsOf(scene)[0].parents.size(), 20'000u) << far;
  }
}

TEST(OcclusionRefinement, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = ballOnFloor(5.0f, glm::vec2(1.0f));
  const int threads = threadLimit();
  const std::vector<MeshRefinement> many = refinementsOf(scene);
  setThreadLimit(1);
  const std::vector<MeshRefinement> one = refinementsOf(scene);
  setThreadLimit(threads);
  for (std::size_t i = 0; i < many.size(); ++i) EXPECT_EQ(many[i].indices, one[i].indices);
}

TEST(OcclusionRefinement, TakesMeshesThatAreNotSound) {
  Scene scene = ballOnFloor(12.0f, glm::vec2(0.0f));
  scene.meshes[0].edit().vertices[0].position.x = std::numeric_limits<float>::quiet_NaN();
  scene.meshes[0].edit().vertices[3].normal = glm::vec3(0.0f);
  scene.meshes[1].edit().vertices[5].position.y = std::numeric_limits<float>::infinity();
  refinementsOf(scene);
  refinementsOf(Scene());
  refinementsOf(meshScene(Mesh()));
}

TEST(OcclusionRefinement, StopsWhenTold) {
  const Scene scene = ballOnFloor(5.0f, glm::vec2(0.0f));
  const auto geometry = Geometry::make(scene);
  ASSERT_TRUE(geometry);
  const auto stopped = occlusionRefinements(scene, *geometry, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
