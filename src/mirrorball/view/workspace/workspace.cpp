#include "mirrorball/view/workspace/workspace.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/view/map/map_hand.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

tl::unexpected<Error> noOption(std::string_view name) {
  return fail(ErrorCode::usage, "there is no option '" + excerpt(std::string(name)) + "'");
}

/// A row of a table; null: it has none of that name.
template <typename Table>
auto* optionNamed(Table table, std::string_view name) {
  const auto found = findBy(table, name, [](const auto& each) { return each.text.name; });
  return found == table.end() ? nullptr : &*found;
}

template <typename Table, typename Target>
Result<void> assignAll(Table table, const GivenTexts& given, Target& target) {
  for (const auto& [name, texts] : given) {
    const auto* option = optionNamed(table, name);
    if (!option) return noOption(name);
    for (const std::string& text : texts) MIRRORBALL_TRY_VOID(assign(*option, target, text));
  }
  return {};
}

bool isOfQuality(std::string_view name) { return optionNamed(qualityOptions(), name) != nullptr; }

/// Gives an option of a table another text, after trying it.
///
/// beneath   the option's texts where it is not in `given`
template <typename Target, typename Table>
Result<void> give(Table table, std::string_view name, std::string_view text, const std::vector<std::string>& beneath,
                  GivenTexts& given) {
  const auto* option = optionNamed(table, name);
  if (!option) return noOption(name);
  Target tried;
  MIRRORBALL_TRY_VOID(assign(*option, tried, text));
  std::vector<std::string>& texts = given.try_emplace(std::string(name), beneath).first->second;
  if (!option->mayRepeat()) texts.clear();
  texts.emplace_back(text);
  return {};
}

std::vector<std::string> textsOf(const GivenTexts& given, std::string_view name) {
  const auto found = given.find(name);
  return found == given.end() ? std::vector<std::string>() : found->second;
}

constexpr std::array<std::string_view, 5> kShared{"camera", "target", "fov", "orthographic", "size"};

bool isComparing(const Workspace& workspace) { return workspace.compare_by != CompareBy::none; }

/// Whether what is given goes to both halves.
bool isOfBoth(const Workspace& workspace, std::string_view name) { return !isComparing(workspace) || isShared(name); }

GivenTexts& editedFrame(Workspace& workspace, std::string_view name) {
  return isOfBoth(workspace, name) ? workspace.frame : workspace.sides[editedSide(workspace)].frame;
}

/// What the panels change; null: no material is selected, or the map is no photograph.
GivenTexts* editedTexts(Workspace& workspace, OptionTable table, std::string_view name) {
  if (table == OptionTable::stance) return &workspace.stance;
  if (table == OptionTable::frame) return &editedFrame(workspace, name);
  if (table == OptionTable::material) return &workspace.materials;
  if (table == OptionTable::map_view) return &workspace.map_view;
  if (table == OptionTable::photo) {
    const auto found = workspace.photos.find(mapOf(workspace, editedSide(workspace)));
    return found == workspace.photos.end() ? nullptr : &found->second;
  }
  return workspace.selected_material ? &workspace.parameters[*workspace.selected_material] : nullptr;
}

/// Without materials of which nothing is said.
Workspace tidied(Workspace workspace) {
  std::erase_if(workspace.parameters, [](const auto& each) { return each.second.empty(); });
  return workspace;
}

Result<Workspace> withFrameOption(Workspace workspace, std::string_view name, std::string_view text) {
  const std::vector<std::string> of_both =
      isOfBoth(workspace, name) ? std::vector<std::string>() : textsOf(workspace.frame, name);
  GivenTexts& given = editedFrame(workspace, name);
  MIRRORBALL_TRY_VOID(isOfQuality(name) ? give<QualityRequest>(qualityOptions(), name, text, of_both, given)
                                        : give<FrameSettings>(frameOptions(), name, text, of_both, given));
  // A repeated one may be one too many.
  for (std::size_t side = 0; side < workspace.sides.size(); ++side) {
    const auto settings = frameOf(workspace, side);
    if (!settings) return tl::unexpected<Error>(settings.error());
  }
  return workspace;
}

