#pragma once

#include <memory>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/view/viewer/viewer.h"
#include "mirrorball/view/workspace/history.h"
#include "mirrorball/view/workspace/view_request.h"
#include "window/desk.h"
#include "window/window_events.h"

struct GLFWwindow;

namespace mirrorball::window {

struct CloseWindow {
  void operator()(GLFWwindow* window) const;
};
using OwnWindow = std::unique_ptr<GLFWwindow, CloseWindow>;

/// Dear ImGui on a window, whose context is current.
class PanelLibrary {
 public:
  explicit PanelLibrary(GLFWwindow* window);
  ~PanelLibrary();
  PanelLibrary(const PanelLibrary&) = delete;
  PanelLibrary& operator=(const PanelLibrary&) = delete;
};

/// A window, its OpenGL context, and a viewer that draws into it. One at a time.
class Session {
 public:
  /// Opens a window, which nobody sees if a screenshot is asked for.
  ///
  /// errors   no_gl; usage: a key of the options that does nothing
  static Result<std::unique_ptr<Session>> open(const WindowOptions& options, const History& start);

  /// Takes what hands have done, lets time go on, and shows what there is then.
  ///
  /// returns  whether the window is to stay
  /// errors   no_gl
  Result<bool> step();

  /// Writes what the window shows once the picture is whole.
  ///
  /// errors   no_gl; what the viewer's status says if it cannot show what it was asked for; Screenshot::save's
  Result<void> saveScreenshot(const std::string& path);

 private:
  Session(OwnWindow window, Device device, const WindowOptions& options, const History& start);
  Result<void> pressKeys(const std::string& chords);
  glm::ivec2 windowSize() const;
  glm::ivec2 pictureSize() const;
  void takeHands();
  Result<void> advance();
  Result<void> draw(unsigned framebuffer);
  void waitForEvents() const;
  void tellTitle();

  OwnWindow window_;
  WindowEvents events_;
  PanelLibrary panels_;
  Device device_;
  Viewer viewer_;
  Desk desk_;
  double before_s_;
  bool was_done_ = false;
};

}  // namespace mirrorball::window
