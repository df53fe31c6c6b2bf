#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/view/inspect/inspector.h"

namespace mirrorball {

// What is told of the place under the pointer, as a face draws it without knowing what it is about.

/// A line over a picture or a plot, through places from its top left corner.
struct DrawnLine {
  std::vector<glm::vec2> places;
  glm::vec3 color{1.0f};  ///< sRGB-encoded
};

/// A curve or several, in a square from (0, 0) at the top left to (1, 1).
struct DrawnPlot {
  std::string title;
  std::vector<DrawnLine> lines = {};
  std::optional<glm::vec2> dot = {};
};

/// A small picture with marks.
struct MarkedPicture {
  std::string title;
  unsigned texture = 0;  ///< OpenGL's name; row 0 is the picture's bottom
  glm::ivec2 size_px{1};
  std::vector<DrawnLine> lines = {};  ///< pixels
  std::vector<DrawnLine> dots = {};   ///< likewise, a place each
};

/// A text over the picture.
struct DrawnText {
  std::string text;
  glm::vec2 corner{0.0f};  ///< upper left [pixels]
};

struct UnderPointer {
  std::vector<InspectionRow> rows = {};
  std::vector<DrawnLine> lines = {};  ///< over the picture, in its pixels
  std::vector<DrawnText> texts = {};
  std::vector<DrawnPlot> plots = {};
  std::vector<MarkedPicture> maps = {};
};

}  // namespace mirrorball
