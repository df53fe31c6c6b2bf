#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

constexpr glm::ivec2 kCubesSize(60, 40);

/// Cubes that cut each other and share a plane.
Scene crossingCubes() {
  Scene scene = *loadModel("cube");
  const Instance cube = scene.instances.front();
  const glm::mat4 raised = glm::translate(glm::mat4(1.0f), glm::vec3(0.4f, 0.0f, 0.3f));
  const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 0.6f, glm::normalize(glm::vec3(1.0f, 2.0f, 0.5f)));
  for (const glm::mat4& place : {raised, turned}) {
    scene.instances.push_back(cube);
    scene.instances.back().world_from_object = place * cube.world_from_object;
  }
  return scene;
}

/// The same with so many triangles without an area that nothing is drawn twice.
Scene crowded(Scene scene) {
  std::vector<std::uint32_t>& indices = scene.meshes.front().edit().indices;
  indices.resize(indices.size() + 3 * std::size_t(kCubesSize.x) * std::size_t(kCubesSize.y), indices.front());
  return scene;
}

class EarlyDepthTest : public gl::GlTest {};
MIRRORBALL_WITH_BOTH_APIS(EarlyDepthTest);

TEST_P(EarlyDepthTest, ChangesNoPicture) {
  const Environment light = testing::coarseBuiltin("studio");
  const PreparedEnvironment prepared = *testing::prepareOnce(light);
  for (const Sampling sampling : {Sampling::all, Sampling::adaptive}) {
    const auto pictureOf = [&](Scene scene) {
      Renderer renderer = *testing::rendererOf(std::move(scene), light, prepared);
      const auto picture = renderer.render({.size = kCubesSize, .samples = 4, .sampling = sampling});
      EXPECT_TRUE(picture);
      return picture ? std::vector<std::uint8_t>(picture->samples().begin(), picture->samples().end())
                     : std::vector<std::uint8_t>();
    };
    const std::vector<std::uint8_t> first = pictureOf(crossingCubes());
    EXPECT_EQ(first, pictureOf(crowded(crossingCubes())));
    EXPECT_NE(*std::max_element(first.begin(), first.end()), 0);
  }
}

}  // namespace
}  // namespace mirrorball
