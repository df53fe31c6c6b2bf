#include "mirrorball/environment/environment_map.h"

#include <algorithm>
#include <cassert>

#include "formula/formula.h"

namespace mirrorball {

EnvironmentMap::EnvironmentMap(Projection projection, ImageSet images)
    : projection_(projection), has_disc_(hasDisc(projection)), images_(std::move(images)) {
  assert(images_.levels() == 1 && images_.faces() == faceCount(projection));
  [[maybe_unused]] const glm::ivec2 wanted = imageSize(projection, size());
  for (int index = 0; index < faces(); ++index)
    assert(face(index).width() == wanted.x && face(index).height() == wanted.y);
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, Interpolation interpolation) const {
  if (projection_ == Projection::hemioctahedral && direction.z < 0.0f) return glm::vec3(0.0f);
  const MapPosition place = positionOf(projection_, direction);
  const Image& image = face(place.face);
  const glm::vec2 extent(image.width(), image.height());
  glm::vec2 position = place.uv * extent;
  const auto fetch_texel = [&](int x, int y) { return fetch(place.face, x, y); };
  glm::vec4 light = interpolate(interpolation, position, fetch_texel);
  // On a rim all four neighbours may lie beside the disc: then the position moves inwards until one does not.
  while (light.w == 0.0f) {
    position += glm::normalize(extent / 2.0f - position) * 0.5f;
    light = interpolate(interpolation, position, fetch_texel);
  }
  return glm::vec3(light);
}

/// A texel for `bilinear`: one that may lie beyond an edge or beside a disc.
glm::vec4 EnvironmentMap::fetch(int face_index, int x, int y) const {
  switch (projection_) {
    case Projection::equirect:
      return fetchEquirect(x, y);
    case Projection::octahedral:
    case Projection::equal_area:
      return fetchFolded(x, y);
    case Projection::cube:
    case Projection::eac:
    case Projection::paraboloid:
      return fetchTowards(face_index, x, y);
    default:
      return fetchCovered(face_index, x, y);
  }
}

/// Left and right edges meet; beyond a pole the row continues on the opposite meridian.
glm::vec4 EnvironmentMap::fetchEquirect(int x, int y) const {
  const Image& image = face(0);
  if (y < 0 || y >= image.height()) {
    y = y < 0 ? -1 - y : 2 * image.height() - 1 - y;
    x += image.width() / 2;
  }
  x = (x % image.width() + image.width()) % image.width();
  return glm::vec4(rgbAt(image, x, y), 1.0f);
}

/// Each edge of an unfolded octahedron is sewn to itself, turned about its middle; the corners are one point.
glm::vec4 EnvironmentMap::fetchFolded(int x, int y) const {
  const int side = size();
  if (x < 0 || x >= side) {
    x = x < 0 ? -1 - x : 2 * side - 1 - x;
    y = side - 1 - y;
  }
  if (y < 0 || y >= side) {
    y = y < 0 ? -1 - y : 2 * side - 1 - y;
    x = side - 1 - x;
  }
  return glm::vec4(rgbAt(face(0), x, y), 1.0f);
}

/// A texel outside the image, or whose centre lies beside the disc, has no weight.
glm::vec4 EnvironmentMap::fetchCovered(int face_index, int x, int y) const {
  const Image& image = face(face_index);
  if (x < 0 || y < 0 || x >= image.width() || y >= image.height()) return glm::vec4(0.0f);
  if (has_disc_) {
    const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    if (!formula::insideDisc(center / static_cast<float>(image.width()))) return glm::vec4(0.0f);
  }
  return glm::vec4(rgbAt(image, x, y), 1.0f);
}

/// Beyond its edge an image is continued by the projection's own formula, and another image answers for what lies in
/// that direction, from its own texels.
glm::vec4 EnvironmentMap::fetchTowards(int face_index, int x, int y) const {
  const glm::vec4 own = fetchCovered(face_index, x, y);
  if (own.w > 0.0f) return own;
  const auto side = static_cast<float>(size());
  const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  const MapPosition place = positionOf(projection_, directionAt(projection_, {face_index, center / side}));
  const glm::vec4 light = bilinear(place.uv * side, [&](int i, int j) { return fetchCovered(place.face, i, j); });
  return glm::vec4(glm::vec3(light), light.w > 0.0f ? 1.0f : 0.0f);
}

}  // namespace mirrorball
