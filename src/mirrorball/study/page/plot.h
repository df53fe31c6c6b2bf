#pragma once

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
  bool y_from_zero = true;  ///< else from where the curves begin
  std::string y_label;
  std::vector<Curve> curves = {};
};

/// A plot with linear axes as an element <svg> for a page, whose classes `curve0` to `curve7` colour it. Each point
/// tells its numbers.
///
/// id       of the element, of which others are made; each in the page only once
std::string svgOf(const Plot& plot, const std::string& id);

}  // namespace mirrorball
