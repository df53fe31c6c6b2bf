#pragma once

#include <span>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The ways to lay the sphere of directions onto images; docs/conventions.md shows each.
enum class Projection { equirect, sphere, angular, cube };

/// "equirect", "sphere", "angular", "cube": the enumeration's order.
std::span<const std::string_view> projectionNames();
std::string_view nameOf(Projection projection);
/// errors   usage: lists the names
Result<Projection> projectionNamed(std::string_view name);

/// A place in a map: the face (0 but for cubes) and the position (u, v) in it, both in [0, 1], v down from the top row.
struct MapPosition {
  int face = 0;
  glm::vec2 uv{0.0f};
};

/// Where a direction (unit) is found.
MapPosition positionOf(Projection projection, glm::vec3 direction);

/// The unit direction at a position. On a disc (sphere, angular) only positions with `covers` have one.
glm::vec3 directionAt(Projection projection, MapPosition position);

/// Whether there is light at the position: false in the corners beside a disc.
bool covers(Projection projection, glm::vec2 uv);

/// The solid angle [sr] of texel (x, y) of a face of width × height texels; 0 when its centre is beside the disc.
float texelSolidAngle(Projection projection, glm::ivec2 size, glm::ivec2 texel);

/// How many images a map has: 6 for a cube, else 1.
int faceCount(Projection projection);

/// The size of each image, from the one number that --size is: a face's side, a disc's diameter, a panorama's height.
glm::ivec2 imageSize(Projection projection, int size);

/// The one number back from a map's image, and between projections of about equal detail: a panorama of height h goes
/// with faces of h / 2 and discs of h.
int equivalentSize(Projection from, int size, Projection to);

/// Texels a radian in the middle of an image of that size; of a cube, in the middle of a face, where it is least.
float texelDensity(Projection projection, int size);

}  // namespace mirrorball
