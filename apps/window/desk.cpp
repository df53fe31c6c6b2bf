#include "window/desk.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/control/gesture.h"
#include "mirrorball/view/workspace/arguments.h"
#include "mirrorball/view/workspace/workspace_file.h"
#include "window/panel_widgets.h"

namespace mirrorball::window {
namespace {

constexpr float kPanelWidth = 340.0f;
constexpr float kLetterHeight = 13.0f;
constexpr float kStripHeight = 76.0f;

void drawLine(const std::string& text) { ImGui::TextWrapped("%s", text.c_str()); }

void drawTwoColumns(std::string_view left, std::string_view right) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(left.data(), left.data() + left.size());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(right.data(), right.data() + right.size());
}

void drawKeys() {
  if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const GestureText& text : gestureTexts()) drawTwoColumns(text.hand, text.does);
  for (const ViewerCommand& command : viewerCommands())
    drawTwoColumns(std::string(command.key) + (command.other_key.empty() ? "" : ", ") + std::string(command.other_key),
                   command.title);
  for (const auto& [key, does] : std::to_array<std::pair<const char*, const char*>>({{"Ctrl+O", "Open"},
                                                                                     {"Ctrl+S", "Save the workspace"},
                                                                                     {"Ctrl+P", "Save a picture"},
                                                                                     {"Ctrl+K", "Find an option"},
                                                                                     {"?, F1", "This page"}}))
    drawTwoColumns(key, does);
  ImGui::EndTable();
}

}  // namespace

Desk::Desk(GLFWwindow* window, const WindowOptions& options)
    : window_(window), recent_(RecentFiles::ofUser()), theme_(options.theme), search_(options.find) {
  followMonitor();
}

void Desk::useTheme(Theme theme) {
  theme_ = theme;
  ImGui::GetStyle() = ImGuiStyle();
  if (theme == Theme::light)
    ImGui::StyleColorsLight();
  else
    ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  if (theme == Theme::light) style.FrameBorderSize = 1.0f;  // else fields are white on white
  for (const ImGuiCol background : {ImGuiCol_WindowBg, ImGuiCol_PopupBg}) style.Colors[background].w = 1.0f;
  style.ScaleAllSizes(scale_);
}

void Desk::followMonitor() {
  float scale = 1.0f, other = 1.0f;
  glfwGetWindowContentScale(window_, &scale, &other);
  if (scale == scale_ || !(scale > 0.0f)) return;
  scale_ = scale;
  useTheme(theme_);
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  ImFontConfig config;
  config.SizePixels = kLetterHeight * scale;
  fonts.AddFontDefault(&config);
  ImGui_ImplOpenGL3_DestroyFontsTexture();  // it is made again with the next frame
}

glm::ivec2 Desk::spaceBesidePicture(float scale, bool has_strip) {
  const float padding = std::floor(ImGuiStyle().FramePadding.y * scale);  // as the style rounds it
  return {static_cast<int>(kPanelWidth * scale), static_cast<int>(kLetterHeight * scale + 2.0f * padding) +
                                                     (has_strip ? static_cast<int>(kStripHeight * scale) : 0)};
}

int Desk::stripHeight(const Viewer& viewer) const {
  return hasSeveralMaps(viewer.workspace()) ? static_cast<int>(kStripHeight * scale_) : 0;
}

void Desk::open(Viewer& viewer, const std::vector<std::string>& paths) {
  for (const std::string& path : filesToOpen(paths)) {
    auto opened = withFile(viewer.workspace(), path);
    if (!opened) {
      told_ = opened.error().message;
      continue;
    }
    viewer.history().change("Open " + path, std::move(*opened));
    if (recent_) recent_->note(path);
  }
}

bool Desk::handle(Viewer& viewer, const KeyPressed& pressed) {
  const std::string chord = chordOf(pressed);
  const auto begin = [&](Dialog dialog) {
    dialog_ = dialog;
    dialog_begins_ = true;
    return true;
  };
  if (chord == "Ctrl+O") return begin(Dialog::open);
  if (chord == "Ctrl+S") return begin(Dialog::save_workspace);
  if (chord == "Ctrl+P") return begin(Dialog::save_picture);
  if (chord == "F1" || chord == "?" || chord == "Shift+?" || chord == "Shift+/") return begin(Dialog::keys);
  if (chord == "Ctrl+K") return wants_search_ = true;
  if (chord != "Escape" || viewer.status().saving.empty()) return false;
  viewer.cancelSaving();
  return true;
}

