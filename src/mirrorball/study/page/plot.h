#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace mirrorball {

/// Points that belong together, from left to right.
struct Curve {
  std::string name;
  std::vector<glm::dvec2> points = {};
};

/// Numbers over a number, as lines with their points.
struct Plot {
  std::string title = {};
  std::string x_label;
  double x_step = 0.0;      ///< between marks; 0: a round number for some six of them
  bool y_from_zero = true;  ///< else from where the curves begin
  std::string y_label;
  bool marks_points = true;  ///< each point tells its numbers; else there are lines alone
  std::vector<Curve> curves = {};
};

/// A plot with linear axes as an element <svg> for a page, whose classes `curve0` to `curve7` colour it (plot.css;
/// page.css has the colours of what is no curve).
///
/// id       of the element, of which others are made; each in the page only once
std::string svgOf(const Plot& plot, const std::string& id);

/// Plots one below the other as a file .svg of its own, dark on white.
std::string svgFileOf(std::span<const Plot> plots);

}  // namespace mirrorball