Result<Workspace> withMaterialOption(Workspace workspace, std::string_view name, std::string_view text) {
  MIRRORBALL_TRY_VOID(give<MaterialChanges>(materialOptions(), name, text, {}, workspace.materials));
  MIRRORBALL_TRY(changes, materialsOf(workspace.materials));
  MIRRORBALL_TRY_VOID(checkChanges(changes));
  return workspace;
}

void erase(GivenTexts& given, std::string_view name) {
  if (const auto found = given.find(name); found != given.end()) given.erase(found);
}

}  // namespace

Result<FrameSettings> frameOf(const GivenTexts& given) {
  FrameSettings settings;
  for (const auto& each : given)
    if (!isOfQuality(each.first)) MIRRORBALL_TRY_VOID(assignAll(frameOptions(), {each}, settings));
  return settings;
}

Result<Quality> qualityOf(const GivenTexts& given) {
  QualityRequest wish;
  for (const auto& each : given)
    if (isOfQuality(each.first)) MIRRORBALL_TRY_VOID(assignAll(qualityOptions(), {each}, wish));
  return wish.quality;
}

Result<ModelStance> stanceOf(const GivenTexts& given) {
  ModelStance stance;
  MIRRORBALL_TRY_VOID(assignAll(stanceOptions(), given, stance));
  return stance;
}

Result<MaterialChanges> materialsOf(const GivenTexts& given) {
  MaterialChanges changes;
  MIRRORBALL_TRY_VOID(assignAll(materialOptions(), given, changes));
  return changes;
}

Result<void> setParameters(const GivenTexts& given, Material& material) {
  return assignAll(materialParameters(), given, material);
}

bool isShared(std::string_view frame_option) { return contains(kShared, frame_option); }

std::size_t editedSide(const Workspace& workspace) { return isComparing(workspace) ? workspace.edited_side : 0; }

GivenTexts givenFrame(const Workspace& workspace, std::size_t side) {
  GivenTexts given = workspace.frame;
  if (!isComparing(workspace)) return given;
  for (const auto& [name, texts] : workspace.sides[side].frame) given[name] = texts;
  return given;
}

Result<FrameSettings> frameOf(const Workspace& workspace, std::size_t side) {
  return frameOf(givenFrame(workspace, side));
}

Result<void> changeParameters(Scene& scene, const Workspace& workspace) {
  for (const auto& [index, given] : workspace.parameters)
    if (index < scene.materials.size()) MIRRORBALL_TRY_VOID(setParameters(given, scene.materials[index]));
  return {};
}

Result<Workspace> withOption(Workspace workspace, OptionTable table, std::string_view name, std::string_view text) {
  if (table == OptionTable::frame) return withFrameOption(std::move(workspace), name, text);
  if (table == OptionTable::material) return withMaterialOption(std::move(workspace), name, text);
  GivenTexts* given = editedTexts(workspace, table, name);
  if (!given)
    return fail(ErrorCode::usage,
                std::string(name) + (table == OptionTable::photo ? ": the map is no photograph of a mirror ball"
                                                                 : ": no material is selected"));
  if (table == OptionTable::photo) {
    MIRRORBALL_TRY_VOID(give<BallPhotoSettings>(ballPhotoOptions(), name, text, {}, *given));
    MIRRORBALL_TRY_VOID(ballPhotoOf(*given));
  } else if (table == OptionTable::stance) {
    MIRRORBALL_TRY_VOID(give<ModelStance>(stanceOptions(), name, text, {}, *given));
  } else if (table == OptionTable::map_view) {
    MIRRORBALL_TRY_VOID(give<MapViewSettings>(mapViewOptions(), name, text, {}, *given));
  } else {
    MIRRORBALL_TRY_VOID(give<Material>(materialParameters(), name, text, {}, *given));
  }
  return workspace;
}

