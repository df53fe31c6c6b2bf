#include "mirrorball/view/panel/panel.h"

#include <algorithm>
#include <utility>

namespace mirrorball {
namespace {

/// Adds the rows of a table to the groups that they name.
///
/// defaults   what they are where nobody has given them
template <typename Table, typename Target>
void addRows(Table options, OptionTable table, const Target& values, const Target& defaults, const GivenTexts& given,
             std::vector<PanelGroup>& groups) {
  for (const Option<Target>& option : options) {
    const OptionText& text = option.text;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& each) { return each.title == text.group; });
    if (group == groups.end()) group = groups.insert(groups.end(), {text.group, {}});
    PanelRow row{.table = table,
                 .name = text.name,
                 .unit = text.unit,
                 .help = filledIn(text.help, [](std::string_view name) { return std::string(name); }),
                 .control = controlOf(option),
                 .choices = text.choices.empty() ? std::vector<std::string_view>() : choicesOf(text),
                 .value = valueOf(option, values),
                 .default_value = valueOf(option, defaults),
                 .is_given = given.contains(text.name),
                 .is_daily = text.is_daily};
    if (text.names) row.names.assign(text.names().begin(), text.names().end());
    group->rows.push_back(std::move(row));
  }
}

/// The text of a value, as the row's option writes it.
template <typename Target, typename Table>
Result<std::string> textOf(Table options, std::string_view name, const ControlValue& value) {
  for (const Option<Target>& option : options) {
    if (option.text.name != name) continue;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    Target target;
    MIRRORBALL_TRY_VOID(setValue(option, target, value));
    return written(option, target);
  }
  return fail(ErrorCode::usage, "there is no option '" + std::string(name) + "'");
}

}  // namespace

Result<std::vector<PanelGroup>> panelsOf(const Workspace& workspace, const Material* selected) {
  MIRRORBALL_TRY(frame, frameOf(workspace, workspace.edited_side));
  MIRRORBALL_TRY(materials, materialsOf(workspace.materials));
  GivenTexts given = workspace.frame;
  for (const auto& [name, texts] : workspace.sides[workspace.edited_side].frame) given[name] = texts;
  std::vector<PanelGroup> groups;
  addRows(frameOptions(), OptionTable::frame, frame, FrameSettings(), given, groups);
  addRows(materialOptions(), OptionTable::material, materials, MaterialChanges(), workspace.materials, groups);
  if (!selected || !workspace.selected_material) return groups;
  const auto of_material = workspace.parameters.find(*workspace.selected_material);
  const GivenTexts parameters = of_material == workspace.parameters.end() ? GivenTexts() : of_material->second;
  Material changed = *selected;
  MIRRORBALL_TRY_VOID(setParameters(parameters, changed));
  addRows(materialParameters(), OptionTable::parameter, changed, *selected, parameters, groups);
  return groups;
}

Result<Workspace> withValue(const Workspace& workspace, const PanelRow& row, const ControlValue& value) {
  const auto text = row.table == OptionTable::frame      ? textOf<FrameSettings>(frameOptions(), row.name, value)
                    : row.table == OptionTable::material ? textOf<MaterialChanges>(materialOptions(), row.name, value)
                                                         : textOf<Material>(materialParameters(), row.name, value);
  if (!text) return tl::unexpected<Error>(text.error());
  if (text->empty()) return withoutOption(workspace, row.table, row.name);
  return withOption(workspace, row.table, row.name, *text);
}

Workspace withoutGroup(Workspace workspace, std::string_view title) {
  const auto leave = [&](auto options, OptionTable table) {
    for (const auto& option : options)
      if (title.empty() || option.text.group == title)
        workspace = withoutOption(std::move(workspace), table, option.text.name);
  };
  leave(frameOptions(), OptionTable::frame);
  leave(materialOptions(), OptionTable::material);
  leave(materialParameters(), OptionTable::parameter);
  return workspace;
}

}  // namespace mirrorball
