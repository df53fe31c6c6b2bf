#include "mirrorball/view/panel/panel.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

/// The values of a table's options: as they are, and what they are where nobody has given them.
template <typename Target>
struct Values {
  Target now;
  Target otherwise;
  const GivenTexts& given;
};

template <typename Target>
PanelRow rowOf(const Option<Target>& option, OptionTable table, const Values<Target>& values) {
  const OptionText& text = option.text;
  PanelRow row{.table = table,
               .name = text.name,
               .unit = text.unit,
               .help = filledIn(text.help, [](std::string_view name) { return std::string(name); }),
               .control = controlOf(option),
               .choices = text.choices.empty() ? std::vector<std::string_view>() : choicesOf(text),
               .value = valueOf(option, values.now),
               .default_value = valueOf(option, values.otherwise),
               .text = written(option, values.now),
               .may_repeat = option.mayRepeat(),
               .is_given = values.given.contains(text.name),
               .is_daily = text.is_daily};
  if (text.names) row.names.assign(text.names().begin(), text.names().end());
  if (const auto found = values.given.find(text.name); row.may_repeat && found != values.given.end())
    row.texts = found->second;
  return row;
}

/// The heading of an option, which parameters of materials have not in their table; those of a photograph belong
/// together.
std::string_view titleOf(OptionTable table, const OptionText& text) {
  if (table == OptionTable::photo) return "Photograph of a mirror ball";
  return table == OptionTable::parameter ? "Selected material" : text.group;
}

void addRow(PanelRow row, std::string_view title, std::vector<PanelGroup>& groups) {
  auto group = std::find_if(groups.begin(), groups.end(), [&](const PanelGroup& each) { return each.title == title; });
  if (group == groups.end()) group = groups.insert(groups.end(), {title, {}});
  group->rows.push_back(std::move(row));
}

/// The text of a value, as the row's option writes it; empty: of no value.
template <typename Target, typename Table>
Result<std::string> textOf(Table options, std::string_view name, const ControlValue& value) {
  for (const Option<Target>& option : options) {
    if (option.text.name != name) continue;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const auto* numbers = std::get_if<std::vector<float>>(&value);
    if (numbers && numbers->empty()) return std::string();
    Target target;
    MIRRORBALL_TRY_VOID(setValue(option, target, value));
    return numbers ? detail::textOf(option.text, *numbers) : written(option, target);
  }
  return fail(ErrorCode::usage, "there is no option '" + excerpt(name) + "'");
}

/// The text of a row's value.
Result<std::string> textOf(const PanelRow& row, const ControlValue& value) {
  switch (row.table) {
    case OptionTable::stance:
      return textOf<ModelStance>(stanceOptions(), row.name, value);
    case OptionTable::frame:
      return row.name == qualityOptions().front().text.name ? textOf<QualityRequest>(qualityOptions(), row.name, value)
                                                            : textOf<FrameSettings>(frameOptions(), row.name, value);
    case OptionTable::material:
      return textOf<MaterialChanges>(materialOptions(), row.name, value);
    case OptionTable::parameter:
      return textOf<Material>(materialParameters(), row.name, value);
    case OptionTable::map_view:
      return textOf<MapViewSettings>(mapViewOptions(), row.name, value);
    case OptionTable::photo:
      break;
  }
  return textOf<BallPhotoSettings>(ballPhotoOptions(), row.name, value);
}

/// What there is to be set of a photograph, behind all else. Exposure times are of a series.
Result<void> addPhotoRows(const Workspace& workspace, std::vector<PanelGroup>& groups) {
  const AskedMap map = askedMap(workspace, editedSide(workspace));
  if (!map.photo) return {};
  MIRRORBALL_TRY(settings, ballPhotoOf(*map.photo));
  const Values<BallPhotoSettings> values{std::move(settings), {}, *map.photo};
  for (const auto& option : ballPhotoOptions())
    if (option.text.name != "exposures")
      addRow(rowOf(option, OptionTable::photo, values), titleOf(OptionTable::photo, option.text), groups);
  return {};
}

