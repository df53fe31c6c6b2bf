#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "mirrorball/render/stage/device.h"
#include "mirrorball/render/stage/scene_forms.h"
#include "mirrorball/render/stage/stage.h"
#include "mirrorball/render/stage/staged_light.h"

namespace mirrorball {

/// What a stage has.
struct Stage::State {
  explicit State(Device on) : device(std::move(on)) {}

  Device device;  ///< outlives all else
  SceneForms scene = {};
  StagedLight light = {};
  std::optional<CacheFolder> cache = {};  ///< for what preparing the scene finds

  /// The form of the scene that frames with those settings show, made if it is not there.
  ///
  /// errors   as prepareScene's; too_large (a texture for this driver)
  Result<std::shared_ptr<StagedScene>> formFor(const FrameSettings& settings);
  PreparationMeans means() const;
};

}  // namespace mirrorball
