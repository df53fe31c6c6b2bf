#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <unistd.h>

#include "gl_driver.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball::testing {

/// prepareEnvironment with a cache that lasts as long as this process: tests in the same light prefilter it once, which
/// takes longer than to draw in it.
inline Result<PreparedEnvironment> prepareOnce(const Environment& environment, SunKind sun = SunKind::map) {
  struct Folder {
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("mirrorball_prepared_" + std::to_string(::getpid()));
    // A run that crashed may have left the folder of another process of that number.
    Folder() { std::filesystem::remove_all(path); }
    ~Folder() {
      std::error_code status;
      std::filesystem::remove_all(path, status);
    }
  };
  static const Folder folder;
  return prepareEnvironment(environment, CacheFolder(folder.path), {}, sun);
}

/// A built-in environment as a panorama of few rows has it, for tests that only compare pictures in the same light: the
/// sky's own cube has 1.6 million texels, which take longer than all the pictures, and ten times as long under the
/// sanitizers.
inline Environment coarseBuiltin(std::string_view name) {
  constexpr int kRows = 128;
  return Environment([fine = *builtinEnvironment(name)](glm::vec3 direction) { return fine.radiance(direction); },
                     kRows);
}

/// Tests with a context of OpenGL without a window; skipped where there is none.
class HeadlessTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless();
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }

 private:
  std::optional<gl::Context> context_;
};

/// A renderer on the context that is current.
inline Result<Renderer> rendererOf(Scene scene, Environment environment, const PreparedEnvironment& prepared) {
  MIRRORBALL_TRY(context, gl::Context::adoptCurrent());
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(environment), prepared));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(scene)));
  return renderer;
}

/// The same, in an environment that was prepared once; expected to be made.
inline Renderer rendererFor(Scene scene, Environment environment, SunKind sun = SunKind::map) {
  const auto prepared = prepareOnce(environment, sun);
  auto renderer = rendererOf(std::move(scene), std::move(environment), *prepared);
  EXPECT_TRUE(renderer) << renderer.error().message;
  return std::move(*renderer);
}

/// Its radiance in a frame; expected to be drawn.
inline Image drawn(View& view, const FrameSettings& settings) {
  auto image = view.renderRadiance(settings);
  EXPECT_TRUE(image) << image.error().message;
  return std::move(*image);
}

/// Puts a ball into a scene.
inline void addBall(Scene& scene, glm::vec3 middle, float radius, const Material& material, int rows = 96) {
  Mesh mesh = sphereMesh(rows, 2 * rows);
  mesh.material = static_cast<int>(scene.materials.size());
  const glm::mat4 placed = glm::scale(glm::translate(glm::mat4(1.0f), middle), glm::vec3(radius));
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), placed});
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(material);
}

/// Every texel that the object covers wholly is 1, within 0.1 % if nothing else is said.
inline void expectFurnaceWhite(const Image& image, const std::string& what, float tolerance = 1e-3f) {
  int covered = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = rgbaAt(image, x, y);
      if (texel.w < 1.0f) continue;
      ++covered;
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(texel[channel], 1.0f, tolerance) << what << " at (" << x << ", " << y << ")";
    }
  EXPECT_GT(covered, image.width() * image.height() / 20) << what << " covers too little to tell";
}

/// Sets a frame's option from what a user writes.
inline void set(FrameSettings& settings, std::string_view name, std::string_view written) {
  const auto option = std::ranges::find(frameOptions(), name, [](const auto& row) { return row.text.name; });
  ASSERT_NE(option, frameOptions().end()) << name;
  const auto assigned = assign(*option, settings, written);
  ASSERT_TRUE(assigned) << assigned.error().message;
}

inline void aim(FrameSettings& settings, float azimuth_deg, float elevation_deg) {
  settings.camera.azimuth_deg = azimuth_deg;
  settings.camera.elevation_deg = elevation_deg;
}

/// From +Z by parallel rays, over so many world units about the origin; 4 samples, of radiance.
inline FrameSettings frontOf(const Renderer& renderer, int size, float wide) {
  FrameSettings settings;
  settings.size = {size, size};
  settings.samples = 4;
  settings.resolve = Resolve::radiance;
  settings.camera = {.azimuth_deg = 0.0f,
                     .elevation_deg = 0.0f,
                     .target = glm::vec3(0.0f),
                     .orthographic_height = wide / renderer.bounds().radius};
  return settings;
}

}  // namespace mirrorball::testing
