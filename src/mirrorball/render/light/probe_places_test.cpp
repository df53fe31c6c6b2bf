#include "mirrorball/render/light/probe_places.h"

#include <numeric>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::UnorderedElementsAre;

Material glossy() {
  Material material;
  material.metallic = 1.0f;
  material.perceptual_roughness = 0.0f;
  return material;
}

Material matt() {
  Material material;
  material.perceptual_roughness = 1.0f;
  return material;
}

void add(Scene& scene, Mesh mesh, glm::vec3 place, glm::vec3 size, const Material& material) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.instances.push_back(
      {static_cast<int>(scene.meshes.size()), glm::scale(glm::translate(glm::mat4(1.0f), place), size)});
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(material);
}

TEST(ProbePlaces, TheLargestGlossyObjectsHaveOne) {
  Scene scene;
  add(scene, sphereMesh(16, 32), {5, 0, 0}, glm::vec3(0.5f), glossy());
  add(scene, sphereMesh(16, 32), {0, 0, 0}, glm::vec3(2.0f), matt());
  add(scene, sphereMesh(16, 32), {0, 7, 0}, glm::vec3(1.0f), glossy());
  add(scene, planeMesh(), {0, -2, 0}, glm::vec3(20.0f), glossy());
  const ProbePlaces one = probePlaces(scene, 1);
  ASSERT_EQ(one.probes.size(), 1u);
  ASSERT_EQ(one.others.size(), 1u) << "what is matt or flat has none";
  EXPECT_THAT(one.probes[0].instances, ElementsAre(2));
  EXPECT_NEAR(glm::distance(one.probes[0].middle, glm::vec3(0, 7, 0)), 0.0f, 1e-5f);
  EXPECT_THAT(one.others[0].instances, ElementsAre(0));
  EXPECT_EQ(probePlaces(scene, 64).probes.size(), 2u);
  EXPECT_TRUE(probePlaces(scene, 0).probes.empty());
  EXPECT_TRUE(probePlaces(Scene{}, 8).probes.empty());
}

TEST(ProbePlaces, WhatLiesInAnObjectIsAPartOfIt) {
  Scene scene;
  add(scene, sphereMesh(16, 32), {0, 0.1f, 0}, glm::vec3(0.4f), matt());
  add(scene, sphereMesh(16, 32), {0, 0, 0}, glm::vec3(1.0f), glossy());
  add(scene, sphereMesh(16, 32), {3, 0, 0}, glm::vec3(0.4f), glossy());
  const ProbePlaces places = probePlaces(scene, 8);
  ASSERT_EQ(places.probes.size(), 2u);
  EXPECT_THAT(places.probes[0].instances, UnorderedElementsAre(0, 1));
  EXPECT_THAT(places.probes[1].instances, ElementsAre(2));
}

TEST(ProbePlaces, SharesFallWithTheSquareOfTheDistance) {
  const std::vector<ReflectiveObject> probes{
      {{1, 0, 0}, 1.0f, {}}, {{0, 2, 0}, 1.0f, {}}, {{0, 0, 9}, 1.0f, {}}, {{0, 0, -4}, 1.0f, {}}};
  const std::vector<float> shares = probeShares({{0, 0, 0}, 1.0f, {}}, probes);
  const float sum = 1.0f + 1.0f / 4.0f + 1.0f / 16.0f;
  EXPECT_THAT(shares, ElementsAre(FloatNear(1.0f / sum, 1e-6f), FloatNear(0.25f / sum, 1e-6f), 0.0f,
                                  FloatNear(0.0625f / sum, 1e-6f)));
  const std::vector<float> there = probeShares({{1, 0, 0}, 1.0f, {}}, probes);
  EXPECT_NEAR(there[0], 1.0f, 1e-6f) << "where a probe stands it is all";
}

}  // namespace
}  // namespace mirrorball
