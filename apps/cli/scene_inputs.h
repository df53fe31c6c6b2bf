#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "cli/stage_clock.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/model_stance.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::cli {

/// What a command that draws a model in an environment is told about the two.
struct SceneRequest {
  std::string model = "showcase";
  std::string environment = "studio";
  std::string from = {};
  ModelStance stance = {};
  QualityRequest wish = {Quality::draft};  ///< of commands whose pictures are as good as that says
  bool objects_move = false;               ///< among each other, in a turntable
  bool repair = false;
  bool inside_only = false;
  bool is_uncached = false;
  bool timings = false;
};

/// The table of them, but for the model.
std::span<const Option<SceneRequest>> sceneOptions();

/// A model, which may be left out, as a positional argument of that name.
///
/// usual   the model without it
Argument modelArgument(std::string_view name, const std::string& usual);

/// Adds the model.
void addModel(Command& command, std::string_view name, SceneRequest& request);

/// The user's cache folder, if there is one and it is to be used; remarks on one that cannot be used.
///
/// errors   as CacheFolder::ofUser's
Result<std::optional<CacheFolder>> cacheFolder(bool is_uncached);

/// Says what is doubtful about a frame of a scene.
///
/// errors   as checkFrame's
Result<void> checkShown(const FrameSettings& settings, const Scene& scene);

/// Loads the model alone, and changes its materials; says what its file has that is left out.
///
/// outputs  the files that will be written, none of which may be one that is read
/// errors   usage; as loadScene's
Result<Scene> loadModelFor(const SceneRequest& request, const MaterialChanges& materials, const FrameSettings& look,
                           std::span<const std::string> outputs);

/// Loads driver, model and environment at the same time, changes the model's materials, fills in what the quality asks
/// for, says what that is, and prepares the model for pictures that look so.
///
/// look     how it is to look
/// given    the options that the user gave, which stay as they are
/// outputs  the files that will be written, none of which may be one that is read
/// errors   usage, before anything is loaded where it can be told then; as loadRenderInputs'
Result<RenderInputs> loadInputs(const SceneRequest& request, const MaterialChanges& materials, FrameSettings& look,
                                const GivenOptions& given, std::span<const std::string> outputs, StageClock& clock);

/// Prepares a pose of a model as loadInputs does its first one.
///
/// pose     of AnimationFrames
/// look     filled in by loadInputs
/// errors   as changeMaterials' and prepareScene's
Result<Scene> preparedPose(Scene pose, const MaterialChanges& materials, const FrameSettings& look, StageClock& clock);

/// Loads model and environment for the reference, which needs no driver and no quality.
Result<SceneInputs> loadSceneFor(const SceneRequest& request, const MaterialChanges& materials,
                                 const FrameSettings& look, std::span<const std::string> outputs, StageClock& clock);

/// Says which of the options that were given, and what of the scene's materials, changes nothing.
void remarkOnIdleOptions(const Scene& scene, const FrameSettings& look, const GivenOptions& given);

/// A renderer of them.
///
/// errors   as Renderer's
Result<Renderer> rendererOf(RenderInputs inputs, StageClock& clock);

}  // namespace mirrorball::cli
