#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mirrorball/view/control/event.h"

struct GLFWwindow;

namespace mirrorball::window {

/// What has happened in a window since it was last asked, in the viewer's terms. What the panels take for themselves is
/// left out.
class WindowEvents {
 public:
  /// Listens to a window, which must outlive it. To be made before Dear ImGui listens, which calls what was there.
  explicit WindowEvents(GLFWwindow* window);

  /// picture_px   where the picture begins in the window, from its top left corner
  std::vector<Event> take(glm::vec2 picture_px);
  std::vector<std::string> takeDropped() { return std::exchange(dropped_, {}); }

 private:
  static WindowEvents& of(GLFWwindow* window);
  void add(Event event) { events_.push_back(std::move(event)); }

  std::vector<Event> events_;
  std::vector<std::string> dropped_;  ///< files
};

}  // namespace mirrorball::window