Workspace withoutOption(Workspace workspace, OptionTable table, std::string_view name) {
  if (GivenTexts* given = editedTexts(workspace, table, name)) erase(*given, name);
  return tidied(std::move(workspace));
}

Workspace withoutText(Workspace workspace, OptionTable table, std::string_view name, std::size_t index) {
  GivenTexts* given = editedTexts(workspace, table, name);
  if (!given) return workspace;
  const bool is_of_half = table == OptionTable::frame && !isOfBoth(workspace, name);
  std::vector<std::string> texts = textsOf(is_of_half ? givenFrame(workspace, editedSide(workspace)) : *given, name);
  if (index >= texts.size()) return tidied(std::move(workspace));
  texts.erase(texts.begin() + static_cast<std::ptrdiff_t>(index));
  // A half without texts has none of those that both have.
  if (texts.empty() && !is_of_half)
    erase(*given, name);
  else
    (*given)[std::string(name)] = std::move(texts);
  return tidied(std::move(workspace));
}

Workspace withoutOptions(Workspace workspace) {
  std::erase_if(workspace.frame, [](const auto& each) { return !isShared(each.first); });
  workspace.stance.clear();
  workspace.plays = false;
  workspace.materials.clear();
  workspace.parameters.clear();
  workspace.map_view.clear();
  for (auto& [name, given] : workspace.photos) given.clear();
  for (Side& side : workspace.sides) side.frame.clear();
  return workspace;
}

Workspace withModel(Workspace workspace, std::string name) {
  workspace.model = std::move(name);
  workspace.stance.clear();
  workspace.plays = false;
  workspace.parameters.clear();
  workspace.selected_material.reset();
  erase(workspace.materials, "variant");
  CameraOptions camera = frameOf(workspace.frame).value_or(FrameSettings()).camera;
  camera.name.clear();
  camera.distance.reset();
  camera.target.reset();
  return withCamera(std::move(workspace), camera);
}

namespace {

std::size_t indexOfMap(const Workspace& workspace, std::size_t side) {
  const bool is_own = isComparing(workspace) && workspace.sides[side].map;
  return is_own ? *workspace.sides[side].map : workspace.shown_map;
}

}  // namespace

bool hasSeveralMaps(const Workspace& workspace) { return workspace.maps.size() > 1; }

Workspace withMapShown(Workspace workspace, std::size_t map) {
  if (indexOfMap(workspace, editedSide(workspace)) == map) return workspace;
  if (isComparing(workspace))
    workspace.sides[editedSide(workspace)].map = map;
  else
    workspace.shown_map = map;
  return workspace;
}

Workspace withMapStepped(Workspace workspace, int by) {
  const auto count = static_cast<std::ptrdiff_t>(workspace.maps.size());
  const auto shown = static_cast<std::ptrdiff_t>(indexOfMap(workspace, editedSide(workspace)));
  const std::ptrdiff_t next = (shown + by) % count;
  return withMapShown(std::move(workspace), static_cast<std::size_t>(next < 0 ? next + count : next));
}

Workspace withMap(Workspace workspace, std::string name) {
  const auto found = std::find(workspace.maps.begin(), workspace.maps.end(), name);
  const auto map = static_cast<std::size_t>(found - workspace.maps.begin());
  if (found == workspace.maps.end()) workspace.maps.push_back(std::move(name));
  return withMapShown(std::move(workspace), map);
}

Workspace withOnlyMap(Workspace workspace, std::string name) {
  std::erase_if(workspace.photos, [&](const auto& each) { return each.first != name; });
  workspace.maps = {std::move(name)};
  workspace.shown_map = 0;
  for (Side& side : workspace.sides) side.map.reset();
  return workspace;
}

const std::string& mapOf(const Workspace& workspace, std::size_t side) {
  return workspace.maps[indexOfMap(workspace, side)];
}

bool isTraced(const Workspace& workspace, std::size_t side) {
  return isComparing(workspace) && workspace.sides[side].is_traced;
}

Workspace withEditedSide(Workspace workspace, std::size_t side) {
  workspace.edited_side = side;
  return workspace;
}

