#include "cli/scene_inputs.h"

#include <array>
#include <utility>

#include "cli/command_line.h"
#include "cli/map_inputs.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/render/settings/idle_options.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

const std::string kEnvironmentHelp = "the environment: a panorama, sphere map or cube map (" +
                                     std::string(readExtensions()) +
                                     "), or a built-in: " + join(builtinEnvironmentNames()) +
                                     "; sky takes parameters, as in sky:elevation=20,turbidity=3";

const auto kSceneOptions = std::to_array<Option<SceneRequest>>({
    {environmentText(kEnvironmentHelp), &SceneRequest::environment},
    {formText("form of the environment map, if it is not recognised: a projection (see convert --to) or a cube layout",
              "Files"),
     &SceneRequest::from},
    {kInsideOnlyText, &SceneRequest::inside_only},
    {{.name = "repair",
      .help = "replace NaN and infinite texels of the environment by the mean of their neighbours",
      .group = "Files"},
     &SceneRequest::repair},
    {{.name = "no-cache",
      .help = "make what the user's cache folder keeps anew, without that folder: the prefiltered environment and, "
              "where it is found, the model's occlusion",
      .group = "Files"},
     &SceneRequest::is_uncached},
    {{.name = "timings", .help = "print how long each stage took", .group = "Files"}, &SceneRequest::timings},
    {kMaxMemoryText, kMemoryLimitField<SceneRequest>},
});

}  // namespace

std::span<const Option<SceneRequest>> sceneOptions() { return kSceneOptions; }

Argument modelArgument(std::string_view name, const std::string& usual) {
  return {.name = name,
          .help = "a file (" + modelExtensions() + "), - for standard input, or a built-in: " +
                  join(builtinModelNames(), " ") + " (default " + usual + ")",
          .names = builtinModelNames,
          .takes_path = true};
}

void addModel(Command& command, std::string_view name, SceneRequest& request) {
  addArgument(command, modelArgument(name, request.model), request.model);
}

namespace {

/// errors   usage
Result<RenderInputNames> inputNamesOf(const SceneRequest& request, const MaterialChanges& materials,
                                      const FrameSettings& look) {
  MIRRORBALL_TRY(hint, formHintNamed(request.from));
  return RenderInputNames{.model = request.model,
                          .load_model = {.inside_only = request.inside_only, .animation = request.stance.animation},
                          .up = request.stance.up,
                          .materials = materials,
                          .frame = look,
                          .environment = request.environment,
                          .load = {.from = hint, .repair = request.repair}};
}

/// errors   usage: an output is the model, or one of the files that were read
Result<void> refuseOverwritingInputs(const SceneRequest& request, std::span<const std::string> files,
                                     std::span<const std::string> outputs) {
  MIRRORBALL_TRY_VOID(refuseOverwriting(files, outputs));
  return refuseOverwriting(std::span(&request.model, 1), outputs);
}

/// What was loaded, if it is none of the outputs.
template <typename Inputs>
Result<Inputs> checkedInputs(Result<Inputs> inputs, const SceneRequest& request, std::span<const std::string> outputs) {
  if (!inputs) return tl::unexpected<Error>(ofMap(request.environment, std::move(inputs).error()));
  MIRRORBALL_TRY_VOID(refuseOverwritingInputs(request, inputs->files, outputs));
  return inputs;
}

}  // namespace

Result<std::optional<CacheFolder>> cacheFolder(bool is_uncached) {
  if (is_uncached) return std::optional<CacheFolder>();
  MIRRORBALL_TRY(folder, CacheFolder::ofUser());
  if (folder)
    if (const auto usable = folder->check(); !usable) remark(usable.error().message);
  return folder;
}

Result<void> checkShown(const FrameSettings& settings, const Scene& scene) {
  MIRRORBALL_TRY(doubts, checkFrame(settings, scene));
  for (const std::string& line : doubts) remark(line);
  return {};
}

Result<Scene> loadModelFor(const SceneRequest& request, const MaterialChanges& materials, const FrameSettings& look,
                           std::span<const std::string> outputs) {
  MIRRORBALL_TRY(names, inputNamesOf(request, materials, look));
  MIRRORBALL_TRY(scene, loadScene(names));
  MIRRORBALL_TRY_VOID(refuseOverwritingInputs(request, scene.files, outputs));
  for (const std::string& warning : scene.warnings) remark(warning);
  return scene;
}

namespace {

std::string nameOf(const QualityRequest& wish) { return written(qualityOptions().front(), wish); }

}  // namespace

Result<RenderInputs> loadInputs(const SceneRequest& request, const MaterialChanges& materials, FrameSettings& look,
                                const GivenOptions& given, std::span<const std::string> outputs, StageClock& clock) {
  MIRRORBALL_TRY(names, inputNamesOf(request, materials, look));
  MIRRORBALL_TRY(cache, cacheFolder(request.is_uncached));
  names.cache = std::move(cache);
  names.wishes = TechniqueWishes{request.wish.quality, given, request.objects_move};
  auto inputs = loadRenderInputs(names, clock.observing(terminalObserver()));
  if (inputs) look = inputs->frame;
  if (inputs && !inputs->chosen.empty()) remark("--quality " + nameOf(request.wish) + " chose " + inputs->chosen);
  return checkedInputs(std::move(inputs), request, outputs);
}

Result<Scene> preparedPose(Scene pose, const MaterialChanges& materials, const FrameSettings& look, StageClock& clock) {
  MIRRORBALL_TRY_VOID(changeMaterials(pose, materials));
  // Each is drawn once, and so is not kept for later.
  MIRRORBALL_TRY_VOID(clock.time("model: relief, occlusion", [&] {
    return prepareScene(pose, preparationFor(look), {.progress = progressBar("occlusion")});
  }));
  return pose;
}

Result<SceneInputs> loadSceneFor(const SceneRequest& request, const MaterialChanges& materials,
                                 const FrameSettings& look, std::span<const std::string> outputs, StageClock& clock) {
  MIRRORBALL_TRY(names, inputNamesOf(request, materials, look));
  return checkedInputs(loadSceneInputs(names, clock.observing(terminalObserver())), request, outputs);
}

void remarkOnIdleOptions(const Scene& scene, const FrameSettings& look, const GivenOptions& given) {
  for (const std::string& line : idleOptions(scene, look, given)) remark(line);
}

Result<Renderer> rendererOf(RenderInputs inputs, StageClock& clock) {
  return clock.time("GL: upload, compile", [&] { return mirrorball::rendererOf(std::move(inputs)); });
}

}  // namespace mirrorball::cli
