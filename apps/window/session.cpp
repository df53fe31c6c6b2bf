#include "window/session.h"

#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/control/event.h"
#include "mirrorball/view/viewer/screenshot.h"

namespace mirrorball::window {
namespace {

constexpr const char* kTitle = "Mirrorball";
constexpr const char* kBusyTitle = "Mirrorball (working)";

/// A window around a picture, not seen yet, whose context is current.
///
/// has_strip   of panoramas below the picture
Result<OwnWindow> hiddenWindow(glm::ivec2 picture_px, bool has_strip) {
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // where the driver has it
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  // Its size is right from the beginning: a window manager takes its time to change it.
  float scale = 1.0f, other = 1.0f;
  if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) glfwGetMonitorContentScale(monitor, &scale, &other);
  const glm::ivec2 size_px = picture_px + Desk::spaceBesidePicture(scale, has_strip);
  OwnWindow window(glfwCreateWindow(size_px.x, size_px.y, kBusyTitle, nullptr, nullptr), glfwDestroyWindow);
  if (!window)
    return fail(ErrorCode::no_gl, "the display has no OpenGL 4.3; `mirrorball render` makes pictures without one");
  glfwMakeContextCurrent(window.get());
  return window;
}

ViewerOptions viewerOptionsOf(const WindowOptions& options) {
  auto cache = CacheFolder::ofUser();
  return {.frame_s = 1e-3 * static_cast<double>(options.frame_ms),
          .cache = cache ? std::move(*cache) : std::optional<CacheFolder>()};
}

}  // namespace

PanelLibrary::PanelLibrary(GLFWwindow* window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 430 core");
}

PanelLibrary::~PanelLibrary() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

Session::Session(OwnWindow window, Device device, const WindowOptions& options, const History& start)
    : window_(std::move(window)),
      events_(window_.get()),
      panels_(window_.get()),
      device_(std::move(device)),
      viewer_(device_, start.now(), {1, 1}, viewerOptionsOf(options)),
      desk_(window_.get(), options),
      before_s_(glfwGetTime()) {
  viewer_.history() = start;
}

Result<std::unique_ptr<Session>> Session::open(const WindowOptions& options, const History& start) {
  MIRRORBALL_TRY(session,
                 openAt({.picture_px = frameOf(start.now(), 0).value_or(FrameSettings()).size}, options, start));
  MIRRORBALL_TRY_VOID(session->pressKeys(options.keys));
  if (!options.screenshot.empty() && options.pointer.size() == 2)
    session->viewer_.handle(PointerMoved{{options.pointer[0], options.pointer[1]}});
  return session;
}

Result<std::unique_ptr<Session>> Session::anew(std::unique_ptr<Session> lost, const WindowOptions& options) {
  WindowPlace place{.corner = glm::ivec2(0), .picture_px = lost->pictureSize()};
  glfwGetWindowPos(lost->window_.get(), &place.corner->x, &place.corner->y);
  const History history = lost->viewer_.history();
  // What is made in a context ends before there is another: names and places in memory are given again.
  const OwnWindow still_seen = lost->window_;
  lost.reset();
  return openAt(place, options, history);
}

Result<std::unique_ptr<Session>> Session::openAt(const WindowPlace& place, const WindowOptions& options,
                                                 const History& start) {
  MIRRORBALL_TRY(window, hiddenWindow(place.picture_px, hasSeveralMaps(start.now())));
  MIRRORBALL_TRY(context, gl::Context::adoptCurrent());
  MIRRORBALL_TRY(device, Device::on(std::move(context)));
  GLFWwindow* const handle = window.get();
  glfwSwapInterval(options.waits_for_screen ? 1 : 0);
  std::unique_ptr<Session> session(new Session(std::move(window), std::move(device), options, start));
  if (place.corner) glfwSetWindowPos(handle, place.corner->x, place.corner->y);
  if (options.screenshot.empty()) glfwShowWindow(handle);
  return session;
}

Result<void> Session::pressKeys(const std::string& chords) {
  std::istringstream words(chords);
  for (std::string chord; words >> chord;) {
    const KeyPressed pressed = pressedOf(chord);
    if (desk_.handle(viewer_, pressed)) continue;
    if (!commandOfKey(chord))
      return fail(ErrorCode::usage, "--keys: '" + chord + "' does nothing; the key ? shows those that do");
    viewer_.handle(pressed);
  }
  return {};
}

glm::ivec2 Session::windowSize() const {
  glm::ivec2 size_px(0);
  glfwGetFramebufferSize(window_.get(), &size_px.x, &size_px.y);
  return size_px;
}

glm::ivec2 Session::pictureSize() const {
  const glm::ivec2 beside_px(desk_.panelWidth(), desk_.menuHeight() + desk_.stripHeight(viewer_));
  return glm::max(windowSize() - beside_px, glm::ivec2(1));
}

/// Sleeps until there is something to do.
void Session::waitForEvents() const {
  if (viewer_.isDone())
    glfwWaitEventsTimeout(0.25);
  else if (viewer_.isWaiting())
    glfwWaitEventsTimeout(0.01);
  else
    glfwPollEvents();
}

void Session::takeHands() {
  for (const Event& event : events_.take(glm::vec2(0, desk_.menuHeight()))) {
    const auto* pressed = std::get_if<KeyPressed>(&event);
    if (!pressed || !desk_.handle(viewer_, *pressed)) viewer_.handle(event);
  }
  desk_.open(viewer_, events_.takeDropped());
}

Result<void> Session::advance() {
  desk_.followMonitor();
  viewer_.handle(Resized{pictureSize()});
  const double now_s = glfwGetTime();
  MIRRORBALL_TRY_VOID(viewer_.advance(now_s - std::exchange(before_s_, now_s)));
  return {};
}

/// framebuffer   0 is the window's
Result<void> Session::draw(unsigned framebuffer) {
  const glm::ivec2 picture_px = pictureSize();
  MIRRORBALL_TRY_VOID(viewer_.show(framebuffer, {0, desk_.stripHeight(viewer_)}, picture_px));
  return viewer_.leave();
}

/// Says in the title, which a list of windows shows too, whether there is something going on.
void Session::tellTitle() {
  const bool is_done = viewer_.isDone();
  if (std::exchange(was_done_, is_done) != is_done) glfwSetWindowTitle(window_.get(), is_done ? kTitle : kBusyTitle);
}

Result<bool> Session::step() {
  waitForEvents();
  takeHands();
  MIRRORBALL_TRY_VOID(advance());
  MIRRORBALL_TRY_VOID(draw(0));
  desk_.draw(viewer_, pictureSize());
  glfwSwapBuffers(window_.get());
  tellTitle();
  return !glfwWindowShouldClose(window_.get());
}

Result<void> Session::saveScreenshot(const std::string& path) {
  viewer_.history().goOn(viewer_.stillWorkspace());
  constexpr int kFrames = 4;  // menus and tables find their sizes in the first
  ImGui::GetIO().ConfigInputTextCursorBlink = false;
  MIRRORBALL_TRY(shot, Screenshot::make(windowSize()));
  for (int done = 0; done < kFrames; done = viewer_.isDone() && viewer_.status().loading.empty() ? done + 1 : 0) {
    glfwPollEvents();
    MIRRORBALL_TRY_VOID(advance());
    MIRRORBALL_TRY_VOID(draw(shot.framebuffer()));
    shot.bind();
    desk_.draw(viewer_, pictureSize());
  }
  const std::string problem = viewer_.status().problem;
  if (!problem.empty()) return fail(ErrorCode::unsupported, problem);
  return shot.save(path);
}

}  // namespace mirrorball::window
