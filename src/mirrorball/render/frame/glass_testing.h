#pragma once

/// Bodies of glass in smooth light, for tests of what light does in them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball::testing {

inline Material clearGlass(float ior) {
  Material glass;
  glass.base_color = glm::vec3(1.0f);
  glass.perceptual_roughness = 0.0f;
  glass.ior = ior;
  glass.transmission = 1.0f;
  return glass;
}

/// Glass that mirrors nothing, so that what is behind it can be told.
inline Material withoutReflection(float ior) {
  Material glass = clearGlass(ior);
  glass.specular = 0.0f;
  return glass;
}

/// A second body in a scene.
inline void add(Scene& scene, Mesh mesh, const Material& material, glm::vec3 place = glm::vec3(0.0f),
                float scale = 1.0f) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  scene.instances.push_back(
      {static_cast<int>(scene.meshes.size()), glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(scale))});
  scene.meshes.push_back(std::move(mesh));
}

/// Light that is another one in each direction, without edges.
inline glm::vec3 smoothLight(glm::vec3 d) {
  return glm::vec3(1.0f) + 0.5f * d +
         0.25f * glm::vec3(std::sin(5.0f * d.y), std::sin(5.0f * d.z), std::sin(5.0f * d.x));
}

/// Draws bodies of glass, traced through if nothing else is said.
class GlassTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless();
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
    frame_.size = {64, 64};
    frame_.samples = 1;
    frame_.refraction = RefractionKind::traced;
    frame_.camera.orthographic_height = 2.2f;
    frame_.camera.target = glm::vec3(0.0f);
    aim(frame_, 0, 0);
  }

  Image radiance(Scene scene, const Environment& environment) {
    const auto draw = [&]() -> Result<Image> {
      MIRRORBALL_TRY(prepared, prepareOnce(environment));
      MIRRORBALL_TRY(renderer, rendererOf(std::move(scene), environment, prepared));
      return renderer.renderRadiance(frame_);
    };
    auto image = draw();
    if (image) return std::move(*image);
    ADD_FAILURE() << image.error().message;
    return {};
  }
  Image inSmoothLight(Scene scene) { return radiance(std::move(scene), Environment(smoothLight, 128)); }

  FrameSettings frame_;

 private:
  std::optional<gl::Context> context_;
};

inline double greatestDifference(const Image& a, const Image& b) {
  double greatest = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int channel = 0; channel < 3; ++channel)
        greatest = std::max<double>(greatest, std::abs(a.texel(x, y)[channel] - b.texel(x, y)[channel]));
  return greatest;
}

inline double meanDifference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int channel = 0; channel < 3; ++channel) sum += std::abs(a.texel(x, y)[channel] - b.texel(x, y)[channel]);
  return sum / (3.0 * a.width() * a.height());
}

}  // namespace mirrorball::testing
