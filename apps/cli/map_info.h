#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/environment/file/compass_heading.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/statistics.h"
#include "mirrorball/output/baked/brdf_file.h"
#include "mirrorball/output/baked/lobe_row_files.h"
#include "mirrorball/scene/model_facts.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::cli {

/// Where a direction lies in one projection.
struct DirectionPlace {
  Projection projection;
  glm::ivec2 size{0};                     ///< of an image of that projection with the map's detail
  std::optional<MapPosition> place = {};  ///< nothing where the projection does not cover it
  glm::ivec2 texel{0};
};

/// What is asked of one direction.
struct DirectionInfo {
  glm::vec3 given{0.0f};
  glm::vec3 unit{0.0f};
  std::vector<DirectionPlace> places = {};
  glm::vec3 radiance{0.0f};
};

/// What is known of a map.
struct MapInfo {
  LoadedEnvironment loaded;
  float covered = 1.0f;  ///< share of the sphere
  RadianceStatistics statistics = {};
  std::optional<FilamentHarmonics> harmonics = {};  ///< that a file for Filament has
  std::optional<DirectionInfo> direction = {};      ///< if it was asked for
  std::optional<NorthInfo> north = {};
  bool is_north_alone = false;  ///< no more is asked for
};

/// What is known of a model.
struct ModelInfo {
  std::string format;  ///< "glTF"
  Scene scene;
  std::vector<MaterialFacts> materials = materialFacts(scene);
};

/// What is known of one input.
struct InputInfo {
  std::string name;
  std::variant<MapInfo, ModelInfo, FoundBrdfTable, FoundLobeRows, Error> what;
};

/// As text for a reader: each line ends, and the first is the name.
std::string textOf(const InputInfo& info);

/// As JSON (RFC 8259), which docs/command_line.md describes: an object for one, an array for several; with a newline.
std::string jsonOf(std::span<const InputInfo> inputs);

}  // namespace mirrorball::cli
