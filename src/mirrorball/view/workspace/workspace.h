#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Options that somebody has given, by name, each as it is written on a command line; one that may be repeated has
/// several texts. What is not given is as the tables have it, or as the model needs it (fillIn).
using GivenTexts = std::map<std::string, std::vector<std::string>, std::less<>>;

/// One of the two halves of a comparison: what it does otherwise than the picture, and in which light it stands.
struct Side {
  GivenTexts frame = {};                ///< of frameOptions(), beside Workspace::frame; of the camera there are none
  std::optional<std::size_t> map = {};  ///< of Workspace::maps; nothing: the one that is shown
  bool is_traced = false;               ///< by the path tracer: the truth

  bool operator==(const Side&) const = default;
};

/// How two halves are shown.
enum class CompareBy {
  none,        ///< the first alone
  slider,      ///< the first left of a line, the second right of it
  flip,        ///< one after the other, at a key
  difference,  ///< signed, as heat
  flip_error,  ///< what a viewer would see who flips: metric/flip
};

/// What a viewer shows, told in full: a value, which is kept, compared, undone and stored in a file. It holds names and
/// texts, no pictures. Two that are equal show the same.
struct Workspace {
  std::string model = "showcase";              ///< loadModel's
  std::vector<std::string> maps = {"studio"};  ///< loadEnvironment's, to step through; at least one
  std::size_t shown_map = 0;
  GivenTexts frame = {};                              ///< of frameOptions()
  GivenTexts materials = {};                          ///< of materialOptions(): of the whole model
  std::map<std::size_t, GivenTexts> parameters = {};  ///< of materialParameters(), for materials of the scene
  std::array<Side, 2> sides = {};
  CompareBy compare_by = CompareBy::none;
  float divider = 0.5f;         ///< of CompareBy::slider: the line's place, 0 … 1 of the width
  std::size_t edited_side = 0;  ///< which of the halves the panels change; without a comparison both are one
  std::optional<std::size_t> selected_material = {};  ///< of the scene

  bool operator==(const Workspace&) const = default;
};

/// Which table an option is of.
enum class OptionTable {
  frame,      ///< frameOptions(): of the half that is edited
  material,   ///< materialOptions(): of the whole model
  parameter,  ///< materialParameters(): of the material that is selected
};

/// Settings of the table that hold all of some texts.
///
/// errors   usage: a text that the option refuses, or an option that there is not
Result<FrameSettings> frameOf(const GivenTexts& given);
Result<MaterialChanges> materialsOf(const GivenTexts& given);
/// Sets parameters of a material.
///
/// errors   as frameOf's
Result<void> setParameters(const GivenTexts& given, Material& material);

/// Changes a scene's materials as a workspace says: first all of them, then single ones.
///
/// scene    as it was loaded
/// errors   usage: as changeMaterials'; a material that the scene has not
Result<void> changeMaterials(Scene& scene, const Workspace& workspace);

/// How a half is drawn.
///
/// errors   as frameOf's
Result<FrameSettings> frameOf(const Workspace& workspace, std::size_t side);

/// Whether an option is of both halves whatever they do otherwise: where the camera is, and how large the picture.
bool isShared(std::string_view frame_option);

// Changes. Each returns another workspace and leaves this one; what it refuses is told and changes nothing.

/// Gives an option of a table.
///
/// text     as a command line has it
/// errors   usage; also: no material is selected
Result<Workspace> withOption(Workspace workspace, OptionTable table, std::string_view name, std::string_view text);
/// Leaves an option to its default; one that is not given stays so.
Workspace withoutOption(Workspace workspace, OptionTable table, std::string_view name);

/// Shows the next panorama, or with −1 the one before; after the last comes the first.
Workspace withMapStepped(Workspace workspace, int by);

/// Adds a panorama behind the others, or finds it there, and shows it.
Workspace withMap(Workspace workspace, std::string name);

/// Moves the camera of both halves.
Workspace withCamera(Workspace workspace, const CameraOptions& camera);

/// Turns the light of the half that is edited: FrameSettings::env_rotation_deg.
Workspace withLightTurned(Workspace workspace, glm::vec3 env_rotation_deg);

}  // namespace mirrorball
