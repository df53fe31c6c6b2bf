#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/view/map/map_view_settings.h"

namespace mirrorball {

// Where a picture of a map shows what. Places are pixels of the picture from its top left corner; pixel (i, j) has its
// centre at (i + ½, j + ½).

/// The room that a picture of a map has.
struct MapCanvas {
  glm::ivec2 size_px{1280, 720};  ///< at least 1 × 1
  int line_px = 16;               ///< height that the face needs for a line of text, at least 1
  glm::ivec2 photograph_px{0};    ///< size of a photograph that is to be seen beside the map; 0: none is

  bool operator==(const MapCanvas&) const = default;
};

/// A part of a picture.
struct PixelRectangle {
  glm::ivec2 corner{0};  ///< upper left
  glm::ivec2 extent{0};

  bool holds(glm::vec2 pixel) const;
};

/// An image of a projection in the picture: a whole map, a face of a cube, a half of a paraboloid map.
struct MapPane {
  Projection projection;
  int face = 0;
  PixelRectangle place = {};
};

/// A line of text that a face writes into the picture, in letters of its own.
struct MapLabel {
  std::string text;
  glm::ivec2 corner{0};  ///< upper left
};

/// What a picture consists of.
struct MapLayout {
  std::vector<MapPane> panes = {};            ///< images of one projection lie behind each other in the list
  std::optional<PixelRectangle> inside = {};  ///< the view from inside
  std::optional<PixelRectangle> legend = {};  ///< of the false colours: from dark on the left to bright
  std::optional<PixelRectangle> waveform = {};
  std::optional<PixelRectangle> photograph = {};  ///< that the map was unwrapped from, in its own proportions
  std::vector<MapLabel> labels = {};              ///< projections' names, and stops at the legend and the waveform
};

/// Lays a picture out. A cube is a horizontal cross, a paraboloid map its front with its back on the right; on the
/// sheet of all projections, rows are as high as the picture lets them. A photograph takes half of the picture. What
/// has no room is left out.
///
/// cost     microseconds
MapLayout mapLayout(const MapViewSettings& settings, const MapCanvas& canvas);

/// The unit direction that a pixel shows; nothing beside the light of a map.
std::optional<glm::vec3> directionAtPixel(const MapViewSettings& settings, const MapCanvas& canvas, glm::vec2 pixel);

/// The other way: where a direction (unit) is seen, once in each projection that covers it.
std::vector<glm::vec2> pixelsOf(const MapViewSettings& settings, const MapCanvas& canvas, glm::vec3 direction);

/// The same of a layout that is there already.
std::optional<glm::vec3> directionAtPixel(const MapLayout& layout, const MapViewSettings& settings, glm::vec2 pixel);
std::vector<glm::vec2> pixelsOf(const MapLayout& layout, const MapViewSettings& settings, glm::vec3 direction);

/// The pane that a pixel lies in, beside the light of its map too.
const MapPane* paneAt(const MapLayout& layout, glm::vec2 pixel);

/// The eye inside a map.
struct MapEye {
  glm::mat3 world_from_eye{1.0f};  ///< of x to the right, y up and z ahead
  float focal_px = 1.0f;           ///< pixels for a tangent of 1
  glm::vec2 middle_px{0.0f};       ///< where it looks

  /// Not unit: one long ahead.
  glm::vec3 rayAt(glm::vec2 pixel) const;
  /// Nothing behind the eye.
  std::optional<glm::vec2> pixelOf(glm::vec3 direction) const;
};
MapEye mapEye(const MapViewSettings& settings, const PixelRectangle& place);

}  // namespace mirrorball
