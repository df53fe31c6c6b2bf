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
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/model_stance.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/map/map_view_settings.h"

namespace mirrorball {

/// Options that somebody has given, by name, each as it is written on a command line; one that may be repeated has
/// several texts. What is not given is as the tables have it.
using GivenTexts = std::map<std::string, std::vector<std::string>, std::less<>>;

/// One of the two halves of a comparison: in what it differs from the options of both. Without a comparison it counts
/// for nothing.
struct Side {
  GivenTexts frame = {};  ///< of those tables too, in place of Workspace::frame's; an option without texts is not given
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

/// All that says what a viewer shows: a value, which is kept, compared, undone and stored in a file. It holds names and
/// texts, no pictures. Two that are equal show the same.
struct Workspace {
  std::string model = "showcase";              ///< loadModel's
  std::vector<std::string> maps = {"studio"};  ///< loadEnvironment's, to step through; at least one
  std::size_t shown_map = 0;
  /// Those of `maps` that are photographs of a mirror ball, by name: of ballPhotoOptions().
  std::map<std::string, GivenTexts> photos = {};
  GivenTexts stance = {};                             ///< of stanceOptions(): how the model stands
  bool plays = false;                                 ///< its animation goes on
  GivenTexts frame = {};                              ///< of frameOptions() and qualityOptions()
  GivenTexts materials = {};                          ///< of materialOptions(): of the whole model
  std::map<std::size_t, GivenTexts> parameters = {};  ///< of materialParameters(), for materials of the scene
  std::array<Side, 2> sides = {};
  CompareBy compare_by = CompareBy::none;
  float divider = 0.5f;                               ///< of CompareBy::slider: the line's place, 0 … 1 of the width
  std::size_t edited_side = 0;                        ///< which of the halves the panels change, in a comparison
  std::optional<std::size_t> selected_material = {};  ///< of the scene
  bool inspects = false;                              ///< tells what is under the pointer
  bool shows_map = false;                             ///< the panorama, without the model
  GivenTexts map_view = {};                           ///< of mapViewOptions(): how that is looked at

  bool operator==(const Workspace&) const = default;
};

/// Which table an option is of.
enum class OptionTable {
  stance,     ///< stanceOptions()
  frame,      ///< frameOptions() and qualityOptions(): of the half that is edited
  material,   ///< materialOptions(): of the whole model
  parameter,  ///< materialParameters(): of the material that is selected
  map_view,   ///< mapViewOptions()
  photo,      ///< ballPhotoOptions(): of the photograph of the half that is edited
};

/// Settings of the table that hold all of some texts.
///
/// errors   usage: a text that the option refuses, or an option that there is not
Result<FrameSettings> frameOf(const GivenTexts& given);  ///< but for the quality
Result<Quality> qualityOf(const GivenTexts& given);
Result<ModelStance> stanceOf(const GivenTexts& given);
Result<MaterialChanges> materialsOf(const GivenTexts& given);
/// Sets parameters of a material.
///
/// errors   as frameOf's
Result<void> setParameters(const GivenTexts& given, Material& material);

/// How the map is looked at without the model.
///
/// errors   as frameOf's
Result<MapViewSettings> mapViewOf(const Workspace& workspace);
Workspace withMapView(Workspace workspace, const MapViewSettings& settings);

/// The exposure some stops up or down: of the map where that is shown, else of the half that is edited.
Workspace exposedBy(Workspace workspace, float stops);

/// Whether an option is of both halves in any case: where the camera is, and how large the picture.
bool isShared(std::string_view frame_option);

/// The half that panels and hands change: 0 without a comparison.
std::size_t editedSide(const Workspace& workspace);

/// The options that a half is drawn with.
GivenTexts givenFrame(const Workspace& workspace, std::size_t side);

/// Whether a half is traced by paths.
bool isTraced(const Workspace& workspace, std::size_t side);

/// How a half is drawn.
///
/// errors   as frameOf's
Result<FrameSettings> frameOf(const Workspace& workspace, std::size_t side);

/// Changes single materials of a scene, after materialsOf(workspace.materials) has changed all of them. What is said of
/// materials that the scene has not is left alone.
///
/// errors   usage
Result<void> changeParameters(Scene& scene, const Workspace& workspace);

// Changes. Each returns another workspace and leaves this one; what it refuses is told and changes nothing.

/// Gives an option of a table: of the half that is edited, or of the material that is selected. One that may be
/// repeated gets one text more.
///
/// text     as a command line has it
/// errors   usage; also: no material is selected, or the map is no photograph
Result<Workspace> withOption(Workspace workspace, OptionTable table, std::string_view name, std::string_view text);
/// Leaves an option to its default, in a comparison to what both halves have; one that is not given stays so.
Workspace withoutOption(Workspace workspace, OptionTable table, std::string_view name);
/// Takes one text of an option away, which may be repeated.
///
/// index    of its texts (givenFrame); one that there is not changes nothing
Workspace withoutText(Workspace workspace, OptionTable table, std::string_view name, std::size_t index);
/// Leaves all options to their defaults, in both halves, of all materials and photographs; only the camera stays.
Workspace withoutOptions(Workspace workspace);

/// Shows another model: how the one before stood, what was said of its single materials, and where its camera stood, is
/// forgotten.
Workspace withModel(Workspace workspace, std::string name);

/// Shows a moment of an animation of the model.
///
/// seconds   below 0 is the start
Workspace withMoment(Workspace workspace, std::string animation, float seconds);

/// The showcase as `render` shows it if no environment is asked for (setShowcase): what was given stays.
Workspace withShowcase(Workspace workspace);

/// Whether there are panoramas to choose among.
bool hasSeveralMaps(const Workspace& workspace);

/// Shows one of its panoramas: in a comparison in the half that is edited.
Workspace withMapShown(Workspace workspace, std::size_t map);

/// Shows the next panorama likewise, or with −1 the one before; after the last comes the first.
Workspace withMapStepped(Workspace workspace, int by);

/// Adds a panorama behind the others, or finds it there, and shows it likewise.
Workspace withMap(Workspace workspace, std::string name);

/// Has that panorama alone.
Workspace withOnlyMap(Workspace workspace, std::string name);

/// The panorama of a half.
const std::string& mapOf(const Workspace& workspace, std::size_t side);

/// Compares with the truth by flipping: the second half is traced, and the first is seen. Where it is so, the other
/// half is seen; in another comparison the half that is edited becomes a traced one, or a drawn one again.
Workspace withTruth(Workspace workspace);

/// Has panels and hands change that half from now on, 0 or 1.
Workspace withEditedSide(Workspace workspace, std::size_t side);

/// Moves the camera of both halves.
Workspace withCamera(Workspace workspace, const CameraOptions& camera);

/// Turns the light of the half that is edited: FrameSettings::env_rotation_deg.
Workspace withLightTurned(Workspace workspace, glm::vec3 env_rotation_deg);

}  // namespace mirrorball
