#include "cli/scene_inputs.h"

#include <array>
#include <future>
#include <optional>
#include <utility>

#include "cli/command_line.h"
#include "cli/files.h"
#include "cli/map_inputs.h"
#include "cli/terminal.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

const std::string kEnvironmentHelp = "the environment: a panorama, sphere map or cube map (" +
                                     std::string(readExtensions()) +
                                     "), or a built-in: " + join(builtinEnvironmentNames()) +
                                     "; sky takes parameters, as in sky:elevation=20,turbidity=3";

const std::array<Option<SceneRequest>, 7> kSceneOptions{{
    {{.name = "env",
      .value = "ENV",
      .help = kEnvironmentHelp,
      .letter = "e",
      .group = "Files",
      .takes_path = true,
      .names = builtinEnvironmentNames},
     &SceneRequest::environment},
    {{.name = "from",
      .value = "FORM",
      .help = "form of the environment map, if it is not recognised: a projection (see convert --to) or a cube layout",
      .group = "Files",
      .names = projectionNames},
     &SceneRequest::from},
    {{.name = "up",
      .choices = "y|z",
      .aliases = "+y=y|+z=z",
      .help = "axis of the model that points up: z in many .stl and CAD files, which lie on their side without it",
      .group = "Files"},
     choiceField<&SceneRequest::up>},
    {{.name = "repair",
      .help = "replace NaN and infinite texels of the environment by the mean of their neighbours",
      .group = "Files"},
     &SceneRequest::repair},
    {{.name = "no-cache", .help = "prefilter the environment anew, without the user's cache folder", .group = "Files"},
     &SceneRequest::is_uncached},
    {{.name = "timings", .help = "print how long each stage took", .group = "Files"}, &SceneRequest::timings},
    {kMaxMemoryText, &SceneRequest::max_memory},
}};

Result<Scene> loadScene(const SceneRequest& request, const MaterialChanges& materials) {
  MIRRORBALL_TRY(scene, loadModel(request.model));
  standUpright(scene, request.up);
  MIRRORBALL_TRY_VOID(changeMaterials(scene, materials));
  return scene;
}

}  // namespace

std::span<const Option<SceneRequest>> sceneOptions() { return kSceneOptions; }

void addModel(Command& command, std::string_view name, SceneRequest& request) {
  addArgument(command,
              {.name = name,
               .help = "a file (" + modelExtensions() + "), - for standard input, or a built-in: " +
                       join(builtinModelNames(), " ") + " (default " + request.model + ")",
               .names = builtinModelNames,
               .takes_path = true},
              request.model);
}

Result<SceneInputs> loadInputs(const SceneRequest& request, const MaterialChanges& materials,
                               std::span<const std::string> outputs, StageClock& clock) {
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.max_memory));
  MIRRORBALL_TRY(hint, formHintNamed(request.from));
  // A wrong name among the materials is told before anything is loaded.
  Scene no_scene;
  MIRRORBALL_TRY_VOID(changeMaterials(no_scene, materials));

  std::optional<PrefilterCache> cache;
  if (!request.is_uncached) {
    MIRRORBALL_TRY(of_user, PrefilterCache::ofUser());
    cache = std::move(of_user);
  }

  // None of the three needs the others.
  auto scene_later = std::async(
      besideOthers(), [&] { return clock.time("model: read", [&] { return loadScene(request, materials); }); });
  auto environment_later =
      std::async(besideOthers(), [&]() -> Result<std::pair<LoadedEnvironment, PreparedEnvironment>> {
        MIRRORBALL_TRY(loaded, clock.time("environment: read", [&] {
          return loadMap(request.environment, {.from = hint, .repair = request.repair});
        }));
        if (EnvironmentMap* map = loaded.environment.map()) takeNegativeAsNone(loaded.name, *map);
        MIRRORBALL_TRY(prepared, clock.time("environment: cube, mips, prefiltering",
                                            [&] { return prepareEnvironment(loaded.environment, cache); }));
        return std::pair(std::move(loaded), std::move(prepared));
      });
  auto context = clock.time("GL: start the driver", [] { return gl::Context::createHeadless(); });
  // Both are waited for before any error returns, since they refer to this frame.
  auto scene = scene_later.get();
  auto environment = environment_later.get();
  if (!scene) return fail(std::move(scene));
  if (!environment) return fail(std::move(environment));
  if (!context) return fail(std::move(context));

  auto& [loaded, prepared] = *environment;
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, outputs));
  MIRRORBALL_TRY_VOID(refuseOverwriting(scene->files, outputs));
  MIRRORBALL_TRY_VOID(refuseOverwriting(std::span(&request.model, 1), outputs));
  for (const std::string& warning : scene->warnings) remark(warning);
  return SceneInputs{std::move(*scene), std::move(loaded.environment), std::move(prepared), std::move(*context)};
}

Result<Renderer> rendererOf(SceneInputs inputs, StageClock& clock) {
  return clock.time("GL: upload, compile", [&]() -> Result<Renderer> {
    MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
    MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(inputs.environment), inputs.prepared));
    MIRRORBALL_TRY_VOID(renderer.setScene(std::move(inputs.scene)));
    return renderer;
  });
}

}  // namespace mirrorball::cli
