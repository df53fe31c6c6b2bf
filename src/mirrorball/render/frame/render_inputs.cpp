#include "mirrorball/render/frame/render_inputs.h"

#include <algorithm>
#include <future>
#include <limits>
#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/closed_surface.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

/// Relief is asked for by name, and a model brings no heights.
void warnOfNoHeights(Scene& scene, ReliefKind kind) {
  const bool has_heights = std::any_of(scene.materials.begin(), scene.materials.end(),
                                       [](const Material& each) { return each.height != HeightKind::none; });
  if (kind > ReliefKind::bump && !scene.materials.empty() && !has_heights)
    scene.warnings.push_back("relief: no surface has heights to show; the material parameter height gives them");
}

}  // namespace

Result<void> prepareModel(Scene& scene, UpAxis up, const MaterialChanges& materials, ReliefKind relief,
                          const std::function<int()>& largest_texture) {
  standUpright(scene, up);
  MIRRORBALL_TRY_VOID(changeMaterials(scene, materials));
  warnOfNoHeights(scene, relief);
  return prepareRelief(scene, relief, largest_texture);
}

Result<Scene> loadScene(const RenderInputNames& names, const std::function<int()>& largest_texture) {
  MIRRORBALL_TRY(scene, loadModel(names.model, names.load_model));
  MIRRORBALL_TRY_VOID(prepareModel(scene, names.up, names.materials, names.frame.relief, largest_texture));
  return scene;
}

namespace {

Result<LoadedEnvironment> loadLight(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY(loaded, observer.timed("environment: read", [&] {
    const ProgressFunction progress = observer.progressOf("read");
    return names.load_environment ? names.load_environment(progress)
                                  : loadEnvironment(names.environment, names.load, progress);
  }));
  tellAbout(loaded, observer);
  if (EnvironmentMap* map = loaded.environment.map())
    MIRRORBALL_TRY_VOID(withName(loaded.name, checkLight(*map, observer.named(loaded.name))));
  return loaded;
}

/// An environment as it is, and as the GPU takes it.
struct PreparedLight {
  LoadedEnvironment loaded;
  PreparedEnvironment prepared;
};

Result<PreparedLight> prepareLight(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY(loaded, loadLight(names, observer));
  MIRRORBALL_TRY(prepared, observer.timed("environment: cube, mips, prefiltering",
                                          [&] { return prepareEnvironment(loaded.environment, names.cache); }));
  return PreparedLight{std::move(loaded), std::move(prepared)};
}

/// A model, and how it is drawn.
struct PreparedModel {
  Scene scene;
  FrameSettings frame;
  std::string chosen = {};
};

std::future<Result<PreparedModel>> modelLater(const RenderInputNames& names, const Observer& observer,
                                              const std::function<int()>& largest_texture) {
  return std::async(besideOthers(), [&names, &observer, largest_texture]() -> Result<PreparedModel> {
    MIRRORBALL_TRY(scene, observer.timed("model: read", [&] { return loadScene(names, largest_texture); }));
    PreparedModel model{std::move(scene), names.frame};
    if (names.wishes) {
      MIRRORBALL_TRY(chosen, chooseTechniques(model.scene, *names.wishes, model.frame, names.cache, observer));
      model.chosen = std::move(chosen);
    }
    return model;
  });
}

SceneInputs inputsOf(const std::string& model, Scene scene, LoadedEnvironment light, const Observer& observer) {
  for (const std::string& warning : scene.warnings) observer.tell(RemarkKind::model_reduced, warning);
  for (const std::string& line : openBodies(scene)) observer.tell(RemarkKind::body_open, model + ": " + line);
  std::vector<std::string> files = std::move(light.files);
  files.insert(files.end(), scene.files.begin(), scene.files.end());
  return {std::move(scene), std::move(light.environment), std::move(files)};
}

}  // namespace

Result<SceneInputs> loadSceneInputs(const RenderInputNames& names, const Observer& observer) {
  // A wrong name is told before anything is loaded.
  MIRRORBALL_TRY_VOID(checkChanges(names.materials));
  auto model_later = modelLater(names, observer, {});
  auto light = loadLight(names, observer);
  // It refers to this frame, and so is waited for before any error returns.
  auto model = model_later.get();
  if (!model) return fail(std::move(model));
  if (!light) return fail(std::move(light));
  return inputsOf(names.model, std::move(model->scene), std::move(*light), observer);
}

Result<RenderInputs> loadRenderInputs(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY_VOID(checkChanges(names.materials));
  // None of the three needs the others, but for heights that not every driver takes.
  std::promise<int> largest_texture;
  const std::shared_future<int> largest = largest_texture.get_future().share();
  auto model_later = modelLater(names, observer, [largest] { return largest.get(); });
  auto light_later = std::async(besideOthers(), [&] { return prepareLight(names, observer); });
  auto context = observer.timed("GL: start the driver", [] { return gl::Context::createHeadless(); });
  largest_texture.set_value(context ? context->largestTexture() : std::numeric_limits<int>::max());
  auto model = model_later.get();
  auto light = light_later.get();
  if (!model) return fail(std::move(model));
  if (!light) return fail(std::move(light));
  if (!context) return fail(std::move(context));
  return RenderInputs{inputsOf(names.model, std::move(model->scene), std::move(light->loaded), observer),
                      std::move(light->prepared), std::move(*context), std::move(model->frame),
                      std::move(model->chosen)};
}

Result<Renderer> rendererOf(RenderInputs inputs) {
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(inputs.environment), inputs.prepared));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(inputs.scene)));
  return renderer;
}

}  // namespace mirrorball
