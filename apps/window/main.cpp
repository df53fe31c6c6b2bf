// A window on a viewer (src/mirrorball/view): it forwards what hands do, and shows pictures and panels. What any of it
// means is the viewer's.

#include <cstdio>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/view/viewer/viewer.h"
#include "mirrorball/view/workspace/view_request.h"
#include "window/desk.h"
#include "window/window_events.h"

using namespace mirrorball;

namespace {

constexpr const char* kTitle = "Mirrorball";
constexpr const char* kBusyTitle = "Mirrorball (working)";

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
  return glfwCreateWindow(1620, 740, kBusyTitle, nullptr, nullptr);
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

/// Says in the title, which a list of windows shows too, whether there is something going on.
class Title {
 public:
  explicit Title(GLFWwindow* window) : window_(window) {}
  void tell(bool is_done) {
    if (std::exchange(was_done_, is_done) != is_done) glfwSetWindowTitle(window_, is_done ? kTitle : kBusyTitle);
  }

 private:
  GLFWwindow* window_;
  bool was_done_ = false;
};

Result<void> run(GLFWwindow* window, Viewer& viewer, window::WindowEvents& events, window::Desk& desk) {
  Title title(window);
  double before_s = glfwGetTime();
  while (!glfwWindowShouldClose(window)) {
    waitForEvents(viewer);
    desk.followMonitor();
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window, &size.x, &size.y);
    const int strip_px = desk.stripHeight(viewer);
    const glm::ivec2 picture_px =
        glm::max(size - glm::ivec2(desk.panelWidth(), desk.menuHeight() + strip_px), glm::ivec2(1));
    viewer.handle(Resized{picture_px});
    for (const Event& event : events.take(glm::vec2(0, desk.menuHeight()))) {
      const auto* pressed = std::get_if<KeyPressed>(&event);
      if (!pressed || !desk.handle(viewer, *pressed)) viewer.handle(event);
    }
    desk.open(viewer, events.takeDropped());
    const double now_s = glfwGetTime();
    MIRRORBALL_TRY_VOID(viewer.advance(now_s - std::exchange(before_s, now_s)));
    if (viewer.hasPicture()) MIRRORBALL_TRY_VOID(viewer.show(0, {0, strip_px}, picture_px));
    MIRRORBALL_TRY_VOID(viewer.leave());
    desk.draw(viewer, picture_px);
    glfwSwapBuffers(window);
    title.tell(viewer.isDone());
  }
  return {};
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  auto request = viewRequestOf(arguments);
  if (!request) return failed(request.error().message);
  if (request->wants_help) {
    std::fputs(viewHelp().c_str(), stdout);
    return 0;
  }
  glfwSetErrorCallback([](int, const char*) {});
  if (!glfwInit()) return failed("there is no display for a window; `mirrorball render` makes pictures without one");
  const Closing closing;
  GLFWwindow* window = openWindow();
  if (!window) return failed("the display has no OpenGL 4.3; `mirrorball render` makes pictures without one");
  glfwMakeContextCurrent(window);
  glfwSwapInterval(request->window.waits_for_screen ? 1 : 0);
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
  Viewer viewer(*device, std::move(request->workspace), {1280, 720},
                {.frame_s = 1e-3 * static_cast<double>(request->window.frame_ms),
                 .cache = cache ? std::move(*cache) : std::optional<CacheFolder>()});
  window::Desk desk(window, request->window);
  const auto ended = run(window, viewer, events, desk);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  return ended ? 0 : failed(ended.error().message);
}