void Desk::draw(Viewer& viewer, glm::ivec2 picture_px) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  drawMenus(viewer);
  const UnderPointer under = viewer.underPointer();
  drawOverPicture(under, {0.0f, static_cast<float>(menuHeight())});
  if (const int height = stripHeight(viewer)) {
    ImGui::SetNextWindowPos({0.0f, static_cast<float>(menuHeight() + picture_px.y)});
    ImGui::SetNextWindowSize({static_cast<float>(picture_px.x), static_cast<float>(height)});
    drawThumbnails(viewer, scale_);
  }
  const ImGuiViewport* whole = ImGui::GetMainViewport();
  const auto width = static_cast<float>(panelWidth());
  ImGui::SetNextWindowPos({whole->WorkPos.x + whole->WorkSize.x - width, whole->WorkPos.y});
  ImGui::SetNextWindowSize({width, whole->WorkSize.y});
  ImGui::Begin("Options", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse);
  drawStatus(viewer);
  drawUnderPointer(under);
  // In a comparison Tab leads to the other half, else from field to field.
  ImGui::PushAllowKeyboardFocus(viewer.workspace().compare_by == CompareBy::none);
  drawPanels(viewer, search_, std::exchange(wants_search_, false));
  ImGui::PopAllowKeyboardFocus();
  ImGui::End();
  drawDialog(viewer, picture_px);  // last: Dear ImGui lets no window appear behind one
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Desk::drawMenus(Viewer& viewer) {
  if (!ImGui::BeginMainMenuBar()) return;
  drawFileMenu(viewer);
  drawCommandMenus(viewer);
  if (ImGui::BeginMenu("Window")) {
    if (ImGui::MenuItem("Dark", nullptr, theme_ == Theme::dark)) useTheme(Theme::dark);
    if (ImGui::MenuItem("Light", nullptr, theme_ == Theme::light)) useTheme(Theme::light);
    if (ImGui::MenuItem("Hands and keys", "?")) handle(viewer, {"?"});
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
}

void Desk::drawFileMenu(Viewer& viewer) {
  if (!ImGui::BeginMenu("File")) return;
  if (ImGui::MenuItem("Open", "Ctrl+O")) handle(viewer, {"O", {.control = true}});
  if (recent_ && ImGui::BeginMenu("Open again")) {
    for (const std::string& path : recent_->list())
      if (ImGui::MenuItem(path.c_str())) open(viewer, {path});
    ImGui::EndMenu();
  }
  if (ImGui::MenuItem("Save the workspace", "Ctrl+S")) handle(viewer, {"S", {.control = true}});
  if (ImGui::MenuItem("Save a picture", "Ctrl+P")) handle(viewer, {"P", {.control = true}});
  if (ImGui::MenuItem("Copy as a command line")) copyCommandLine(viewer);
  if (ImGui::MenuItem("Quit")) glfwSetWindowShouldClose(window_, GLFW_TRUE);
  ImGui::EndMenu();
}

void Desk::drawDialog(Viewer& viewer, glm::ivec2 picture_px) {
  constexpr std::array<const char*, 5> kTitles{"", "Open", "Save the workspace", "Save a picture", "Hands and keys"};
  const char* const title = kTitles[static_cast<std::size_t>(dialog_)];
  if (dialog_ == Dialog::none) return;
  const bool begins = std::exchange(dialog_begins_, false);
  if (begins) {
    ImGui::OpenPopup(title);
    if (dialog_ == Dialog::save_picture) saved_px_ = picture_px;
  }
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    dialog_ = Dialog::none;
    return;
  }
  bool is_accepted = false;
  if (dialog_ == Dialog::keys) {
    drawKeys();
  } else {
    if (begins) ImGui::SetKeyboardFocusHere();
    is_accepted = ImGui::InputText("file", &path(), ImGuiInputTextFlags_EnterReturnsTrue);
    if (dialog_ == Dialog::save_picture) drawSizeFields(picture_px, viewer.status().animation.shown.has_value());
    is_accepted = ImGui::Button("OK") || is_accepted;
    ImGui::SameLine();
  }
  if (is_accepted) accept(viewer);
  const bool is_left = ImGui::Button("Close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (is_accepted || is_left) {
    ImGui::CloseCurrentPopup();
    dialog_ = Dialog::none;
  }
  ImGui::EndPopup();
}

void Desk::drawSizeFields(glm::ivec2 picture_px, bool has_animation) {
  ImGui::InputInt2("size in pixels", &saved_px_.x);
  ImGui::SameLine();
  if (ImGui::SmallButton("as seen")) saved_px_ = picture_px;
  saved_px_ = glm::clamp(saved_px_, glm::ivec2(1), glm::ivec2(16384));
  ImGui::InputInt("pictures of a turn, 0: one picture", &frames_);
  frames_ = glm::clamp(frames_, 0, 10000);
  if (has_animation) ImGui::Checkbox("of the animation in place of a turn", &plays_);
}

