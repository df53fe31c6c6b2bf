#include "mirrorball/transfer/unwrap/chart_packing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

using glm::dvec2;

/// A chart's outline by columns of texels, with half of the gutter around it.
struct Outline {
  std::vector<int> low;
  std::vector<int> high;
  int width() const { return static_cast<int>(low.size()); }
  int height() const { return high.empty() ? 0 : *std::max_element(high.begin(), high.end()); }
};

/// Widens the columns' ranges by what of the line from a to b lies in them.
void addLine(dvec2 a, dvec2 b, std::vector<dvec2>& ranges) {
  if (a.x > b.x) std::swap(a, b);
  const auto columnOf = [&](double x) { return std::size_t(std::clamp(x, 0.0, double(ranges.size() - 1))); };
  for (std::size_t column = columnOf(a.x); column <= columnOf(b.x); ++column) {
    const auto heightAt = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
    const bool is_upright = a.x == b.x;
    const double begin = is_upright ? a.y : heightAt(std::max(a.x, double(column)));
    const double end = is_upright ? b.y : heightAt(std::min(b.x, double(column) + 1.0));
    dvec2& range = ranges[column];
    range = {std::min({range.x, begin, end}), std::max({range.y, begin, end})};
  }
}

Outline outlineOf(const Chart& chart, double scale, int gutter) {
  double width = 0.0;
  for (const auto& corners : chart.corners)
    for (const dvec2 p : corners) width = std::max(width, p.x * scale);
  const int columns = static_cast<int>(std::floor(width)) + 1;
  std::vector<dvec2> ranges(std::size_t(columns), dvec2(1e30, -1e30));
  for (const auto& corners : chart.corners)
    for (std::size_t k = 0; k < 3; ++k) addLine(corners[k] * scale, corners[(k + 1) % 3] * scale, ranges);

  const int left = gutter / 2, right = gutter - left;
  Outline outline;
  for (int column = -left; column < columns + right; ++column) {
    dvec2 range(1e30, -1e30);
    for (int beside = std::max(column - right, 0); beside <= std::min(column + left, columns - 1); ++beside)
      range = {std::min(range.x, ranges[std::size_t(beside)].x), std::max(range.y, ranges[std::size_t(beside)].y)};
    outline.low.push_back(static_cast<int>(std::floor(range.x)));
    outline.high.push_back(static_cast<int>(std::floor(range.y)) + 1 + gutter);
  }
  return outline;
}

/// The skyline of what has fallen so far.
class Skyline {
 public:
  explicit Skyline(int size) : heights_(std::size_t(size), 0) {}

  /// Lets a chart fall where its top comes to lie lowest, of those places where it wastes least.
  ///
  /// returns  its lower left corner; nothing where it does not fit
  std::optional<glm::ivec2> drop(const Outline& outline) {
    const int size = static_cast<int>(heights_.size());
    std::optional<glm::ivec2> best;
    long least_waste = 0;
    const int height = outline.height();
    for (int x = 0; x + outline.width() <= size; ++x) {
      int y = 0;
      long sum = 0;
      for (int i = 0; i < outline.width(); ++i) {
        const int gap = heights_[std::size_t(x + i)] - outline.low[std::size_t(i)];
        y = std::max(y, gap);
        sum += gap;
      }
      const long waste = long(y) * outline.width() - sum;
      if (y + height > size || (best && (y > best->y || (y == best->y && waste >= least_waste)))) continue;
      best = {x, y};
      least_waste = waste;
    }
    for (int i = 0; best && i < outline.width(); ++i)
      heights_[std::size_t(best->x + i)] = best->y + outline.high[std::size_t(i)];
    return best;
  }

 private:
  std::vector<int> heights_;
};

std::vector<double> heightsOf(const std::vector<Chart>& charts) {
  std::vector<double> heights;
  for (const Chart& chart : charts) {
    double& height = heights.emplace_back(0.0);
    for (const auto& corners : chart.corners)
      for (const dvec2 p : corners) height = std::max(height, p.y);
  }
  return heights;
}

/// The numbers of charts, the tallest first.
std::vector<std::size_t> byHeight(const std::vector<double>& heights) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sortDownBy(order, [&](std::size_t i) { return heights[i]; });
  return order;
}

double areaOf(const std::vector<Chart>& charts) {
  double area = 0.0;
  for (const Chart& chart : charts)
    for (const auto& [a, b, c] : chart.corners) {
      const dvec2 edge1 = b - a, edge2 = c - a;
      area += 0.5 * std::abs(edge1.x * edge2.y - edge1.y * edge2.x);
    }
  return area;
}

}  // namespace

ChartPacking packCharts(const std::vector<Chart>& charts, int size, int gutter) {
  const std::vector<double> heights = heightsOf(charts);
  const std::vector<std::size_t> order = byHeight(heights);
  // From the scale at which they would fill all of the map, or the tallest its height, downwards.
  const double side = std::max(std::sqrt(areaOf(charts)), charts.empty() ? 0.0 : heights[order[0]]);
  double scale = side > 0.0 ? size / side : 1.0;
  constexpr int kMostScales = 60;
  for (int i = 0; i < kMostScales; ++i, scale *= i < 40 ? 0.97 : 0.7) {
    ChartPacking packing{scale, std::vector<dvec2>(charts.size())};
    Skyline skyline(size);
    const bool fits = std::all_of(order.begin(), order.end(), [&](std::size_t chart) {
      const auto corner = skyline.drop(outlineOf(charts[chart], scale, gutter));
      if (corner) packing.corner[chart] = dvec2(*corner + gutter / 2);
      return corner.has_value();
    });
    if (fits) return packing;
  }
  return {};
}

}  // namespace mirrorball
