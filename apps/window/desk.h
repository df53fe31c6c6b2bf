#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/view/control/event.h"
#include "mirrorball/view/viewer/viewer.h"
#include "mirrorball/view/workspace/recent_files.h"
#include "mirrorball/view/workspace/view_request.h"

struct GLFWwindow;

namespace mirrorball::window {

/// What is drawn beside the picture: menus, dialogs, panels, lines of status; and what is opened and saved with them.
class Desk {
 public:
  /// window   must outlive it; Dear ImGui must be there
  Desk(GLFWwindow* window, const WindowOptions& options);

  /// Makes all as large as the monitor asks for.
  void followMonitor();

  /// How wide the panels are, and how high the menus [pixels], on a monitor that asks for all to be so many times as
  /// large.
  ///
  /// has_strip   whether there is a strip of panoramas, which is counted to the menus
  static glm::ivec2 spaceBesidePicture(float scale, bool has_strip = false);
  int panelWidth() const { return spaceBesidePicture(scale_).x; }
  int menuHeight() const { return spaceBesidePicture(scale_).y; }

  /// Opens files in turn, and notes them as recent.
  void open(Viewer& viewer, const std::vector<std::string>& paths);

  /// Takes a key for itself.
  ///
  /// returns   whether it did
  bool handle(Viewer& viewer, const KeyPressed& pressed);

  /// How high the strip of panoramas below the picture is; 0: there is none [pixels]
  int stripHeight(const Viewer& viewer) const;

  void draw(Viewer& viewer, glm::ivec2 picture_px);

  /// Says a line above the options, until there is another.
  void tell(const std::string& line) { told_ = line; }

 private:
  enum class Dialog { none, open, save_workspace, save_picture, keys };

  void drawMenus(Viewer& viewer);
  void drawFileMenu(Viewer& viewer);
  std::string& path() { return paths_[static_cast<std::size_t>(dialog_)]; }
  void drawDialog(Viewer& viewer, glm::ivec2 picture_px);
  void drawSizeFields(glm::ivec2 picture_px, bool has_animation);
  void accept(Viewer& viewer);
  void drawStatus(Viewer& viewer) const;
  void copyCommandLine(const Viewer& viewer);
  void useTheme(Theme theme);

  GLFWwindow* window_;
  std::optional<RecentFiles> recent_;
  float scale_ = 0.0f;
  Theme theme_;
  Dialog dialog_ = Dialog::none;
  bool dialog_begins_ = false;
  bool wants_search_ = false;
  std::array<std::string, 5> paths_;  // that stand in each dialog
  glm::ivec2 saved_px_{0};
  int frames_ = 0;
  bool plays_ = false;
  std::string search_;
  std::string told_;
};

}  // namespace mirrorball::window
