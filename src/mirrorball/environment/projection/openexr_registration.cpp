#include "mirrorball/environment/projection/openexr_registration.h"

#include <algorithm>

#include "mirrorball/environment/convert/map_by_texel.h"

namespace mirrorball {
namespace {

/// Looks up what lies between the texels of images in OpenEXR's registration.
class OpenExrReader {
 public:
  explicit OpenExrReader(const EnvironmentMap& images)
      : images_(images), last_(glm::ivec2(images.face(0).width(), images.face(0).height()) - 1) {}

  glm::vec3 radiance(glm::vec3 direction) const {
    const MapPosition place = positionOf(images_.projection(), direction);
    return glm::vec3(bicubic(positionInTexels(place.uv), [&](int x, int y) { return fetch(place.face, x, y); }));
  }

 private:
  /// As bilinear and bicubic take it: texel i has its centre at i + ½.
  glm::vec2 positionInTexels(glm::vec2 uv) const { return uv * glm::vec2(last_) + 0.5f; }

  glm::vec4 texel(int face, int x, int y) const {
    return glm::vec4(rgbAt(images_.face(face), std::clamp(x, 0, last_.x), std::clamp(y, 0, last_.y)), 1.0f);
  }

  /// A texel that may lie beyond an edge.
  glm::vec4 fetch(int face, int x, int y) const {
    if (images_.projection() == Projection::equirect) return fetchPanorama(x, y);
    if (x >= 0 && y >= 0 && x <= last_.x && y <= last_.y) return texel(face, x, y);
    // The plane of the face continues, and the face that lies there answers.
    const glm::vec2 beyond = glm::vec2(x, y) / glm::vec2(last_);
    const MapPosition place = positionOf(Projection::cube, directionAt(Projection::cube, {face, beyond}));
    return bilinear(positionInTexels(place.uv), [&](int i, int j) { return texel(place.face, i, j); });
  }

  /// Around, the columns repeat after width − 1, since the last is the first again. The rows of the poles are one point
  /// each, and beyond it a row continues half way round, where width − 1 may be odd: between two texels.
  glm::vec4 fetchPanorama(int x, int y) const {
    const auto around = [&](int column) { return (column % last_.x + last_.x) % last_.x; };
    if (y >= 0 && y <= last_.y) return texel(0, around(x), y);
    const int row = y < 0 ? -y : 2 * last_.y - y;
    return 0.5f * (texel(0, around(x + last_.x / 2), row) + texel(0, around(x + (last_.x + 1) / 2), row));
  }

  const EnvironmentMap& images_;
  glm::ivec2 last_;
};

}  // namespace

EnvironmentMap toOpenExrRegistration(const EnvironmentMap& map) {
  if (map.size() == 1) return map;
  const glm::vec2 last = imageSize(map.projection(), map.size()) - 1;
  return mapByTexel(map.projection(), map.size(), [&](int face, glm::ivec2 texel) {
    const glm::vec3 direction = directionAt(map.projection(), {face, glm::vec2(texel) / last});
    return map.radiance(direction, Interpolation::bicubic);
  });
}

EnvironmentMap fromOpenExrRegistration(const EnvironmentMap& images) {
  if (images.size() == 1) return images;
  const OpenExrReader reader(images);
  const glm::vec2 extent = imageSize(images.projection(), images.size());
  return mapByTexel(images.projection(), images.size(), [&](int face, glm::ivec2 texel) {
    return reader.radiance(directionAt(images.projection(), {face, (glm::vec2(texel) + 0.5f) / extent}));
  });
}

}  // namespace mirrorball
