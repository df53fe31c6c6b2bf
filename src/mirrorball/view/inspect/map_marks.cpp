#include "mirrorball/view/inspect/map_marks.h"

#include <cstddef>
#include <utility>

#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

using PlaceOfDirection = glm::vec2 (*)(glm::vec3);

glm::vec2 placeInPanorama(glm::vec3 direction) { return positionOf(Projection::equirect, direction).uv; }
glm::vec2 placeInSphereMap(glm::vec3 direction) { return positionOf(Projection::sphere, direction).uv; }
glm::vec2 placeInCross(glm::vec3 direction) {
  return placeInLayout(positionOf(Projection::cube, direction), CubeLayout::hcross);
}

/// Draws the lines of one map.
class MapPen {
 public:
  explicit MapPen(PlaceOfDirection place) : place_(place) {}

  void moveTo(glm::vec3 direction) {
    lift();
    line_.push_back(place_(direction));
  }

  /// Goes on from one direction to another along the shortest way on the sphere. Places that stay apart however near
  /// the directions are lie on both sides of a seam.
  void drawTo(glm::vec3 from, glm::vec3 to, int halvings_left = kMostHalvings) {
    const glm::vec2 place = place_(to);
    if (glm::distance(line_.back(), place) <= kJoined) {
      line_.push_back(place);
    } else if (halvings_left == 0) {
      moveTo(to);
    } else {
      const glm::vec3 middle = glm::normalize(from + to);
      drawTo(from, middle, halvings_left - 1);
      drawTo(middle, to, halvings_left - 1);
    }
  }

  std::vector<std::vector<glm::vec2>> lines() && {
    lift();
    return std::move(lines_);
  }

 private:
  static constexpr float kJoined = 0.02f;  // of the picture: no line is straight for longer
  static constexpr int kMostHalvings = 10;

  void lift() {
    if (line_.size() > 1) lines_.push_back(line_);
    line_.clear();
  }

  PlaceOfDirection place_;
  std::vector<glm::vec2> line_;
  std::vector<std::vector<glm::vec2>> lines_;
};

MapMark markOf(PlaceOfDirection place, glm::vec3 direction, std::span<const glm::vec3> outline) {
  MapPen pen(place);
  if (!outline.empty()) pen.moveTo(outline[0]);
  for (std::size_t i = 0; i < outline.size(); ++i) pen.drawTo(outline[i], outline[(i + 1) % outline.size()]);
  return {place(direction), std::move(pen).lines()};
}

}  // namespace

MapMarks marksOf(glm::vec3 direction, std::span<const glm::vec3> outline) {
  return {markOf(placeInPanorama, direction, outline), markOf(placeInCross, direction, outline),
          markOf(placeInSphereMap, direction, outline)};
}

}  // namespace mirrorball
