#include "mirrorball/render/frame/render_inputs.h"

#include <algorithm>
#include <future>
#include <limits>
#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/light_edit/sun_split.h"
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

/// The same as the frame shows its suns.
Result<LoadedEnvironment> loadShownLight(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY(loaded, loadLight(names, observer));
  if (names.frame.sunShown() == SunKind::map) return loaded;
  MIRRORBALL_TRY(split, withoutSuns(loaded.environment));
  loaded.environment = withSuns(std::move(split));
  return loaded;
}

/// An environment as it is, and as the GPU takes it.
struct PreparedLight {
  LoadedEnvironment loaded;
  PreparedEnvironment prepared;
  std::optional<glm::vec3> strong_sun;
};

/// The strong sun, where it is asked for and there.
Result<std::optional<glm::vec3>> findStrongSun(const RenderInputNames& names, const Environment& environment) {
  const bool chooses = names.wishes && dependsOnSun(names.wishes->quality, names.wishes->given, names.frame);
  if (!chooses && names.frame.camera.ground_reach <= 0.0f) return std::optional<glm::vec3>();
  return strongSun(environment);
}

/// strong_sun   is told whether the environment has one
Result<PreparedLight> prepareLight(const RenderInputNames& names, const Observer& observer,
                                   std::promise<bool> strong_sun) {
  auto loaded = loadLight(names, observer);
  auto found = loaded ? findStrongSun(names, loaded->environment) : Result<std::optional<glm::vec3>>();
  const bool has_strong_sun = found && found->has_value();
  strong_sun.set_value(has_strong_sun);
  if (!loaded) return fail(std::move(loaded));
  MIRRORBALL_TRY(sun, std::move(found));
  FrameSettings frame = names.frame;
  if (names.wishes) fillIn(names.wishes->quality, {.has_strong_sun = has_strong_sun}, names.wishes->given, frame);
  MIRRORBALL_TRY(prepared, observer.timed("environment: cube, mips, prefiltering", [&] {
    return prepareEnvironment(loaded->environment, names.cache, {}, frame.sunShown());
  }));
  return PreparedLight{std::move(*loaded), std::move(prepared), sun};
}

/// A model, and how it is drawn.
struct PreparedModel {
  Scene scene;
  FrameSettings frame;
  std::string chosen = {};
};

/// has_strong_sun   of the environment; asked where there are wishes
std::future<Result<PreparedModel>> modelLater(const RenderInputNames& names, const Observer& observer,
                                              const std::function<int()>& largest_texture,
                                              const std::function<bool()>& has_strong_sun) {
  return std::async(besideOthers(), [&names, &observer, largest_texture, has_strong_sun]() -> Result<PreparedModel> {
    MIRRORBALL_TRY(scene, observer.timed("model: read", [&] { return loadScene(names, largest_texture); }));
    PreparedModel model{std::move(scene), names.frame};
    if (names.wishes) {
      TechniqueWishes wishes = *names.wishes;
      wishes.has_strong_sun = has_strong_sun();
      MIRRORBALL_TRY(chosen, chooseTechniques(model.scene, wishes, model.frame, names.cache, observer));
      model.chosen = std::move(chosen);
    }
    return model;
  });
}

/// sun   strongSun() of the light, if the frame's camera is to hold its shadow
SceneInputs inputsOf(const std::string& model, PreparedModel prepared, LoadedEnvironment light,
                     std::optional<glm::vec3> sun, const Observer& observer) {
  Scene& scene = prepared.scene;
  for (const std::string& warning : scene.warnings) observer.tell(RemarkKind::model_reduced, warning);
  for (const std::string& line : openBodies(scene)) observer.tell(RemarkKind::body_open, model + ": " + line);
  std::vector<std::string> files = std::move(light.files);
  files.insert(files.end(), scene.files.begin(), scene.files.end());
  holdShadow(prepared.frame, sun);
  return {std::move(scene), std::move(light.environment), std::move(files), std::move(prepared.frame)};
}

}  // namespace

Result<SceneInputs> loadSceneInputs(const RenderInputNames& names, const Observer& observer) {
  // A wrong name is told before anything is loaded.
  MIRRORBALL_TRY_VOID(checkChanges(names.materials));
  auto model_later = modelLater(names, observer, {}, [] { return false; });
  auto light = loadShownLight(names, observer);
  // It refers to this frame, and so is waited for before any error returns.
  auto model = model_later.get();
  if (!model) return fail(std::move(model));
  if (!light) return fail(std::move(light));
  MIRRORBALL_TRY(sun, findStrongSun(names, light->environment));
  return inputsOf(names.model, std::move(*model), std::move(*light), sun, observer);
}

Result<RenderInputs> loadRenderInputs(const RenderInputNames& names, const Observer& observer) {
  MIRRORBALL_TRY_VOID(checkChanges(names.materials));
  // None of the three needs the others, but for heights that not every driver takes, and suns that throw shadows.
  std::promise<int> largest_texture;
  const std::shared_future<int> largest = largest_texture.get_future().share();
  std::promise<bool> strong_sun;
  const std::shared_future<bool> has_strong_sun = strong_sun.get_future().share();
  auto model_later = modelLater(
      names, observer, [largest] { return largest.get(); }, [has_strong_sun] { return has_strong_sun.get(); });
  auto light_later = std::async(besideOthers(), [&] { return prepareLight(names, observer, std::move(strong_sun)); });
  auto context = observer.timed("GL: start the driver", [] { return gl::Context::createHeadless(); });
  largest_texture.set_value(context ? context->largestTexture() : std::numeric_limits<int>::max());
  // The model asks about the light: on one core they are made only now, one after the other.
  auto light = light_later.get();
  auto model = model_later.get();
  if (!model) return fail(std::move(model));
  if (!light) return fail(std::move(light));
  if (!context) return fail(std::move(context));
  std::string chosen = std::move(model->chosen);
  return RenderInputs{inputsOf(names.model, std::move(*model), std::move(light->loaded), light->strong_sun, observer),
                      std::move(light->prepared), std::move(*context), std::move(chosen)};
}

Result<Renderer> rendererOf(RenderInputs inputs) {
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(inputs.environment), inputs.prepared));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(inputs.scene)));
  return renderer;
}

}  // namespace mirrorball
