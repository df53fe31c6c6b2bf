#include "mirrorball/environment/projection/smooth_region.h"

#include <algorithm>
#include <cmath>

#include "formula/projection.h"

namespace mirrorball {
namespace {

/// Texels whose centres lie on a border are on the region, whatever rounding does.
constexpr float kOnBorder_texels = 1e-3f;

glm::vec2 signsOf(glm::vec2 v) { return {v.x < 0.0f ? -1.0f : 1.0f, v.y < 0.0f ? -1.0f : 1.0f}; }

}  // namespace

bool hasSmoothRegions(Projection projection) {
  switch (projection) {
    case Projection::cube:
    case Projection::eac:
    case Projection::paraboloid:
    case Projection::octahedral:
    case Projection::hemioctahedral:
    case Projection::equal_area:
      return true;
    default:
      return false;
  }
}

SmoothRegion::SmoothRegion(Projection projection, int side, MapPosition place)
    : projection_(projection), face_(place.face), side_(static_cast<float>(side)) {
  const glm::vec2 middle(side_ / 2.0f);
  const glm::vec2 from_middle = place.uv * side_ - middle;
  if (projection == Projection::paraboloid) {
    shape_ = Shape::disc;
    corner_ = middle;
    towards_ = signsOf(from_middle);
  } else if (faceCount(projection) == 6) {
    shape_ = Shape::square;
    corner_ = middle + middle * signsOf(from_middle);
    towards_ = -signsOf(from_middle);
  } else {
    shape_ = Shape::triangle;
    standOnTriangle(from_middle);
  }
}

/// Two triangles fill a quarter of the square. They meet in the diagonal from the middle of a side to the middle of the
/// next, or in half an octahedral map in the one from the middle to the corner.
void SmoothRegion::standOnTriangle(glm::vec2 from_middle) {
  const glm::vec2 signs = signsOf(from_middle);
  const glm::vec2 size = glm::abs(from_middle);
  const float half = side_ / 2.0f;
  glm::vec2 corner(0.0f);
  if (projection_ == Projection::hemioctahedral)
    corner = size.x > size.y ? glm::vec2(half, 0.0f) : glm::vec2(0.0f, half);
  else if (size.x + size.y > half)
    corner = glm::vec2(half);
  corner_ = half + signs * corner;
  towards_ = signs * glm::vec2(corner.x > 0.0f ? -1.0f : 1.0f, corner.y > 0.0f ? -1.0f : 1.0f);
}

bool SmoothRegion::holds(glm::vec2 position) const {
  if (shape_ == Shape::disc) return formula::insideDisc(position / side_);
  const glm::vec2 local = (position - corner_) * towards_;
  if (std::min(local.x, local.y) < -kOnBorder_texels) return false;
  if (shape_ == Shape::square) return std::max(local.x, local.y) <= side_ + kOnBorder_texels;
  return local.x + local.y <= side_ / 2.0f + kOnBorder_texels;
}

MapPosition SmoothRegion::placeOf(glm::vec2 position) const {
  if (shape_ != Shape::triangle) return positionOf(projection_, directionAt(projection_, {face_, position / side_}));
  if (projection_ == Projection::equal_area) return onEqualArea(position);
  const bool is_beside = std::min(position.x, position.y) < 0.0f || std::max(position.x, position.y) > side_;
  if (projection_ == Projection::hemioctahedral && is_beside) return {0, position / side_};
  return onOctahedron(position);
}

/// Where the octahedron is flat its points go in proportion to the position. So they go on beyond the border: as far
/// from the one half way to the region's middle as that is from the middle.
MapPosition SmoothRegion::onOctahedron(glm::vec2 position) const {
  const auto pointAt = [&](glm::vec2 at) {
    const glm::vec3 direction = directionAt(projection_, {0, at / side_});
    const glm::vec3 size = glm::abs(direction);
    return direction / (size.x + size.y + size.z);
  };
  const glm::vec2 middle = corner_ + towards_ * (side_ / 6.0f);
  return positionOf(projection_, glm::normalize(2.0f * pointAt((middle + position) / 2.0f) - pointAt(middle)));
}

/// formula/projection/octahedral.glsl: at the distance r from the right angle, along the legs, stand the directions
/// with |z| = 1 − r², and the longitude grows in proportion from one leg to the other. Past a leg it goes on growing:
/// those are the region's own directions turned by 90° about z. Past r = 1 follow the directions with |z| = r² − 1 of
/// the other half, which are its mirror image, with the r² there of 2 − r².
MapPosition SmoothRegion::onEqualArea(glm::vec2 position) const {
  const float half = side_ / 2.0f;
  const bool is_front = corner_.x == half;
  const auto swappedBehind = [&](glm::vec2 v) { return is_front ? v : glm::vec2(v.y, v.x); };
  const glm::vec2 from_legs = swappedBehind((position - corner_) * towards_ / half);
  float r = from_legs.x + from_legs.y;
  if (r <= 0.0f) return {0, position / side_};
  const float share = from_legs.y / r;
  const float turns = share < 0.0f ? -1.0f : share > 1.0f ? 1.0f : 0.0f;
  const bool is_other_half = r > 1.0f;
  if (is_other_half) r = std::sqrt(2.0f - r * r);
  const glm::vec2 within = r * glm::vec2(1.0f - share + turns, share - turns);
  glm::vec3 direction = directionAt(projection_, {0, (corner_ + towards_ * swappedBehind(within) * half) / side_});
  if (turns != 0.0f) {
    // From x to y is anticlockwise in a quarter where both have one sign; in the image y grows the other way.
    const float turn = -turns * towards_.x * towards_.y;
    direction = glm::vec3(-turn * direction.y, turn * direction.x, direction.z);
  }
  if (is_other_half) direction.z = -direction.z;
  return positionOf(projection_, direction);
}

std::optional<CubicStencil> SmoothRegion::cubicStencil(glm::vec2 position) const {
  const int side = static_cast<int>(side_);
  if (side < 16) return std::nullopt;
  // The first texel's centre lies half a texel from the corner, or on it where that is a texel's centre itself.
  const glm::vec2 first_center = 0.5f - (corner_ - glm::floor(corner_));
  const glm::vec2 at = (position - corner_) * towards_ - first_center;
  glm::ivec2 index(glm::floor(at - 0.5f));
  if (shape_ == Shape::disc) {
    moveOntoDisc(first_center, index);
  } else {
    index = glm::clamp(index, 0, side - 4);
    if (shape_ == Shape::triangle) {
      const float longest = side_ / 2.0f + kOnBorder_texels - first_center.x - first_center.y;
      const int beyond = index.x + index.y + 3 - static_cast<int>(longest);
      if (beyond > 0) {
        index.x -= (beyond + 1) / 2;
        index.y -= beyond / 2;
        if (index.x < 0) index = {0, index.y + index.x};
        if (index.y < 0) index = {index.x + index.y, 0};
      }
    }
  }
  const glm::vec2 center = corner_ + towards_ * (first_center + glm::vec2(index));
  return CubicStencil{glm::ivec2(glm::floor(center)), glm::ivec2(towards_), at - glm::vec2(index)};
}

/// Draws the triangle's two far corners in until both lie on the disc.
void SmoothRegion::moveOntoDisc(glm::vec2 first_center, glm::ivec2& index) const {
  const auto isOnDisc = [&](glm::ivec2 texel) {
    const glm::vec2 center = first_center + glm::vec2(texel);
    return glm::dot(center, center) <= side_ * side_ / 4.0f;
  };
  for (;;) {
    if (!isOnDisc(index + glm::ivec2(3, 0)))
      --index.x;
    else if (!isOnDisc(index + glm::ivec2(0, 3)))
      --index.y;
    else
      return;
  }
}

}  // namespace mirrorball
