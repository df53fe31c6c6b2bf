#include "mirrorball/scene/relief/height_texture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

#include "formula/relief.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/maximum_pyramid.h"

namespace mirrorball {
namespace {

/// What makeSearchable takes for a texel at most, with the heights themselves: they, their opposites, and two pyramids,
/// of which one lacks its first level. What is kept is less.
constexpr std::uint64_t kBytesPerSearched = 16;

}  // namespace

formula::HeightMap heightMapOf(const HeightTexture& texture) {
  const glm::ivec2 size(texture.heights.width(), texture.heights.height());
  return {glm::vec2(size), texture.edges == MapEdges::tiled ? formula::kWrapRepeat : formula::kWrapClampToEdge,
          levelCount(std::max(size.x, size.y)) - 1};
}

Result<HeightTexture> heightTexture(Image heights, MapEdges edges) {
  HeightTexture texture{.heights = std::move(heights), .edges = edges};
  MIRRORBALL_TRY_VOID(makeSearchable(texture));
  return texture;
}

glm::ivec2 sizeOfPicture(const HeightTexture& texture) {
  const formula::HeightMap map = heightMapOf(texture);
  glm::ivec2 size(0);
  for (int level = 0; level <= map.last_level; ++level)
    size = glm::max(size, formula::placeOfLevel(map, level) + formula::sizeOfLevel(map, level));
  return size;
}

Result<void> makeSearchable(HeightTexture& texture) {
  if (!texture.picture.empty()) return {};
  const glm::ivec2 size = sizeOfPicture(texture);
  MIRRORBALL_TRY_VOID(checkMemory(texture.heights.texelCount() * kBytesPerSearched));
  MIRRORBALL_TRY(bounds, HeightBounds::make(texture.heights, texture.edges));
  MIRRORBALL_TRY(levels, maximumPyramid(texture.heights, texture.edges));
  texture.bounds = std::move(bounds);
  levels.at(0, 0) = Image();
  texture.picture = Image(size.x, size.y, 1);
  const formula::HeightMap map = heightMapOf(texture);
  for (int level = 0; level <= map.last_level; ++level) {
    const Image& image = level == 0 ? texture.heights : levels.at(level, 0);
    const glm::ivec2 place = formula::placeOfLevel(map, level);
    for (int y = 0; y < image.height(); ++y)
      std::copy(image.row(y).begin(), image.row(y).end(), texture.picture.texel(place.x, place.y + y));
  }
  return {};
}

Image turnedOver(Image heights) {
  for (float& height : heights.samples()) height = 1.0f - height;
  return heights;
}

Result<void> makeCones(HeightTexture& texture) {
  if (!texture.cones.empty()) return {};
  MIRRORBALL_TRY(cones, coneMap(texture.heights, ConeKind::conservative, texture.edges));
  texture.cones = std::move(cones);
  return {};
}

Result<void> makeHorizons(HeightTexture& texture) {
  if (!texture.horizons.slopes.empty()) return {};
  MIRRORBALL_TRY(horizons, horizonMap(texture.heights, texture.edges));
  texture.horizons = std::move(horizons);
  return {};
}

std::span<const std::string_view> builtinHeightNames() {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"orange", "brick", "cobbles", "weave", "hammered", "waves"});
  return kNames;
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
