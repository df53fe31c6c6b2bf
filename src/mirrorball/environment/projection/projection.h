#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/base/text.h"

namespace mirrorball {

/// A way to lay the sphere of directions onto images; docs/conventions.md shows each. A value: one of the kinds, and
/// for a photographed ball how far the camera stood. `Projection::cube` and the like stand for themselves in
/// comparisons, in `switch` and as arguments.
struct Projection {
  enum Kind {
    equirect,        ///< panorama
    sphere,          ///< mirror ball seen from infinitely far: OpenGL's sphere map
    angular,         ///< light probe
    cube,            ///< OpenGL's six faces
    ball,            ///< mirror ball photographed from a finite distance
    paraboloid,      ///< two discs: front (+Z) and back (−Z)
    octahedral,      ///< the sphere unfolded into a square
    hemioctahedral,  ///< the half z ≥ 0 on a square
    equal_area,      ///< pbrt-v4's square, all texels of one solid angle
    eac,             ///< equi-angular cube
  };
  static constexpr std::size_t kKinds = 10;

  /// The default distance from the camera to the ball's centre in ball radii: a ball of 10 cm from 1 m.
  static constexpr float kUsualBallDistance = 20.0f;
  /// Closer than this, floats cannot distinguish the directions next to the camera.
  static constexpr float kMinBallDistance = 1.01f;

  constexpr Projection() = default;
  constexpr Projection(Kind its_kind) : kind(its_kind) {}
  /// distance  of the camera from the ball's centre, in ball radii, at least kMinBallDistance; infinite: a sphere map
  static constexpr Projection ballFrom(float distance) {
    Projection projection(ball);
    projection.ball_distance = distance;
    return projection;
  }
  constexpr operator Kind() const { return kind; }

  friend constexpr bool operator==(const Projection& a, const Projection& b) {
    return a.kind == b.kind && (a.kind != ball || a.ball_distance == b.ball_distance);
  }
  friend constexpr bool operator==(const Projection& projection, Kind wanted) { return projection.kind == wanted; }

  Kind kind = equirect;
  float ball_distance = kUsualBallDistance;  ///< of a ball only
};

/// "equirect", "sphere", "angular", "cube", "ball", "paraboloid", "octahedral", "hemioctahedral", "equal-area", "eac":
/// the order of the kinds.
std::span<const std::string_view> projectionNames();
/// Other names that they are understood by.
std::span<const Alias> projectionAliases();
std::string_view nameOf(Projection projection);

/// The name, and a ball's distance: "ball:distance=20". projectionNamed reads it back.
std::string textOf(Projection projection);

/// The projection of a name, also of other common names: "equirectangular", "latlong". A ball's may be followed by
/// ":distance=D", D in ball radii.
///
/// errors   usage: lists the names; a distance that is no number or too small
Result<Projection> projectionNamed(std::string_view name);

/// A ball at that distance, written as a number of ball radii.
///
/// errors   usage
Result<Projection> ballAtDistance(std::string_view written);

/// A place in a map: the image (0 but for the faces of a cube, and 1 for the back of a paraboloid map) and the position
/// (u, v) in it, both in [0, 1], v down from the top row.
struct MapPosition {
  int face = 0;
  glm::vec2 uv{0.0f};
};

/// Where a direction (unit) is found; for a direction that the map does not cover, a place on the nearest edge.
MapPosition positionOf(Projection projection, glm::vec3 direction);

/// The unit direction at a position. On a disc (see hasDisc) only positions with `covers` have one, but a paraboloid
/// map continues into its other half; a cube's face continues a little beyond its edges.
glm::vec3 directionAt(Projection projection, MapPosition position);

/// Whether there is light at the position: false in the corners outside a disc.
bool covers(Projection projection, glm::vec2 uv);

/// Whether a direction (unit) has a place in the map: not behind a photographed ball, and not with z < 0 in a
/// hemioctahedral map.
bool covers(Projection projection, glm::vec3 direction);

/// The solid angle [sr] of all directions that it covers: 4π, except for those two.
float coveredSolidAngle(Projection projection);

/// Whether the light of each image fills a disc that touches its four sides, rather than all of it.
bool hasDisc(Projection projection);

/// How many images a map has: 6 for a cube, 2 for a paraboloid map, else 1.
int faceCount(Projection projection);

/// The size of each image, from the one number that --size is: a face's side, a disc's diameter, a square's side, a
/// panorama's height.
glm::ivec2 imageSize(Projection projection, int size);

/// The inverse: that number from a map's image, converted between projections of about equal detail: a panorama of
/// height h corresponds to cube faces of h / 2 and to discs and squares of h.
int equivalentSize(Projection from, int size, Projection to);

}  // namespace mirrorball
