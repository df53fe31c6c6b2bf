// The programs that View::makeProgram makes before a frame is drawn: what a driver compiles for it, it need not compile
// again for the frame. Counted by the files that Mesa's software driver keeps, one for each code that it has compiled.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "environment_variable_testing.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/driver_cache.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class MadeProgramsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto context = gl::Context::createHeadless();
    if (!context) MIRRORBALL_END_WITHOUT_GL(context.error().message);
    if (!context->compilesWhenDrawing()) GTEST_SKIP() << "this driver does not compile a program when it draws";
  }
  ~MadeProgramsTest() override { fs::remove_all(folder_); }

  /// How many codes a driver that has none compiles for the first sample of a frame.
  ///
  /// before   called when the frame has begun
  std::size_t countCompiled(const Scene& scene, const FrameSettings& settings,
                            const std::function<void(View&)>& before) const {
    fs::remove_all(folder_);
    const Environment light = testing::coarseBuiltin("studio");
    std::string version;
    {
      auto context = gl::Context::createHeadless();  // the only one, so that the driver looks for its folder anew
      version = context->version();
      Renderer renderer = *Renderer::on(std::move(*context));
      EXPECT_TRUE(renderer.setEnvironment(light, *testing::prepareOnce(light)));
      EXPECT_TRUE(renderer.setScene(scene));
      EXPECT_TRUE(renderer.begin(settings));
      before(renderer);
      EXPECT_TRUE(renderer.drawSample());
    }  // whose end waits until the driver has written all
    return gl::findDriverCache(version)->contents().files;
  }

  /// Expects that a frame compiles the same whether its programs are made before or when it is drawn.
  void expectNoneIsCompiledTwice(const Scene& scene, const FrameSettings& settings) const {
    const std::size_t when_drawn = countCompiled(scene, settings, [](View&) {});
    const std::size_t before = countCompiled(scene, settings, [](View& view) {
      int made = 1;
      for (auto left = view.makeProgram(); left && *left > 0; ++made) left = view.makeProgram();
      EXPECT_EQ(made, 1);
    });
    EXPECT_GT(when_drawn, 5u) << "else nothing is compared";
    EXPECT_EQ(before, when_drawn);
  }

 private:
  const fs::path folder_ = fs::path(::testing::TempDir()) / ("made_programs_" + std::to_string(::getpid()));
  const testing::VariableForTest in_folder_{"MESA_SHADER_CACHE_DIR", folder_.string()};
  const testing::VariableForTest is_on_{"MESA_SHADER_CACHE_DISABLE", "false"};
};

Scene glassBall() {
  Material glass;
  glass.transmission = 1.0f;
  return meshScene(sphereMesh(24, 48), glass);
}

TEST_F(MadeProgramsTest, AreThoseOfOpaqueSurfaces) {
  expectNoneIsCompiledTwice(meshScene(sphereMesh(24, 48)), {.size = {64, 36}, .samples = 1});
}

TEST_F(MadeProgramsTest, AreThoseOfMaskedSamples) {
  FrameSettings settings{.size = {64, 36}, .samples = 16};
  testing::set(settings, "sampling", "adaptive");
  expectNoneIsCompiledTwice(meshScene(sphereMesh(24, 48)), settings);
}

TEST_F(MadeProgramsTest, AreThoseOfSurfacesThatAreLaidOverOthers) {
  Material thin;
  thin.alpha_mode = AlphaMode::blend;
  thin.opacity = 0.5f;
  expectNoneIsCompiledTwice(meshScene(sphereMesh(24, 48), thin), {.size = {64, 36}, .samples = 1});
}

TEST_F(MadeProgramsTest, AreThoseOfBodiesWhoseBackFacesAreDrawn) {
  FrameSettings settings{.size = {64, 36}, .samples = 1};
  testing::set(settings, "refraction", "image-space");
  expectNoneIsCompiledTwice(glassBall(), settings);
}

TEST_F(MadeProgramsTest, AreThoseOfBodiesThatSeeTheScreen) {
  FrameSettings settings{.size = {64, 36}, .samples = 1};
  testing::set(settings, "refraction", "image-space");
  testing::set(settings, "behind", "screen");
  expectNoneIsCompiledTwice(glassBall(), settings);
}

// Threads draw without the vertices of a mesh, for which the driver compiles the short vertex shaders once more.
TEST_F(MadeProgramsTest, OfThreadsAreThoseOfTheFrame) {
  FrameSettings settings{.size = {64, 36}, .samples = 16};
  testing::set(settings, "refraction", "image-space");
  testing::set(settings, "behind", "screen");
  Scene scene = glassBall();
  Material thin;
  thin.alpha_mode = AlphaMode::blend;
  thin.opacity = 0.5f;
  testing::addBall(scene, glm::vec3(2.0f, 0.0f, 0.0f), 1.0f, thin, 24);
  testing::addBall(scene, glm::vec3(-2.0f, 0.0f, 0.0f), 1.0f, {}, 24);
  const int threads_before = threadLimit();
  const auto countWith = [&](int threads) {
    setThreadLimit(threads);
    return countCompiled(scene, settings, [](View&) {});
  };
  const std::size_t alone = countWith(1), together = countWith(2);
  setThreadLimit(threads_before);
  EXPECT_LE(together, alone + scene.materials.size());
}

}  // namespace
}  // namespace mirrorball