/// What there is to be set while the map is looked at.
Result<std::vector<PanelGroup>> mapPanelsOf(const Workspace& workspace) {
  MIRRORBALL_TRY(settings, mapViewOf(workspace));
  std::vector<PanelGroup> groups;
  for (const auto& option : mapViewOptions())
    addRow(rowOf(option, OptionTable::map_view, Values<MapViewSettings>{settings, {}, workspace.map_view}),
           option.text.group, groups);
  MIRRORBALL_TRY_VOID(addPhotoRows(workspace, groups));
  return groups;
}

}  // namespace

Result<std::vector<PanelGroup>> panelsOf(const Workspace& workspace, const Material* selected) {
  if (workspace.shows_map) return mapPanelsOf(workspace);
  const std::size_t side = editedSide(workspace);
  const bool is_comparing = workspace.compare_by != CompareBy::none;
  MIRRORBALL_TRY(frame, frameOf(workspace, side));
  MIRRORBALL_TRY(of_both, frameOf(workspace.frame));
  MIRRORBALL_TRY(stance, stanceOf(workspace.stance));
  MIRRORBALL_TRY(materials, materialsOf(workspace.materials));
  const Values<FrameSettings> shared{frame, FrameSettings(), workspace.frame};
  const Values<FrameSettings> of_half{frame, of_both, workspace.sides[side].frame};
  std::vector<PanelGroup> groups;
  for (const auto& option : stanceOptions())
    addRow(rowOf(option, OptionTable::stance, Values<ModelStance>{stance, {}, workspace.stance}), option.text.group,
           groups);
  for (const auto& option : frameOptions())
    addRow(rowOf(option, OptionTable::frame, is_comparing && !isShared(option.text.name) ? of_half : shared),
           option.text.group, groups);
  const auto wish = [](const GivenTexts& given) -> Result<QualityRequest> {
    MIRRORBALL_TRY(quality, qualityOf(given));
    return QualityRequest{quality};
  };
  MIRRORBALL_TRY(wished, wish(givenFrame(workspace, side)));
  MIRRORBALL_TRY(wished_of_both, wish(workspace.frame));
  const Values<QualityRequest> of_wish{wished, is_comparing ? wished_of_both : QualityRequest(),
                                       is_comparing ? workspace.sides[side].frame : workspace.frame};
  for (const auto& option : qualityOptions())
    addRow(rowOf(option, OptionTable::frame, of_wish), option.text.group, groups);
  const Values<MaterialChanges> of_model{materials, MaterialChanges(), workspace.materials};
  for (const auto& option : materialOptions())
    addRow(rowOf(option, OptionTable::material, of_model), option.text.group, groups);
  MIRRORBALL_TRY_VOID(addPhotoRows(workspace, groups));
  if (!selected || !workspace.selected_material) return groups;
  const auto found = workspace.parameters.find(*workspace.selected_material);
  const GivenTexts given = found == workspace.parameters.end() ? GivenTexts() : found->second;
  Material changed = *selected;
  MIRRORBALL_TRY_VOID(setParameters(given, changed));
  const Values<Material> of_material{std::move(changed), *selected, given};
  for (const Option<Material>& parameter : materialParameters())
    addRow(rowOf(parameter, OptionTable::parameter, of_material), titleOf(OptionTable::parameter, parameter.text),
           groups);
  return groups;
}

Result<Workspace> withValue(const Workspace& workspace, const PanelRow& row, const ControlValue& value) {
  const auto text = textOf(row, value);
  if (!text) return tl::unexpected<Error>(text.error());
  if (text->empty()) return row.may_repeat ? workspace : withoutOption(workspace, row.table, row.name);
  return withOption(workspace, row.table, row.name, *text);
}

Workspace withoutGroup(Workspace workspace, std::string_view title) {
  const auto leave = [&](auto options, OptionTable table) {
    for (const auto& option : options)
      if (titleOf(table, option.text) == title)
        workspace = withoutOption(std::move(workspace), table, option.text.name);
  };
  leave(stanceOptions(), OptionTable::stance);
  leave(frameOptions(), OptionTable::frame);
  leave(qualityOptions(), OptionTable::frame);
  leave(materialOptions(), OptionTable::material);
  leave(materialParameters(), OptionTable::parameter);
  leave(mapViewOptions(), OptionTable::map_view);
  leave(ballPhotoOptions(), OptionTable::photo);
  return workspace;
}

}  // namespace mirrorball
