#include "mirrorball/render/frame/render_inputs.h"

#include <future>
#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

Result<Scene> loadScene(const RenderInputNames& names) {
  MIRRORBALL_TRY(scene, loadModel(names.model));
  standUpright(scene, names.up);
  MIRRORBALL_TRY_VOID(changeMaterials(scene, names.materials));
  return scene;
}

/// An environment as it is, and as the GPU takes it.
struct LoadedLight {
  LoadedEnvironment loaded;
  PreparedEnvironment prepared;
};

Result<LoadedLight> loadLight(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY(loaded, observer.timed("environment: read", [&] {
    return loadEnvironment(names.environment, names.load, observer.progressOf("read"));
  }));
  tellAbout(loaded, observer);
  if (EnvironmentMap* map = loaded.environment.map()) raiseNegativeLight(*map, observer.named(loaded.name));
  MIRRORBALL_TRY(prepared, observer.timed("environment: cube, mips, prefiltering",
                                          [&] { return prepareEnvironment(loaded.environment, names.cache); }));
  return LoadedLight{std::move(loaded), std::move(prepared)};
}

}  // namespace

Result<RenderInputs> loadRenderInputs(const RenderInputNames& names, const Observer& observer) {
  // A wrong name among the materials is told before anything is loaded.
  Scene no_scene;
  MIRRORBALL_TRY_VOID(changeMaterials(no_scene, names.materials));
  // None of the three needs the others.
  auto scene_later =
      std::async(besideOthers(), [&] { return observer.timed("model: read", [&] { return loadScene(names); }); });
  auto light_later = std::async(besideOthers(), [&] { return loadLight(names, observer); });
  auto context = observer.timed("GL: start the driver", [] { return gl::Context::createHeadless(); });
  // Both are waited for before any error returns, since they refer to this frame.
  auto scene = scene_later.get();
  auto light = light_later.get();
  if (!scene) return fail(std::move(scene));
  if (!light) return fail(std::move(light));
  if (!context) return fail(std::move(context));
  for (const std::string& warning : scene->warnings) observer.tell(RemarkKind::model_reduced, warning);
  std::vector<std::string> files = light->loaded.files;
  files.insert(files.end(), scene->files.begin(), scene->files.end());
  return RenderInputs{std::move(*scene), std::move(light->loaded.environment), std::move(light->prepared),
                      std::move(*context), std::move(files)};
}

Result<Renderer> rendererOf(RenderInputs inputs) {
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(inputs.environment), inputs.prepared));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(inputs.scene)));
  return renderer;
}

}  // namespace mirrorball
