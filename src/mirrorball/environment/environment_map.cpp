#include "mirrorball/environment/environment_map.h"

#include <algorithm>
#include <cassert>

#include "formula/formula.h"

namespace mirrorball {

EnvironmentMap::EnvironmentMap(Projection projection, ImageSet images)
    : projection_(projection), images_(std::move(images)) {
  assert(images_.levels() == 1 && images_.faces() == faceCount(projection));
  [[maybe_unused]] const glm::ivec2 wanted = imageSize(projection, size());
  for (int index = 0; index < faces(); ++index)
    assert(face(index).width() == wanted.x && face(index).height() == wanted.y);
}

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, Interpolation interpolation) const {
  const MapPosition place = positionOf(projection_, direction);
  const Image& image = face(place.face);
  const glm::vec2 position = place.uv * glm::vec2(image.width(), image.height());
  switch (projection_) {
    case Projection::equirect:
      return glm::vec3(interpolate(interpolation, position, [&](int x, int y) { return fetchEquirect(x, y); }));
    case Projection::cube:
      return glm::vec3(interpolate(interpolation, position, [&](int x, int y) { return fetchCube(place.face, x, y); }));
    case Projection::sphere:
    case Projection::angular:
      return radianceOfDisc(position, interpolation);
  }
  return {};
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

/// A texel whose centre lies beside the disc has no weight.
glm::vec4 EnvironmentMap::fetchDisc(int x, int y) const {
  const Image& image = face(0);
  const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  if (!formula::insideDisc(center / static_cast<float>(image.width()))) return glm::vec4(0.0f);
  return glm::vec4(rgbAt(image, x, y), 1.0f);
}

/// On the rim all four neighbours may lie beside the disc: then the position moves inwards until one does not.
glm::vec3 EnvironmentMap::radianceOfDisc(glm::vec2 position, Interpolation interpolation) const {
  const glm::vec2 middle(static_cast<float>(size()) / 2.0f);
  const glm::vec2 inwards = glm::normalize(middle - position);
  while (true) {
    const glm::vec4 light = interpolate(interpolation, position, [&](int x, int y) { return fetchDisc(x, y); });
    if (light.w > 0.0f) return glm::vec3(light);
    position += inwards * 0.5f;
  }
}

/// Beyond an edge the face's plane is continued, and the texel that lies in that direction on the neighbour is taken.
glm::vec4 EnvironmentMap::fetchCube(int face_index, int x, int y) const {
  const int side = size();
  if (x >= 0 && y >= 0 && x < side && y < side) return glm::vec4(rgbAt(face(face_index), x, y), 1.0f);
  const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  const glm::vec3 beyond = formula::cubePoint(face_index, center / static_cast<float>(side));
  const MapPosition place = positionOf(Projection::cube, beyond);
  const glm::ivec2 texel =
      glm::clamp(glm::ivec2(glm::floor(place.uv * static_cast<float>(side))), glm::ivec2(0), glm::ivec2(side - 1));
  return glm::vec4(rgbAt(face(place.face), texel.x, texel.y), 1.0f);
}

}  // namespace mirrorball
