#include "mirrorball/render/stage/stage.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/render/stage/stage_work_state.h"
#include "mirrorball/scene/animation/pose.h"

namespace mirrorball {
namespace {

/// errors   usage: a texture is not in the scene
Result<void> checkTextures(const Scene& scene, const Material& material) {
  const int count = static_cast<int>(scene.textures.size());
  for (const MaterialMap& map : materialMaps())
    if ((material.*map.slot).texture >= count)
      return fail(ErrorCode::usage, std::string(map.name) + ": texture " +
                                        std::to_string((material.*map.slot).texture) + " of a scene of " +
                                        counted(scene.textures.size(), "texture"));
  if (material.height_texture >= static_cast<int>(scene.height_textures.size()))
    return fail(ErrorCode::usage, "height_texture: " + std::to_string(material.height_texture) + " of a scene of " +
                                      counted(scene.height_textures.size(), "texture") + " of heights");
  if (material.slope_texture >= static_cast<int>(scene.slope_textures.size()))
    return fail(ErrorCode::usage, "slope_texture: " + std::to_string(material.slope_texture) + " of a scene of " +
                                      counted(scene.slope_textures.size(), "texture") + " of slopes");
  return {};
}

/// errors   usage: it is no placing without mirroring
Result<void> checkTransform(std::size_t instance, const glm::mat4& world_from_object) {
  const float volume = glm::determinant(glm::mat3(world_from_object));
  if (volume >= 0.0f && std::isfinite(volume) && std::isfinite(glm::length(glm::vec3(world_from_object[3])))) return {};
  return fail(ErrorCode::usage, "instance " + std::to_string(instance) +
                                    (volume < 0.0f ? " would be mirrored; mirror its mesh"
                                                   : ": its matrix has numbers that are not finite"));
}

}  // namespace

Stage::Stage(const Device& device) : state_(new State(device), EndOnDevice()) {}

PreparationMeans Stage::State::means() const {
  const int largest_texture = device.state().context.largestTexture();
  return {.largest_texture = [largest_texture] { return largest_texture; }, .cache = cache};
}

Result<std::shared_ptr<StagedScene>> Stage::State::formFor(const FrameSettings& settings) {
  const ScenePreparation preparation = preparationFor(settings);
  if (auto known = scene.find(preparation)) return known;
  auto prepared = std::make_shared<Scene>(scene.scene());
  MIRRORBALL_TRY_VOID(prepareScene(*prepared, preparation, means()));
  return scene.add(preparation, std::move(prepared));
}

const Device& Stage::device() const { return state_->device; }

Result<void> Stage::setScene(Scene scene, const LevelsOfMaps& levels) {
  MIRRORBALL_TRY_VOID(device().state().context.enter());
  return state_->scene.set(std::move(scene), levels);
}

Result<void> Stage::setEnvironment(Environment environment, const std::optional<CacheFolder>& cache) {
  if (EnvironmentMap* map = environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(prepared, prepareEnvironment(environment, cache));
  return setEnvironment(std::move(environment), prepared);
}

Result<void> Stage::setEnvironment(Environment environment, const PreparedEnvironment& prepared) {
  const gl::Context& context = device().state().context;
  MIRRORBALL_TRY_VOID(context.enter());
  return state_->light.set(std::move(environment), prepared, context.filtersFloats());
}

Result<void> Stage::setMaterial(std::size_t index, Material material) {
  if (index >= scene().materials.size())
    return fail(ErrorCode::usage, "material " + std::to_string(index) + " of a scene of " +
                                      counted(scene().materials.size(), "material"));
  MIRRORBALL_TRY_VOID(checkTextures(scene(), material));
  MIRRORBALL_TRY_VOID(device().state().context.enter());
  return state_->scene.setMaterial(index, std::move(material));
}

void Stage::setCache(const std::optional<CacheFolder>& cache) { state_->cache = cache; }

Result<void> Stage::prepare(const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY(work, workFor(settings));
  MIRRORBALL_TRY_VOID(work.run(progress));
  MIRRORBALL_TRY_VOID(take(std::move(work)));
  return {};
}

Result<StageWork> Stage::workFor(const FrameSettings& settings, bool picks) const {
  MIRRORBALL_TRY_VOID(device().state().context.enter());
  SceneForms& forms = state_->scene;
  const StagedLight& light = state_->light;
  const ScenePreparation preparation = preparationFor(settings);
  const auto known = forms.find(preparation);
  auto work = std::make_unique<StageWork::State>(
      StageWork::State{.scene = std::make_shared<Scene>(known ? known->scene() : scene()),
                       .has_form = known != nullptr,
                       .settings = settings,
                       .picks = picks,
                       .preparation = preparation,
                       .means = state_->means(),
                       .version = forms.version()});
  if (known) work->known = known->rows();
  if (settings.proxy.kind == ProxyKind::ground && light.has() && !light.hasGroundSampler())
    work->environment = light.sharedEnvironment();
  if (light.has() && !light.hasForm(settings.sunShown())) work->lacks_cubes = light.sharedEnvironment();
  work->light_version = light.version();
  return StageWork(std::move(work));
}

Result<bool> Stage::take(StageWork work) {
  StageWork::State& done = work.state();
  SceneForms& forms = state_->scene;
  StagedLight& light = state_->light;
  if (done.ground_sampler && done.light_version == light.version())
    light.takeGroundSampler(std::move(*done.ground_sampler));
  if (done.cubes && done.light_version == light.version()) {
    const gl::Context& context = device().state().context;
    MIRRORBALL_TRY_VOID(context.enter());
    MIRRORBALL_TRY_VOID(light.takeForm(*done.cubes, context.filtersFloats()));
  }
  if (!done.has_form || done.version != forms.version()) return false;
  MIRRORBALL_TRY_VOID(device().state().context.enter());
  std::shared_ptr<StagedScene> form = forms.find(done.preparation);
  if (!form && done.makes_form) {
    MIRRORBALL_TRY(added, forms.add(done.preparation, std::move(done.scene)));
    form = std::move(added);
  }
  if (!form) return false;
  MIRRORBALL_TRY_VOID(form->take(std::move(done.made)));
  return true;
}

Result<void> Stage::setTransform(std::size_t instance, const glm::mat4& world_from_object) {
  if (instance >= scene().instances.size())
    return fail(ErrorCode::usage, "instance " + std::to_string(instance) + " of a scene of " +
                                      counted(scene().instances.size(), "instance"));
  MIRRORBALL_TRY_VOID(checkTransform(instance, world_from_object));
  MIRRORBALL_TRY_VOID(device().state().context.enter());
  return state_->scene.setTransform(instance, world_from_object);
}

Result<void> Stage::moveInstances(const std::vector<Instance>& instances) {
  const std::vector<Instance>& shown = scene().instances;
  const bool are_same = std::equal(instances.begin(), instances.end(), shown.begin(), shown.end(),
                                   [](const Instance& a, const Instance& b) { return a.mesh == b.mesh; });
  if (!are_same)
    return fail(ErrorCode::usage, "the instances that are to be moved are not those of the scene, which has " +
                                      std::to_string(shown.size()));
  for (std::size_t i = 0; i < instances.size(); ++i)
    MIRRORBALL_TRY_VOID(setTransform(i, instances[i].world_from_object));
  return {};
}

Result<void> Stage::setNode(std::size_t node, const NodePlace& place) {
  Scene changed = scene();
  MIRRORBALL_TRY_VOID(placeNode(changed, node, place));
  return setScene(std::move(changed));
}

Result<void> Stage::setLights(std::vector<ModelLight> lights) {
  if (lights.size() > Scene::kMaxLights)
    return fail(ErrorCode::usage,
                counted(lights.size(), "light") + "; a scene has at most " + std::to_string(Scene::kMaxLights));
  state_->scene.setLights(std::move(lights));
  return {};
}

Result<void> Stage::moveTo(const Device& device) {
  const gl::Context& context = device.state().context;
  MIRRORBALL_TRY_VOID(context.enter());
  auto moved = std::shared_ptr<State>(new State(device), EndOnDevice());
  moved->cache = state_->cache;
  MIRRORBALL_TRY_VOID(moved->scene.set(Scene(scene())));
  if (state_->light.has()) {
    MIRRORBALL_TRY(prepared, prepareEnvironment(state_->light.environment(), state_->cache));
    MIRRORBALL_TRY_VOID(moved->light.set(state_->light.environment(), prepared, context.filtersFloats()));
  }
  std::swap(*moved, *state_);  // copies of this stage are the same; what was there ends with the old device
  return {};
}

const Scene& Stage::scene() const { return state_->scene.scene(); }
const BoundingSphere& Stage::bounds() const { return state_->scene.bounds(); }

}  // namespace mirrorball
