// A window on a viewer (src/mirrorball/view): it forwards what hands do, and shows pictures and panels. What any of it
// means is the viewer's.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "mirrorball/mirrorball.h"
#include "window/panel_widgets.h"
#include "window/window_events.h"

using namespace mirrorball;

namespace {

constexpr int kPanelWidth = 340;

/// What must end in this order.
struct Closing {
  ~Closing() { glfwTerminate(); }
};

int failed(const std::string& message) {
  std::fprintf(stderr, "mirrorball: %s\n", message.c_str());
  return 1;
}

GLFWwindow* openWindow() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  return glfwCreateWindow(1280 + kPanelWidth, 720, "Mirrorball", nullptr, nullptr);
}

/// A word as a shell reads it.
std::string quotedForShell(const std::string& word) {
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// What is drawn between two pictures: menus, panels, status.
class Desk {
 public:
  explicit Desk(GLFWwindow* window) : window_(window) {}

  void draw(Viewer& viewer) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    drawMenus(viewer);
    const ImGuiViewport* whole = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({whole->WorkPos.x + whole->WorkSize.x - kPanelWidth, whole->WorkPos.y});
    ImGui::SetNextWindowSize({float(kPanelWidth), whole->WorkSize.y});
    ImGui::Begin("Options", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse);
    drawStatus(viewer);
    window::drawPanels(viewer, search_);
    ImGui::End();
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  }

  void tell(std::string line) { told_ = std::move(line); }

 private:
  void drawMenus(Viewer& viewer) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (ImGui::BeginMenu("File")) {
      if (ImGui::MenuItem("Copy as a command line")) copyCommandLine(viewer);
      if (ImGui::MenuItem("Quit")) glfwSetWindowShouldClose(window_, GLFW_TRUE);
      ImGui::EndMenu();
    }
    window::drawCommandMenus(viewer);
    ImGui::EndMainMenuBar();
  }

  void copyCommandLine(const Viewer& viewer) {
    const auto words = renderArguments(viewer.workspace(), 0);
    if (!words) return tell(words.error().message);
    std::string line = "mirrorball render";
    for (const std::string& word : *words) line += " " + quotedForShell(word);
    glfwSetClipboardString(window_, line.c_str());
    tell("copied");
  }

  static void drawSide(const SideStatus& side) {
    const glm::ivec2 size = side.size_px;
    if (side.is_traced)
      ImGui::Text("%d x %d, %d of %d paths, noise %.2g", size.x, size.y, side.samples, side.wanted_samples, side.noise);
    else
      ImGui::Text("%d x %d, %d of %d samples, %.0f ms", size.x, size.y, side.samples, side.wanted_samples,
                  1e3 * side.sample_s);
    if (side.light.reads > 0)
      ImGui::Text("light: %d look-ups, %.1f MiB", side.light.reads,
                  static_cast<double>(side.light.texture_bytes) / 1048576.0);
  }

  void drawStatus(const Viewer& viewer) const {
    const ViewerStatus status = viewer.status();
    for (const SideStatus& side : status.sides) drawSide(side);
    for (const ErrorText& error : status.errors) ImGui::Text("%s %s", error.label.c_str(), error.value.c_str());
    if (!status.loading.empty())
      ImGui::ProgressBar(static_cast<float>(status.loaded), {-1, 0}, ("loading " + status.loading).c_str());
    const std::string& line = status.problem.empty() ? told_ : status.problem;
    if (!line.empty()) ImGui::TextWrapped("%s", line.c_str());
    ImGui::Separator();
  }

  GLFWwindow* window_;
  std::string search_;
  std::string told_;
};

void openFiles(Viewer& viewer, const std::vector<std::string>& paths, Desk& desk) {
  for (const std::string& path : paths) {
    auto opened = withFile(viewer.workspace(), path);
    if (opened)
      viewer.history().change("Open " + path, std::move(*opened));
    else
      desk.tell(opened.error().message);
  }
}

/// Sleeps until there is something to do.
void waitForEvents(const Viewer& viewer) {
  if (viewer.isDone())
    glfwWaitEventsTimeout(0.25);
  else if (viewer.isWaiting())
    glfwWaitEventsTimeout(0.01);
  else
    glfwPollEvents();
}

Result<void> run(GLFWwindow* window, Viewer& viewer, window::WindowEvents& events, Desk& desk) {
  double before_s = glfwGetTime();
  while (!glfwWindowShouldClose(window)) {
    waitForEvents(viewer);
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window, &size.x, &size.y);
    const int menu_height = static_cast<int>(ImGui::GetFrameHeight());
    const glm::ivec2 picture_size(std::max(size.x - kPanelWidth, 1), std::max(size.y - menu_height, 1));
    viewer.handle(Resized{picture_size});
    for (const Event& event : events.take(glm::vec2(0, menu_height))) viewer.handle(event);
    openFiles(viewer, events.takeDropped(), desk);
    const double now_s = glfwGetTime();
    MIRRORBALL_TRY_VOID(viewer.advance(now_s - std::exchange(before_s, now_s)));
    if (viewer.hasPicture()) MIRRORBALL_TRY_VOID(viewer.show(0, {0, 0}, picture_size));
    MIRRORBALL_TRY_VOID(viewer.leave());
    desk.draw(viewer);
    glfwSwapBuffers(window);
  }
  return {};
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  auto workspace = workspaceOf(arguments);
  if (!workspace) return failed(workspace.error().message);
  glfwSetErrorCallback([](int, const char*) {});
  if (!glfwInit()) return failed("there is no display for a window; `mirrorball render` makes pictures without one");
  const Closing closing;
  GLFWwindow* window = openWindow();
  if (!window) return failed("the display has no OpenGL 4.3; `mirrorball render` makes pictures without one");
  glfwMakeContextCurrent(window);
  auto context = gl::Context::adoptCurrent();
  if (!context) return failed(context.error().message);
  auto device = Device::on(std::move(*context));
  if (!device) return failed(device.error().message);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  window::WindowEvents events(window);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 430 core");
  auto cache = CacheFolder::ofUser();
  Viewer viewer(*device, std::move(*workspace), {1280, 720},
                {.cache = cache ? std::move(*cache) : std::optional<CacheFolder>()});
  Desk desk(window);
  const auto ended = run(window, viewer, events, desk);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  return ended ? 0 : failed(ended.error().message);
}
