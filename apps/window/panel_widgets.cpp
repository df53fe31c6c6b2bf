#include "window/panel_widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "mirrorball/base/range.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/panel/panel.h"

namespace mirrorball::window {
namespace {

constexpr const char* kNumberFormat = "%.5g";

/// A slider where both ends are known, else a field to drag in.
bool numberWidget(const PanelRow& row, std::vector<float>& numbers) {
  const OptionControl& control = row.control;
  const auto low = static_cast<float>(control.minimum);
  const auto high = static_cast<float>(control.maximum);
  const int count = static_cast<int>(numbers.size());
  if (control.kind == ControlKind::color && count == 3)
    return ImGui::ColorEdit3("##value", numbers.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
  if (count == 1 && std::isfinite(low) && std::isfinite(high))
    return ImGui::SliderFloat("##value", numbers.data(), low, high, kNumberFormat);
  const float speed = control.step > 0.0 ? static_cast<float>(control.step) : 0.01f;
  return ImGui::DragScalarN("##value", ImGuiDataType_Float, numbers.data(), count, speed, nullptr, nullptr,
                            kNumberFormat);
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
    // What is not given is written, and then dragged; a matrix has no place for a field of each number.
    constexpr std::size_t kMostFields = 4;
    if (numbers->empty() || numbers->size() > kMostFields) {
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

/// Scrolls the window to what was drawn last, if another is now the one of this number.
void scrollToOnce(int number) {
  int& before = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("scrolled to"), -1);
  if (std::exchange(before, number) != number) ImGui::SetScrollHereX();
}

}  // namespace

void drawPanels(Viewer& viewer, std::string& search, bool is_wanted) {
  const auto groups = panelsOf(viewer.workspace(), viewer.selectedMaterial());
  if (!groups) return ImGui::TextWrapped("%s", groups.error().message.c_str());
  if (is_wanted) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "find an option", &search);
  if (!search.empty()) {
    for (const FoundRow& found : searchRows(*groups, search)) drawRow(viewer, (*groups)[found.group].rows[found.row]);
    return;
  }
  for (const PanelGroup& group : *groups) {
    const std::string title(group.title);
    // What was given is seen at once.
    const bool has_given = std::any_of(group.rows.begin(), group.rows.end(), [](auto& row) { return row.is_given; });
    if (!ImGui::CollapsingHeader(title.c_str(), has_given ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None))
      continue;
    for (const PanelRow& row : group.rows) drawRow(viewer, row);
    if (ImGui::Button(("Reset " + title).c_str()))
      viewer.history().change("Reset " + title, withoutGroup(viewer.workspace(), group.title));
  }
}

namespace {

ImU32 colorOf(glm::vec3 color) { return ImGui::GetColorU32({color.x, color.y, color.z, 1.0f}); }
ImVec2 placeOf(glm::vec2 place) { return {place.x, place.y}; }

/// How many times as large as usual all is drawn: the letters say.
float drawnScale() {
  constexpr float kUsualLetters = 13.0f;
  return ImGui::GetFontSize() / kUsualLetters;
}

void drawLines(ImDrawList& list, const std::vector<DrawnLine>& lines, glm::vec2 corner, glm::vec2 scale) {
  for (const DrawnLine& line : lines)
    for (std::size_t i = 1; i < line.places.size(); ++i)
      list.AddLine(placeOf(corner + scale * line.places[i - 1]), placeOf(corner + scale * line.places[i]),
                   colorOf(line.color), 1.5f * drawnScale());
}

void drawDot(ImDrawList& list, glm::vec2 place, glm::vec3 color) {
  const float radius = 4.0f * drawnScale();
  list.AddCircleFilled(placeOf(place), radius, colorOf(color));
  list.AddCircle(placeOf(place), radius + 1.0f, colorOf(glm::vec3(0.0f)));
}

void drawPlot(const DrawnPlot& plot) {
  const float height = 100.0f * drawnScale();
  ImGui::TextWrapped("%s", plot.title.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const glm::vec2 size(ImGui::GetContentRegionAvail().x, height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_Border));
  drawLines(list, plot.lines, {corner.x, corner.y}, size);
  if (plot.dot) drawDot(list, glm::vec2(corner.x, corner.y) + *plot.dot * size, glm::vec3(1.0f));
  ImGui::Dummy({size.x, size.y});
}

void drawMarkedPicture(const MarkedPicture& picture) {
  ImGui::TextUnformatted(picture.title.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const glm::vec2 scale(drawnScale());
  ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(picture.texture)),
               placeOf(scale * glm::vec2(picture.size_px)), {0, 1}, {1, 0});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawLines(list, picture.lines, {corner.x, corner.y}, scale);
  for (const DrawnLine& dot : picture.dots)
    for (const glm::vec2 place : dot.places) drawDot(list, glm::vec2(corner.x, corner.y) + scale * place, dot.color);
}

/// A text in lines as wide as there is place. Dear ImGui's own may end a line within a number, after its point.
void drawWords(const std::string& text) {
  const float width = ImGui::GetContentRegionAvail().x;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
      ImGui::TextUnformatted(line.c_str());
      line = word;
    } else {
      line = longer;
    }
  }
  ImGui::TextUnformatted(line.c_str());
}

}  // namespace

void drawUnderPointer(const UnderPointer& under) {
  if (under.rows.empty() && under.maps.empty()) return;
  if (!ImGui::CollapsingHeader("Under the pointer", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const MarkedPicture& picture : under.maps) drawMarkedPicture(picture);
  for (const DrawnPlot& plot : under.plots) drawPlot(plot);
  if (!ImGui::BeginTable("rows", 2, ImGuiTableFlags_SizingStretchProp)) return;
  for (const InspectionRow& row : under.rows) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.name.c_str());
    ImGui::TableNextColumn();
    drawWords(row.value + " " + row.unit);
  }
  ImGui::EndTable();
}

void drawOverPicture(const UnderPointer& under, glm::vec2 corner) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  drawLines(list, under.lines, corner, glm::vec2(1.0f));
  for (const DrawnText& text : under.texts)
    list.AddText(placeOf(corner + text.corner), colorOf(glm::vec3(0.9f)), text.text.c_str());
}

void drawThumbnails(Viewer& viewer, float scale) {
  constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_HorizontalScrollbar |
                                      ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("panoramas", nullptr, kPlain);
  const std::vector<MapThumbnail> thumbnails = viewer.thumbnails();
  for (std::size_t i = 0; i < thumbnails.size(); ++i) {
    const MapThumbnail& each = thumbnails[i];
    ImGui::PushID(static_cast<int>(i));
    if (i > 0) ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(each.is_shown ? ImGuiCol_HeaderActive : ImGuiCol_Button));
    constexpr int kFrame_px = 3;
    const ImVec2 size(96.0f * scale, 48.0f * scale);
    // As large, so that nothing moves when the picture is there.
    const ImVec2 framed(size.x + 2.0f * kFrame_px, size.y + 2.0f * kFrame_px);
    const bool is_chosen =
        each.texture == 0 ? ImGui::Button("...", framed)
                          : ImGui::ImageButton(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(each.texture)),
                                               size, {0, 1}, {1, 0}, kFrame_px);
    if (is_chosen) viewer.history().change("Another panorama", withMapShown(viewer.workspace(), i));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", each.name.c_str());
    ImGui::PopStyleColor();
    ImGui::PopID();
    if (each.is_shown) scrollToOnce(static_cast<int>(i));
  }
  ImGui::End();
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
