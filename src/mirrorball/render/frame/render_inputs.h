#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/observer.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/technique_choice.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A model and an environment, by their names.
struct RenderInputNames {
  std::string model = "showcase";  ///< a file or a built-in: loadModel
  ModelLoadOptions load_model = {};
  UpAxis up = UpAxis::y;
  MaterialChanges materials = {};
  FrameSettings frame = {};            ///< of the pictures
  std::string environment = "studio";  ///< a file or a built-in: loadEnvironment
  EnvironmentLoadOptions load = {};    ///< of the environment
  /// What loads the environment in place of loadEnvironment; empty: that does.
  std::function<Result<LoadedEnvironment>(const ProgressFunction&)> load_environment = {};
  /// Where prefiltered environments and occlusion are kept, if they are.
  std::optional<CacheFolder> cache = {};
  /// What fills in the settings of the frame for the model (chooseTechniques), beside the loading of the environment;
  /// nothing: they stay as they are.
  std::optional<TechniqueWishes> wishes = {};
};

/// What there is to draw.
struct SceneInputs {
  Scene scene;
  Environment environment;
  std::vector<std::string> files;  ///< that were read
  FrameSettings frame = {};        ///< whose camera holds the shadow on the ground; drawn pictures': filled in
};

/// That, and what draws it.
struct RenderInputs : SceneInputs {
  PreparedEnvironment prepared;
  gl::Context context;      ///< without a window, current
  std::string chosen = {};  ///< what was filled in, as chooseTechniques tells it
};

/// Prepares a model that was loaded, or a pose of one: its axis up, its materials as told, and for a kind of relief.
///
/// largest_texture   of the driver that will draw it: prepareRelief
/// errors            usage (materials that are not there); as prepareRelief's
Result<void> prepareModel(Scene& scene, UpAxis up, const MaterialChanges& materials, ReliefKind relief,
                          const std::function<int()>& largest_texture = {});

/// Loads the model alone, with its axis up and its materials as told.
///
/// largest_texture   of the driver that will draw it: prepareRelief
/// errors            usage (materials that are not there); as loadModel's and prepareRelief's
Result<Scene> loadScene(const RenderInputNames& names, const std::function<int()>& largest_texture = {});

/// Loads the model and the environment at the same time, without a driver; its suns are discs where the frame wants
/// them apart.
///
/// observer told what is doubtful about them; values of the environment below 0 are taken as 0
/// errors   usage (materials that are not there); as loadModel's, loadEnvironment's and checkLight's
Result<SceneInputs> loadSceneInputs(const RenderInputNames& names, const Observer& observer = {});

/// Loads the model and the environment and starts the driver, all at the same time.
///
/// observer told what is doubtful about them; values of the environment below 0 are taken as 0
/// errors   usage (materials that are not there); as loadModel's, loadEnvironment's, checkLight's and
///          gl::Context::createHeadless's
/// cost     that of the slowest of the three
Result<RenderInputs> loadRenderInputs(const RenderInputNames& names, const Observer& observer = {});

/// A renderer of them.
///
/// errors   as Renderer's
Result<Renderer> rendererOf(RenderInputs inputs);

}  // namespace mirrorball
