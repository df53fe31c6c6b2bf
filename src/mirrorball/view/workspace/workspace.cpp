#include "mirrorball/view/workspace/workspace.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

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

/// Gives an option of a table another text, after trying it.
template <typename Target, typename Table>
Result<void> give(Table table, std::string_view name, std::string_view text, GivenTexts& given) {
  const auto* option = optionNamed(table, name);
  if (!option) return noOption(name);
  Target tried;
  MIRRORBALL_TRY_VOID(assign(*option, tried, text));
  std::vector<std::string>& texts = given[std::string(name)];
  if (!option->mayRepeat()) texts.clear();
  texts.emplace_back(text);
  return {};
}

/// Of what a half does otherwise, those on top.
GivenTexts together(GivenTexts beneath, const GivenTexts& on_top) {
  for (const auto& [name, texts] : on_top) beneath[name] = texts;
  return beneath;
}

constexpr std::array<std::string_view, 5> kShared{"camera", "target", "fov", "orthographic", "size"};

/// What the panels change.
GivenTexts& editedFrame(Workspace& workspace, std::string_view name) {
  const bool is_of_both = workspace.compare_by == CompareBy::none || isShared(name);
  return is_of_both ? workspace.frame : workspace.sides[workspace.edited_side].frame;
}

Result<Workspace> withParameter(Workspace workspace, std::string_view name, std::string_view text) {
  if (!workspace.selected_material) return fail(ErrorCode::usage, std::string(name) + ": no material is selected");
  GivenTexts& given = workspace.parameters[*workspace.selected_material];
  MIRRORBALL_TRY_VOID(give<Material>(materialParameters(), name, text, given));
  return workspace;
}

Result<Workspace> withMaterialOption(Workspace workspace, std::string_view name, std::string_view text) {
  MIRRORBALL_TRY_VOID(give<MaterialChanges>(materialOptions(), name, text, workspace.materials));
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
  MIRRORBALL_TRY_VOID(assignAll(frameOptions(), given, settings));
  return settings;
}

Result<MaterialChanges> materialsOf(const GivenTexts& given) {
  MaterialChanges changes;
  MIRRORBALL_TRY_VOID(assignAll(materialOptions(), given, changes));
  return changes;
}

Result<void> setParameters(const GivenTexts& given, Material& material) {
  return assignAll(materialParameters(), given, material);
}

Result<FrameSettings> frameOf(const Workspace& workspace, std::size_t side) {
  return frameOf(together(workspace.frame, workspace.sides[side].frame));
}

bool isShared(std::string_view frame_option) { return contains(kShared, frame_option); }

Result<void> changeMaterials(Scene& scene, const Workspace& workspace) {
  MIRRORBALL_TRY(changes, materialsOf(workspace.materials));
  MIRRORBALL_TRY_VOID(changeMaterials(scene, changes));
  for (const auto& [index, given] : workspace.parameters) {
    if (index >= scene.materials.size())
      return fail(ErrorCode::usage, "material " + std::to_string(index) + " of a scene of " +
                                        counted(scene.materials.size(), "material"));
    MIRRORBALL_TRY_VOID(setParameters(given, scene.materials[index]));
  }
  return {};
}

Result<Workspace> withOption(Workspace workspace, OptionTable table, std::string_view name, std::string_view text) {
  if (table == OptionTable::parameter) return withParameter(std::move(workspace), name, text);
  if (table == OptionTable::material) return withMaterialOption(std::move(workspace), name, text);
  MIRRORBALL_TRY_VOID(give<FrameSettings>(frameOptions(), name, text, editedFrame(workspace, name)));
  // A repeated one may be one too many.
  for (std::size_t side = 0; side < workspace.sides.size(); ++side) {
    const auto settings = frameOf(workspace, side);
    if (!settings) return tl::unexpected<Error>(settings.error());
  }
  return workspace;
}

Workspace withoutOption(Workspace workspace, OptionTable table, std::string_view name) {
  if (table == OptionTable::frame) {
    erase(editedFrame(workspace, name), name);
  } else if (table == OptionTable::material) {
    erase(workspace.materials, name);
  } else if (workspace.selected_material) {
    const auto of_material = workspace.parameters.find(*workspace.selected_material);
    if (of_material == workspace.parameters.end()) return workspace;
    erase(of_material->second, name);
    if (of_material->second.empty()) workspace.parameters.erase(of_material);
  }
  return workspace;
}

Workspace withMapStepped(Workspace workspace, int by) {
  const auto count = static_cast<std::ptrdiff_t>(workspace.maps.size());
  const std::ptrdiff_t next = (static_cast<std::ptrdiff_t>(workspace.shown_map) + by) % count;
  workspace.shown_map = static_cast<std::size_t>(next < 0 ? next + count : next);
  return workspace;
}

Workspace withMap(Workspace workspace, std::string name) {
  const auto found = std::find(workspace.maps.begin(), workspace.maps.end(), name);
  workspace.shown_map = static_cast<std::size_t>(found - workspace.maps.begin());
  if (found == workspace.maps.end()) workspace.maps.push_back(std::move(name));
  return workspace;
}

namespace {

/// Gives an option the text that it has in some settings; what is so without it is no text.
///
/// beneath   what there is without it
void giveAs(const FrameSettings& settings, std::string_view name, const FrameSettings& beneath, GivenTexts& given) {
  const Option<FrameSettings>* option = optionNamed(frameOptions(), name);
  std::string text = option ? written(*option, settings) : std::string();
  if (!option || text == written(*option, beneath))
    erase(given, name);
  else
    given[std::string(name)] = {std::move(text)};
}

}  // namespace

Workspace withCamera(Workspace workspace, const CameraOptions& camera) {
  FrameSettings settings;
  settings.camera = camera;
  for (const std::string_view name : {"camera", "target", "fov", "orthographic"})
    giveAs(settings, name, FrameSettings(), workspace.frame);
  return workspace;
}

Workspace withLightTurned(Workspace workspace, glm::vec3 env_rotation_deg) {
  FrameSettings settings;
  settings.env_rotation_deg = env_rotation_deg;
  constexpr std::string_view kName = "env-rotation";
  GivenTexts& given = editedFrame(workspace, kName);
  const auto of_both = frameOf(workspace.frame);
  giveAs(settings, kName, &given == &workspace.frame || !of_both ? FrameSettings() : *of_both, given);
  return workspace;
}

}  // namespace mirrorball
