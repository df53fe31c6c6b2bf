#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace mirrorball::bench {

/// Points of one curve; a single one is a dot.
struct Curve {
  std::string name;
  std::vector<glm::dvec2> points;
  std::vector<std::string> labels = {};  ///< beside the points; fewer or none
};

/// How numbers lie along a side of the picture.
struct Axis {
  std::string label;
  bool is_logarithmic;
};

/// A picture of curves with a legend, as the text of an SVG file that needs no fonts but the viewer's.
///
/// curves   at least one point; on a logarithmic axis above 0
std::string svgPlot(const std::string& title, const Axis& across, const Axis& up, const std::vector<Curve>& curves);

}  // namespace mirrorball::bench