void Desk::accept(Viewer& viewer) {
  told_.clear();
  const std::string file = typedPath(path());
  if (file.empty()) return;
  if (dialog_ == Dialog::open) return open(viewer, {file});
  if (dialog_ == Dialog::save_picture)
    return viewer.savePicture({.path = file,
                               .size_px = saved_px_,
                               .frames = frames_,
                               .plays = plays_,
                               .side = editedSide(viewer.workspace())});
  const auto saved = saveWorkspace(file, viewer.stillWorkspace());
  told_ = saved ? "wrote " + file : saved.error().message;
  if (saved && recent_) recent_->note(file);
}

void Desk::copyCommandLine(const Viewer& viewer) {
  const auto line = renderCommandLine(viewer.renderedWorkspace(), editedSide(viewer.workspace()));
  if (!line) {
    told_ = line.error().message;
    return;
  }
  glfwSetClipboardString(window_, line->c_str());
  told_ = "copied";
}

namespace {

/// "1280 x 720, 4 of 16 samples, 12 ms, GPU 9 ms"
std::string samplesText(const SideStatus& side) {
  std::array<char, 128> text{};
  const int length = std::snprintf(text.data(), text.size(), "%d x %d, %d of %d samples, %.0f ms", side.size_px.x,
                                   side.size_px.y, side.samples, side.wanted_samples, 1e3 * side.sample_s);
  if (side.gpu_s)
    std::snprintf(text.data() + length, text.size() - std::size_t(length), ", GPU %.0f ms", 1e3 * *side.gpu_s);
  return text.data();
}

void drawSide(const SideStatus& side) {
  const glm::ivec2 size = side.size_px;
  if (side.is_traced)
    ImGui::Text("%d x %d, %d of %d paths, noise %.2g", size.x, size.y, side.samples, side.wanted_samples,
                static_cast<double>(side.noise));
  else
    drawLine(samplesText(side));
  if (side.light.reads > 0 && !side.is_traced)
    ImGui::Text("light: %d look-ups, %.1f MiB", side.light.reads,
                static_cast<double>(side.light.texture_bytes) / 1048576.0);
}

/// Which animation is shown, the moment of it, and whether it goes on.
void drawAnimation(Viewer& viewer, const AnimationStatus& animation) {
  if (animation.names.empty()) return;
  const std::string name = animation.shown ? animation.names[*animation.shown] : "at rest";
  History& history = viewer.history();
  if (ImGui::BeginCombo("animation", name.c_str())) {
    for (const std::string& each : animation.names)
      if (ImGui::Selectable(each.c_str(), each == name))
        history.change("Another animation", withMoment(viewer.workspace(), each, 0.0f));
    ImGui::EndCombo();
  }
  float seconds = animation.seconds;
  if (animation.shown &&
      ImGui::SliderFloat("seconds", &seconds, 0.0f, animation.length_s, "%.3f", ImGuiSliderFlags_AlwaysClamp))
    history.change("Another moment", withMoment(viewer.workspace(), name, seconds), true);
  if (ImGui::IsItemDeactivated()) history.endGesture();
  if (ImGui::SmallButton(animation.plays ? "stop" : "play")) commandOfKey("Space")->perform(history);
}

void drawBar(const std::string& what, double share) {
  ImGui::ProgressBar(static_cast<float>(share), {-1, 0}, what.c_str());
}

}  // namespace

void Desk::drawStatus(Viewer& viewer) const {
  const ViewerStatus status = viewer.status();
  const float top = ImGui::GetCursorPosY();
  for (std::size_t i = 0; i < status.sides.size(); ++i) {
    if (status.sides.size() > 1 &&
        ImGui::RadioButton(i == 0 ? "first half" : "second half", editedSide(viewer.workspace()) == i))
      viewer.history().change("Edit the other half", withEditedSide(viewer.workspace(), i));
    if (!viewer.workspace().shows_map) drawSide(status.sides[i]);
  }
  drawAnimation(viewer, status.animation);
  for (const ErrorText& error : status.errors) ImGui::Text("%s %s", error.label.c_str(), error.value.c_str());
  if (!status.loading.empty()) drawBar("loading " + status.loading, status.loaded);
  if (!status.saving.empty()) {
    drawBar("writing " + status.saving, status.saved);
    if (ImGui::SmallButton("stop writing")) viewer.cancelSaving();
  }
  if (!status.saved_last.empty()) drawLine(status.saved_last);
  if (!status.remark.empty()) drawLine(status.remark);
  if (!status.problem.empty()) drawLine(status.problem);
  if (!told_.empty()) drawLine(told_);
  if (ImGui::GetCursorPosY() > top) ImGui::Separator();
}

}  // namespace mirrorball::window
