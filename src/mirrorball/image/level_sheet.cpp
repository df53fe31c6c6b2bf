#include "mirrorball/image/level_sheet.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace mirrorball {
namespace {

/// Where the upper left corner of each level comes.
std::vector<glm::ivec2> placesOf(std::span<const Image> levels) {
  const Image& first = levels.front();
  const bool is_below = 2 * first.width() > 3 * first.height();
  const int gap = std::max(std::min(first.width(), first.height()) / 64, 1);
  std::vector<glm::ivec2> places{{0, 0}};
  glm::ivec2 next = is_below ? glm::ivec2(0, first.height() + gap) : glm::ivec2(first.width() + gap, 0);
  for (const Image& level : levels.subspan(1)) {
    places.push_back(next);
    next += is_below ? glm::ivec2(level.width(), 0) : glm::ivec2(0, level.height());
  }
  return places;
}

}  // namespace

Image levelSheet(std::span<const Image> levels) {
  assert(!levels.empty());
  const std::vector<glm::ivec2> places = placesOf(levels);
  glm::ivec2 size(0);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const Image& image = levels[level];
    size = {std::max(size.x, places[level].x + image.width()), std::max(size.y, places[level].y + image.height())};
  }
  Image sheet(size.x, size.y, levels.front().channels());
  for (std::size_t level = 0; level < levels.size(); ++level)
    for (int y = 0; y < levels[level].height(); ++y) {
      const std::span<const float> row = levels[level].row(y);
      std::copy(row.begin(), row.end(), sheet.texel(places[level].x, places[level].y + y));
    }
  return sheet;
}

}  // namespace mirrorball
