#pragma once

#include <memory>
#include <optional>
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

/// Closes at its last owner's end.
using OwnWindow = std::shared_ptr<GLFWwindow>;

/// Dear ImGui on a window, whose context is current.
class PanelLibrary {
 public:
  explicit PanelLibrary(GLFWwindow* window);
  ~PanelLibrary();
  PanelLibrary(const PanelLibrary&) = delete;
  PanelLibrary& operator=(const PanelLibrary&) = delete;
};

/// Where a window is.
struct WindowPlace {
  std::optional<glm::ivec2> corner = {};  ///< of what is within its frame [screen coordinates]; nothing: anywhere
  glm::ivec2 picture_px{1280, 720};       ///< size of the picture beside the panels
};

/// A window, its OpenGL context, and a viewer that draws into it. One at a time.
class Session {
 public:
  /// Opens a window, which nobody sees if a screenshot is asked for, with a picture as large as the workspace says.
  ///
  /// errors   no_gl; usage: a key of the options that does nothing
  static Result<std::unique_ptr<Session>> open(const WindowOptions& options, const History& start);

  /// Goes on in another window at the same place, whose context is new. What the lost one has shown stays on the
  /// display until then.
  ///
  /// errors   no_gl
  static Result<std::unique_ptr<Session>> anew(std::unique_ptr<Session> lost, const WindowOptions& options);

  /// Takes what hands have done, lets time go on, and shows what there is then.
  ///
  /// returns  whether the window is to stay
  /// errors   no_gl: the context is lost
  Result<bool> step();

  /// Writes what the window shows once the picture is whole.
  ///
  /// errors   no_gl; what the viewer's status says if it cannot show what it was asked for; Screenshot::save's
  Result<void> saveScreenshot(const std::string& path);

  /// As it is to be kept.
  Workspace workspace() const { return viewer_.stillWorkspace(); }
  /// Says a line above the options.
  void tell(const std::string& line) { desk_.tell(line); }

 private:
  static Result<std::unique_ptr<Session>> openAt(const WindowPlace& place, const WindowOptions& options,
                                                 const History& start);
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
