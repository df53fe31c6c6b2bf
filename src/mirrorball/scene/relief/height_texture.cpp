#include "mirrorball/scene/relief/height_texture.h"

#include <cassert>
#include <utility>

#include "formula/relief.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/maximum_pyramid.h"

namespace mirrorball {

Result<HeightTexture> heightTexture(Image heights, MapEdges edges) {
  MIRRORBALL_TRY(levels, maximumPyramid(heights, edges));
  levels.at(0, 0) = std::move(heights);
  return HeightTexture{.levels = std::move(levels), .edges = edges};
}

Result<void> makeCones(HeightTexture& texture) {
  if (!texture.cones.empty()) return {};
  MIRRORBALL_TRY(cones, coneMap(texture.heights(), ConeKind::conservative, texture.edges));
  texture.cones = std::move(cones);
  return {};
}

HeightSize ownSize(HeightKind kind) {
  switch (kind) {
    case HeightKind::brick:
      return {0.03f, 2.0f};
    case HeightKind::cobbles:
      return {0.08f, 3.0f};
    case HeightKind::weave:
      return {0.02f, 4.0f};
    case HeightKind::hammered:
      return {0.02f, 3.0f};
    case HeightKind::waves:
      return {0.04f, 2.0f};
    case HeightKind::map:
      return {0.05f, 1.0f};
    case HeightKind::none:
    case HeightKind::orange:
      break;
  }
  return {0.01f, 12.0f};
}

Image builtinHeights(HeightKind kind, int side) {
  assert(kind != HeightKind::none && kind != HeightKind::map);
  Image heights(side, side, 1);
  parallelFor(std::size_t(side), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int x = 0; x < side; ++x) {
        const int y = static_cast<int>(row);
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(side);
        heights.texel(x, y)[0] = formula::builtinHeight(static_cast<int>(kind), uv).z;
      }
  });
  return heights;
}

}  // namespace mirrorball
