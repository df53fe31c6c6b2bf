#include "mirrorball/environment/projection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/formula.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 4> kNames{"equirect", "sphere", "angular", "cube"};

/// The image's v grows downwards, OpenGL's t of a sphere map upwards.
glm::vec2 flipped(glm::vec2 st) { return {st.x, 1.0f - st.y}; }

/// d(ω)/d(area) of the angular map at radius r of the unit disc: θ = π r, dω = sin θ dθ dφ, dA = r dr dφ.
float angularDensity(float radius) {
  const float angle = formula::kPi * radius;
  return radius < 1e-4f ? formula::kPi * formula::kPi : formula::kPi * std::sin(angle) / radius;
}

}  // namespace

std::span<const std::string_view> projectionNames() { return kNames; }

std::string_view nameOf(Projection projection) { return kNames[static_cast<std::size_t>(projection)]; }

Result<Projection> projectionNamed(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return tl::unexpected<Error>(unknownName("projection", name, kNames));
  return static_cast<Projection>(found - kNames.begin());
}

MapPosition positionOf(Projection projection, glm::vec3 direction) {
  switch (projection) {
    case Projection::equirect:
      return {0, formula::equirectPosition(direction)};
    case Projection::sphere:
      return {0, flipped(formula::sphereMapCoordinates(direction))};
    case Projection::angular:
      return {0, formula::angularPosition(direction)};
    case Projection::cube: {
      const int face = formula::cubeFace(direction);
      return {face, formula::cubeCoordinates(face, direction)};
    }
  }
  return {};
}

glm::vec3 directionAt(Projection projection, MapPosition position) {
  switch (projection) {
    case Projection::equirect:
      return formula::equirectDirection(position.uv);
    case Projection::sphere:
      return formula::sphereMapDirection(flipped(position.uv));
    case Projection::angular:
      return formula::angularDirection(position.uv);
    case Projection::cube:
      return formula::cubeDirection(position.face, position.uv);
  }
  return {};
}

bool covers(Projection projection, glm::vec2 uv) {
  const bool is_disc = projection == Projection::sphere || projection == Projection::angular;
  return !is_disc || formula::insideDisc(uv);
}

float texelSolidAngle(Projection projection, glm::ivec2 size, glm::ivec2 texel) {
  const glm::vec2 extent(size);
  const glm::vec2 low = glm::vec2(texel) / extent;
  const glm::vec2 high = glm::vec2(texel + 1) / extent;
  const glm::vec2 center = (low + high) / 2.0f;
  if (!covers(projection, center)) return 0.0f;
  const float disc_area = 4.0f / (extent.x * extent.y);  // of one texel, on the unit disc
  switch (projection) {
    case Projection::equirect:
      return formula::equirectTexelSolidAngle(low.y, high.y, extent.x);
    case Projection::sphere:
      return 4.0f * disc_area;  // dω = 4 dA, see formula/sphere_map.glsl
    case Projection::angular:
      return disc_area * angularDensity(2.0f * glm::length(center - 0.5f));
    case Projection::cube:
      return formula::cubeRectangleSolidAngle(2.0f * low.x - 1.0f, 2.0f * low.y - 1.0f, 2.0f * high.x - 1.0f,
                                              2.0f * high.y - 1.0f);
  }
  return 0.0f;
}

int faceCount(Projection projection) { return projection == Projection::cube ? 6 : 1; }

glm::ivec2 imageSize(Projection projection, int size) {
  return {projection == Projection::equirect ? 2 * size : size, size};
}

int equivalentSize(Projection from, int size, Projection to) {
  const int panorama_height = from == Projection::cube ? 2 * size : size;
  return to == Projection::cube ? std::max(panorama_height / 2, 1) : panorama_height;
}

float texelDensity(Projection projection, int size) {
  const auto texels = static_cast<float>(size);
  switch (projection) {
    case Projection::equirect:
      return texels / formula::kPi;
    case Projection::sphere:
      return texels / 4.0f;  // the reflected ray turns twice as fast as the normal, of which the disc shows 2 rad
    case Projection::angular:
      return texels / formula::kTwoPi;
    case Projection::cube:
      return texels / 2.0f;
  }
  return texels;
}

}  // namespace mirrorball