Workspace withTruth(Workspace workspace) {
  Side& edited = workspace.sides[editedSide(workspace)];
  if (!isComparing(workspace)) {
    workspace.compare_by = CompareBy::flip;
    workspace.sides[1].is_traced = true;
    workspace.edited_side = 0;
  } else if (workspace.compare_by == CompareBy::flip && workspace.sides[1].is_traced) {
    workspace.edited_side = 1 - workspace.edited_side;
  } else {
    edited.is_traced = !edited.is_traced;
  }
  return workspace;
}

namespace {

/// Gives an option the text that it has in some settings; what is so without it is no text.
///
/// beneath   what there is without it
template <typename Target>
void giveAs(const Option<Target>& option, const Target& settings, const Target& beneath, GivenTexts& given) {
  std::string text = written(option, settings);
  if (text == written(option, beneath))
    erase(given, option.text.name);
  else
    given[std::string(option.text.name)] = {std::move(text)};
}

void giveAs(const FrameSettings& settings, std::string_view name, const FrameSettings& beneath, GivenTexts& given) {
  if (const auto* option = optionNamed(frameOptions(), name)) giveAs(*option, settings, beneath, given);
}

/// Gives an option of the half that is edited the value that it has in some settings.
void giveAsEdited(const FrameSettings& settings, std::string_view name, Workspace& workspace) {
  const auto of_both = frameOf(workspace.frame);
  giveAs(settings, name, isOfBoth(workspace, name) || !of_both ? FrameSettings() : *of_both,
         editedFrame(workspace, name));
}

}  // namespace

Workspace withCamera(Workspace workspace, const CameraOptions& camera) {
  FrameSettings settings;
  settings.camera = camera;
  for (const std::string_view name : {"camera", "target", "fov", "orthographic"})
    giveAs(settings, name, FrameSettings(), workspace.frame);
  return workspace;
}

Workspace withShowcase(Workspace workspace) {
  std::set<std::string_view> given;
  for (const auto& [name, texts] : workspace.frame) given.insert(name);
  std::string environment = workspace.maps.front();
  FrameSettings settings;
  setShowcase(given, environment, settings);
  GivenTexts frame = workspace.frame;
  for (const auto& option : frameOptions())
    if (!given.contains(option.text.name)) giveAs(settings, option.text.name, FrameSettings(), frame);
  workspace.frame = std::move(frame);
  return withOnlyMap(std::move(workspace), std::move(environment));
}

Workspace withLightTurned(Workspace workspace, glm::vec3 env_rotation_deg) {
  FrameSettings settings;
  settings.env_rotation_deg = env_rotation_deg;
  giveAsEdited(settings, "env-rotation", workspace);
  return workspace;
}

Workspace withMoment(Workspace workspace, std::string animation, float seconds) {
  const ModelStance stance{.animation = {std::move(animation), seconds >= 0.0f ? seconds : 0.0f}};
  if (const auto* option = optionNamed(stanceOptions(), "animation"))
    giveAs(*option, stance, ModelStance(), workspace.stance);
  return workspace;
}

Result<MapViewSettings> mapViewOf(const Workspace& workspace) {
  MapViewSettings settings;
  MIRRORBALL_TRY_VOID(assignAll(mapViewOptions(), workspace.map_view, settings));
  return settings;
}

Workspace withMapView(Workspace workspace, const MapViewSettings& settings) {
  for (const auto& option : mapViewOptions()) giveAs(option, settings, MapViewSettings(), workspace.map_view);
  return workspace;
}

Workspace exposedBy(Workspace workspace, float stops) {
  if (workspace.shows_map) {
    const auto settings = mapViewOf(workspace);
    return settings ? withMapView(std::move(workspace), exposedBy(*settings, stops)) : workspace;
  }
  auto settings = frameOf(workspace, editedSide(workspace));
  if (!settings) return workspace;
  settings->display = exposedBy(MapViewSettings{.display = settings->display}, stops).display;
  giveAsEdited(*settings, "exposure", workspace);
  return workspace;
}

}  // namespace mirrorball
