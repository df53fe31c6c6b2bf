#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/model_stance.h"

namespace mirrorball {

/// How a contact sheet looks.
struct ContactSettings {
  int columns = 0;                        ///< 0: as many as give the sheet a landscape shape
  int width_px = 320;                     ///< of a cell, 32 … 4096
  std::optional<float> exposure_ev = {};  ///< nothing: of each map automaticExposure's, of models 0
  glm::vec3 background{0.0232f};          ///< of the sheet, and behind models: linear light of a display, #2a2a2a
  std::string environment = "studio";     ///< that models stand in: loadEnvironment
  std::string from = {};                  ///< form of maps and environment: formHintNamed
  FrameSettings frame{.display{.tone_map = ToneMap::agx}};  ///< camera and samples of models; tone map of all
  QualityRequest quality = {Quality::good};                 ///< of models
  ModelStance stance = {};                                  ///< of models
  bool inside_only = false;                                 ///< ModelLoadOptions'
  std::set<std::string_view> stated = {};                   ///< names of options that the quality leaves as they are
};

/// The table of what is a sheet's alone; a frontend adds rows of frameOptions(), stanceOptions() and qualityOptions().
std::span<const Option<ContactSettings>> contactOptions();

}  // namespace mirrorball
