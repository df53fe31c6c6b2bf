#pragma once

#include <string>

#include "mirrorball/view/viewer/viewer.h"

namespace mirrorball::window {

/// The viewer's panels as widgets of Dear ImGui: draws them, and makes the changes that are asked for.
///
/// search      what stands in the field that rows are found by
/// is_wanted   whether the keyboard is to write into that field
void drawPanels(Viewer& viewer, std::string& search, bool is_wanted);

/// What is told of the place under the pointer, as rows, plots and small pictures.
void drawUnderPointer(const UnderPointer& under);

/// What is drawn and written over the picture.
///
/// corner   upper left one of the picture in the window
void drawOverPicture(const UnderPointer& under, glm::vec2 corner);

/// The panoramas that there are to choose among, in a window whose place is set.
void drawThumbnails(Viewer& viewer, float scale);

/// The viewer's commands as menus, within a menu bar that has begun.
void drawCommandMenus(Viewer& viewer);

}  // namespace mirrorball::window
