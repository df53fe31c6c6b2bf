#pragma once

#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::quality {

/// A scene made by code in which the light that near surfaces hide or reflect is hard to know at vertices.
struct HiddenScene {
  const char* name;  ///< of its files
  Scene (*make)();
  const char* shown;               ///< options of `render`: environment and camera
  bool is_measured_often = false;  ///< by `./test --all` too; the others by the tier long alone
};

/// Width and height of their pictures.
inline constexpr const char* kHiddenSize = "160x120";

std::span<const HiddenScene> hiddenScenes();

/// The scene of that name, which must be among them.
const HiddenScene& hiddenSceneNamed(std::string_view name);

/// What follows `render` and the file of a scene.
///
/// how   "--quality draft", or "--reference"
std::string shownBy(const HiddenScene& scene, const std::string& how);

/// How GoogleTest shows it.
inline void PrintTo(const HiddenScene& scene, std::ostream* out) { *out << scene.name; }

}  // namespace mirrorball::quality
