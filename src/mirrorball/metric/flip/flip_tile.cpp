#include "mirrorball/metric/flip/flip_tile.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "mirrorball/metric/flip/flip_color.h"

namespace mirrorball::flip {
namespace {

constexpr int kTileWidth = 256;
constexpr int kTileHeight = 64;

/// One channel of a part of a picture.
class Plane {
 public:
  Plane(int width, int height)
      : width_(std::size_t(width)), height_(height), values_(width_ * std::size_t(height), 0.0f) {}

  int width() const { return static_cast<int>(width_); }
  int height() const { return height_; }
  float* row(int y) { return values_.data() + std::size_t(y) * width_; }
  const float* row(int y) const { return values_.data() + std::size_t(y) * width_; }

 private:
  std::size_t width_;
  int height_;
  std::vector<float> values_;
};

/// The tile and what lies around it as far as filters reach, in the opponent colours.
struct Surroundings {
  Plane achromatic;
  Plane red_green;
  Plane blue_yellow;
};

Surroundings surroundingsOf(const Tile& tile, int radius, const Image& image,
                            const std::function<glm::vec3(glm::vec3)>& shown) {
  const int width = tile.width + 2 * radius;
  const int height = tile.height + 2 * radius;
  Surroundings around{Plane(width, height), Plane(width, height), Plane(width, height)};
  for (int y = 0; y < height; ++y) {
    const int row = std::clamp(tile.top - radius + y, 0, image.height() - 1);
    for (int x = 0; x < width; ++x) {
      const int column = std::clamp(tile.left - radius + x, 0, image.width() - 1);
      const glm::vec3 color = opponentFromRec709(shown(rgbAt(image, column, row)));
      around.achromatic.row(y)[x] = color.x;
      around.red_green.row(y)[x] = color.y;
      around.blue_yellow.row(y)[x] = color.z;
    }
  }
  return around;
}

/// Filters along x: the plane becomes narrower by the radius on both sides.
Plane filteredAlongX(const Plane& plane, int radius, const Filter& filter) {
  const int skipped = radius - static_cast<int>(filter.size() / 2);
  Plane filtered(plane.width() - 2 * radius, plane.height());
  for (int y = 0; y < plane.height(); ++y) {
    float* const result = filtered.row(y);
    const float* source = plane.row(y) + skipped;
    for (const float weight : filter) {
      for (int x = 0; x < filtered.width(); ++x) result[x] += weight * source[x];
      ++source;
    }
  }
  return filtered;
}

/// Filters along y: the plane becomes lower by the radius on both sides.
Plane filteredAlongY(const Plane& plane, int radius, const Filter& filter) {
  const int skipped = radius - static_cast<int>(filter.size() / 2);
  Plane filtered(plane.width(), plane.height() - 2 * radius);
  for (int y = 0; y < filtered.height(); ++y) {
    float* const result = filtered.row(y);
    int row = y + skipped;
    for (const float weight : filter) {
      const float* const source = plane.row(row++);
      for (int x = 0; x < filtered.width(); ++x) result[x] += weight * source[x];
    }
  }
  return filtered;
}

/// The achromatic channel in [0, 1], in which features are looked for.
Plane normalizedLuminance(const Plane& achromatic) {
  Plane normalized(achromatic.width(), achromatic.height());
  for (int y = 0; y < achromatic.height(); ++y)
    for (int x = 0; x < achromatic.width(); ++x)
      normalized.row(y)[x] = achromatic.row(y)[x] * (1.0f / 116.0f) + 16.0f / 116.0f;
  return normalized;
}

/// Section 4.1: what the eye resolves, as colours of the display.
void seeColors(const Filters& filters, const Surroundings& around, std::vector<SeenPixel>& seen) {
  const auto filtered = [radius = filters.radius()](const Plane& plane, const Filter& filter) {
    return filteredAlongY(filteredAlongX(plane, radius, filter), radius, filter);
  };
  const Plane achromatic = filtered(around.achromatic, filters.achromatic);
  const Plane red_green = filtered(around.red_green, filters.red_green);
  const Plane narrow = filtered(around.blue_yellow, filters.blue_yellow_narrow);
  const Plane wide = filtered(around.blue_yellow, filters.blue_yellow_wide);
  std::size_t pixel = 0;
  for (int y = 0; y < achromatic.height(); ++y)
    for (int x = 0; x < achromatic.width(); ++x) {
      const glm::vec3 opponent(achromatic.row(y)[x], red_green.row(y)[x], narrow.row(y)[x] + wide.row(y)[x]);
      seen[pixel++].lab = huntLab(glm::clamp(rec709FromOpponent(opponent), 0.0f, 1.0f));
    }
}

/// Section 4.2: derivatives along x and along y, each smoothed across.
void seeFeatures(const Filters& filters, const Surroundings& around, std::vector<SeenPixel>& seen) {
  const int radius = filters.radius();
  const Plane luminance = normalizedLuminance(around.achromatic);
  const Plane smooth = filteredAlongX(luminance, radius, filters.smooth);
  const Plane edge_x = filteredAlongY(filteredAlongX(luminance, radius, filters.edge), radius, filters.smooth);
  const Plane point_x = filteredAlongY(filteredAlongX(luminance, radius, filters.point), radius, filters.smooth);
  const Plane edge_y = filteredAlongY(smooth, radius, filters.edge);
  const Plane point_y = filteredAlongY(smooth, radius, filters.point);
  std::size_t pixel = 0;
  for (int y = 0; y < edge_x.height(); ++y)
    for (int x = 0; x < edge_x.width(); ++x) {
      seen[pixel].edge = glm::length(glm::vec2(edge_x.row(y)[x], edge_y.row(y)[x]));
      seen[pixel++].point = glm::length(glm::vec2(point_x.row(y)[x], point_y.row(y)[x]));
    }
}

}  // namespace

std::vector<Tile> tilesOf(int width, int height) {
  std::vector<Tile> tiles;
  for (int top = 0; top < height; top += kTileHeight)
    for (int left = 0; left < width; left += kTileWidth)
      tiles.push_back({left, top, std::min(kTileWidth, width - left), std::min(kTileHeight, height - top)});
  return tiles;
}

std::vector<SeenPixel> seenThrough(const Filters& filters, const Tile& tile, const Image& image,
                                   const std::function<glm::vec3(glm::vec3)>& shown) {
  const Surroundings around = surroundingsOf(tile, filters.radius(), image, shown);
  std::vector<SeenPixel> seen(std::size_t(tile.width) * std::size_t(tile.height));
  seeColors(filters, around, seen);
  seeFeatures(filters, around, seen);
  return seen;
}

}  // namespace mirrorball::flip
