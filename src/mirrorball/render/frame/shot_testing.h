#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball::testing {

/// A model in an environment, as the command line would draw it.
struct Shot {
  std::string model = "sphere";
  FrameSettings frame = {};
  MaterialChanges materials = {};
};

/// Takes a shot on the current context; what fails becomes a test failure and an empty image.
class Studio {
 public:
  explicit Studio(Environment environment)
      : environment_(std::move(environment)), prepared_(*prepareOnce(environment_)) {}

  Image radiance(const Shot& shot) {
    return taken<Image>(shot, [&](Renderer& renderer) { return renderer.renderRadiance(shot.frame); });
  }

  Image8 picture(const Shot& shot) {
    return taken<Image8>(shot, [&](Renderer& renderer) { return renderer.render(shot.frame); });
  }

 private:
  template <typename Picture, typename Render>
  Picture taken(const Shot& shot, const Render& render) {
    const auto draw = [&]() -> Result<Picture> {
      MIRRORBALL_TRY(scene, loadModel(shot.model));
      MIRRORBALL_TRY_VOID(changeMaterials(scene, shot.materials));
      MIRRORBALL_TRY(renderer, rendererOf(std::move(scene), environment_, prepared_));
      return render(renderer);
    };
    auto picture = draw();
    if (picture) return std::move(*picture);
    ADD_FAILURE() << picture.error().message;
    return {};
  }

  Environment environment_;
  PreparedEnvironment prepared_;
};

inline Shot smallShot(std::string model, std::string material) {
  Shot shot;
  shot.model = std::move(model);
  shot.frame.size = {96, 64};
  shot.materials.material = std::move(material);
  return shot;
}

class RendererTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless();
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }
  /// A built-in environment, in as much detail as pictures of 96 × 64 need.
  Studio smallStudio(std::string_view environment) {
    return Studio(Environment(*convert(*builtinEnvironment(environment), Projection::cube, 128)));
  }
  Studio studio(std::string_view environment) { return Studio(*builtinEnvironment(environment)); }

 private:
  std::optional<gl::Context> context_;
};

}  // namespace mirrorball::testing
