#include "window/panel_widgets.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "mirrorball/base/range.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/panel/panel.h"

namespace mirrorball::window {
namespace {

/// A slider where both ends are known, else a field to drag in.
bool numberWidget(const PanelRow& row, std::vector<float>& numbers) {
  const OptionControl& control = row.control;
  const auto low = static_cast<float>(control.minimum);
  const auto high = static_cast<float>(control.maximum);
  const int count = static_cast<int>(numbers.size());
  if (control.kind == ControlKind::color && count == 3)
    return ImGui::ColorEdit3("##value", numbers.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
  if (count == 1 && std::isfinite(low) && std::isfinite(high))
    return ImGui::SliderFloat("##value", numbers.data(), low, high);
  const float speed = control.step > 0.0 ? static_cast<float>(control.step) : 0.01f;
  return ImGui::DragScalarN("##value", ImGuiDataType_Float, numbers.data(), count, speed);
}

bool integerWidget(const PanelRow& row, int& number) {
  const bool has_ends = std::isfinite(row.control.minimum) && std::isfinite(row.control.maximum);
  if (!has_ends) return ImGui::InputInt("##value", &number);
  return ImGui::SliderInt("##value", &number, static_cast<int>(row.control.minimum),
                          static_cast<int>(row.control.maximum));
}

bool choiceWidget(const PanelRow& row, int& choice) {
  const std::string shown(row.choices[static_cast<std::size_t>(choice)]);
  bool is_changed = false;
  if (!ImGui::BeginCombo("##value", shown.c_str())) return false;
  for (std::size_t i = 0; i < row.choices.size(); ++i) {
    if (!ImGui::Selectable(std::string(row.choices[i]).c_str(), static_cast<int>(i) == choice)) continue;
    choice = static_cast<int>(i);
    is_changed = true;
  }
  ImGui::EndCombo();
  return is_changed;
}

bool textWidget(std::string& text) { return ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue); }

/// Draws what sets a row.
///
/// returns  the value that it was set to
std::optional<ControlValue> valueWidget(const PanelRow& row) {
  ControlValue value = row.value;
  bool is_changed = false;
  if (auto* flag = std::get_if<bool>(&value)) {
    is_changed = ImGui::Checkbox("##value", flag);
  } else if (auto* number = std::get_if<int>(&value)) {
    is_changed = row.choices.empty() ? integerWidget(row, *number) : choiceWidget(row, *number);
  } else if (auto* numbers = std::get_if<std::vector<float>>(&value)) {
    if (numbers->empty()) {  // what is not given is written, and then dragged
      std::string text = row.text;
      if (!textWidget(text)) return std::nullopt;
      return text;
    }
    is_changed = numberWidget(row, *numbers);
  } else {
    is_changed = textWidget(std::get<std::string>(value));
  }
  return is_changed ? std::optional(value) : std::nullopt;
}

void drawRow(Viewer& viewer, const PanelRow& row) {
  ImGui::PushID(static_cast<int>(row.table));
  ImGui::PushID(row.name.data(), row.name.data() + row.name.size());
  History& history = viewer.history();
  const std::string name(row.name);
  ImGui::SetNextItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
  if (const auto value = valueWidget(row))
    if (auto changed = withValue(viewer.workspace(), row, *value))
      history.change(name, std::move(*changed), ImGui::IsItemActive());
  if (ImGui::IsItemDeactivated()) history.endGesture();
  ImGui::SameLine();
  ImGui::TextUnformatted(name.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.help.c_str());
  if (row.is_given) {
    ImGui::SameLine();
    if (ImGui::SmallButton("reset"))
      history.change("Reset " + name, withoutOption(viewer.workspace(), row.table, row.name));
  }
  for (std::size_t i = 0; i < row.texts.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::BulletText("%s", row.texts[i].c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("remove"))
      history.change("Remove " + name, withoutText(viewer.workspace(), row.table, row.name, i));
    ImGui::PopID();
  }
  ImGui::PopID();
  ImGui::PopID();
}

}  // namespace

void drawPanels(Viewer& viewer, std::string& search, bool is_wanted) {
  const auto groups = panelsOf(viewer.workspace(), viewer.selectedMaterial());
  if (!groups) return ImGui::TextWrapped("%s", groups.error().message.c_str());
  if (is_wanted) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##search", "find an option", &search);
  if (!search.empty()) {
    for (const FoundRow& found : searchRows(*groups, search)) drawRow(viewer, (*groups)[found.group].rows[found.row]);
    return;
  }
  for (const PanelGroup& group : *groups) {
    const std::string title(group.title);
    if (!ImGui::CollapsingHeader(title.c_str())) continue;
    for (const PanelRow& row : group.rows) drawRow(viewer, row);
    if (ImGui::Button(("Reset " + title).c_str()))
      viewer.history().change("Reset " + title, withoutGroup(viewer.workspace(), group.title));
  }
}

void drawCommandMenus(Viewer& viewer) {
  std::vector<std::string_view> drawn;
  for (const ViewerCommand& first : viewerCommands()) {
    if (contains(drawn, first.group)) continue;
    drawn.push_back(first.group);
    if (!ImGui::BeginMenu(std::string(first.group).c_str())) continue;
    for (const ViewerCommand& command : viewerCommands())
      if (command.group == first.group &&
          ImGui::MenuItem(std::string(command.title).c_str(), std::string(command.key).c_str()))
        command.perform(viewer.history());
    ImGui::EndMenu();
  }
}

}  // namespace mirrorball::window
