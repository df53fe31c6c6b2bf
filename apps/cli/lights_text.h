#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/light_edit/lamp_energy.h"
#include "mirrorball/light_edit/lamp_split.h"

namespace mirrorball::cli {

/// What `lights` found of a map.
struct FoundLights {
  std::string name;                    ///< the map's, as it is said
  float min_share = 0.0f;              ///< that was asked for
  std::vector<MapLamp> lamps = {};     ///< those that stay in the map: without --split all
  std::vector<MapLamp> taken = {};     ///< with --split: those that were taken out of it
  std::vector<LampError> errors = {};  ///< of those
  bool is_split = false;
  std::optional<float> scale = {};  ///< with --scale: of the lamps' light; they are as they were before
};

/// Tables of them, for a reader.
std::string textOf(const FoundLights& found);

/// The same for programs.
std::string jsonOf(const FoundLights& found);

}  // namespace mirrorball::cli
