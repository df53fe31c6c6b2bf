#include "mirrorball/photo/rim_votes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

constexpr int kMinRadius = 9;
constexpr int kMaxRadius = 26;
constexpr int kRadii = kMaxRadius - kMinRadius + 1;
constexpr float kWeakestEdge = 0.012f;  // change of brightness a pixel
constexpr std::size_t kMaxCandidates = 12;
// Centres may lie beyond the border where the ball is cut.
constexpr int kBorder = 6;

float clampedAt(const Image& image, int x, int y) {
  return *image.texel(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
}

Image halved(const Image& image) {
  Image half(std::max(1, image.width() / 2), std::max(1, image.height() / 2), 1);
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      *half.texel(x, y) = 0.25f * (clampedAt(image, 2 * x, 2 * y) + clampedAt(image, 2 * x + 1, 2 * y) +
                                   clampedAt(image, 2 * x, 2 * y + 1) + clampedAt(image, 2 * x + 1, 2 * y + 1));
  return half;
}

/// Scharr's 1997 gradient, whose direction is right within a degree.
glm::vec2 gradientAt(const Image& image, int x, int y) {
  const auto at = [&](int i, int j) { return clampedAt(image, x + i, y + j); };
  const float right = 3.0f * at(1, -1) + 10.0f * at(1, 0) + 3.0f * at(1, 1);
  const float left = 3.0f * at(-1, -1) + 10.0f * at(-1, 0) + 3.0f * at(-1, 1);
  const float below = 3.0f * at(-1, 1) + 10.0f * at(0, 1) + 3.0f * at(1, 1);
  const float above = 3.0f * at(-1, -1) + 10.0f * at(0, -1) + 3.0f * at(1, -1);
  return glm::vec2(right - left, below - above) / 32.0f;
}

struct Edge {
  glm::vec2 position;
  glm::vec2 across;  // unit
};

/// The pixels where the gradient is greater than at its two neighbours across the edge.
std::vector<Edge> edgesOf(const Image& grey) {
  const int width = grey.width();
  std::vector<glm::vec2> gradients(grey.texelCount());
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < width; ++x) gradients[std::size_t(y * width + x)] = gradientAt(grey, x, y);
  const auto strength = [&](int x, int y) { return glm::length(gradients[std::size_t(y * width + x)]); };
  std::vector<Edge> edges;
  for (int y = 1; y + 1 < grey.height(); ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const float here = strength(x, y);
      if (here < kWeakestEdge) continue;
      const glm::vec2 across = gradients[std::size_t(y * width + x)] / here;
      const glm::ivec2 step(glm::round(across));
      if (here < strength(x - step.x, y - step.y) || here <= strength(x + step.x, y + step.y)) continue;
      edges.push_back({glm::vec2(x, y) + 0.5f, across});
    }
  return edges;
}

/// Votes by centre and radius, one cell a pixel each.
class Votes {
 public:
  Votes(int width, int height)
      : width_(width + 2 * kBorder),
        height_(height + 2 * kBorder),
        cells_(std::size_t(width_ * height_ * kRadii), 0.0f) {}

  int width() const { return width_; }
  int height() const { return height_; }

  float at(int x, int y, int radius) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || radius < 0 || radius >= kRadii) return 0.0f;
    return cells_[std::size_t((radius * height_ + y) * width_ + x)];
  }

  void cast(const Edge& edge) {
    for (const float side : {-1.0f, 1.0f})
      for (int radius = 0; radius < kRadii; ++radius) {
        const glm::vec2 center =
            edge.position + side * static_cast<float>(radius + kMinRadius) * edge.across + static_cast<float>(kBorder);
        const glm::ivec2 cell(glm::floor(center));
        if (cell.x < 0 || cell.y < 0 || cell.x >= width_ || cell.y >= height_) continue;
        cells_[std::size_t((radius * height_ + cell.y) * width_ + cell.x)] += 1.0f;
      }
  }

  /// The mean of 3 × 3 × 3 cells, as a share of the rim: a full one has about 2πr edges.
  Votes smoothed() const {
    Votes result = *this;
    const auto row = std::size_t(width_), level = row * std::size_t(height_);
    // Votes are whole numbers, so that their sums are exact in any order.
    for (const auto& [step, count] :
         {std::pair(std::size_t{1}, row), std::pair(row, level), std::pair(level, result.cells_.size())})
      addNeighbours(result.cells_, step, count);
    for (std::size_t cell = 0; cell < result.cells_.size(); ++cell)
      result.cells_[cell] /= glm::two_pi<float>() * static_cast<float>(int(cell / level) + kMinRadius);
    return result;
  }

 private:
  /// Adds to each cell those `step` before and behind it, where they are in the same stretch of `count` cells.
  static void addNeighbours(std::vector<float>& cells, std::size_t step, std::size_t count) {
    const std::vector<float> before = cells;
    for (std::size_t begin = 0; begin < cells.size(); begin += count) {
      for (std::size_t i = begin + step; i < begin + count; ++i) cells[i] += before[i - step];
      for (std::size_t i = begin; i + step < begin + count; ++i) cells[i] += before[i + step];
    }
  }

  int width_;
  int height_;
  std::vector<float> cells_;
};

struct VotedRim {
  Circle circle;
  float share;
};

/// The cells that have more than the 26 around them, the best first.
std::vector<VotedRim> peaksOf(const Votes& votes) {
  std::vector<VotedRim> peaks;
  const auto isPeak = [&](int x, int y, int radius) {
    const float here = votes.at(x, y, radius);
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          if (votes.at(x + i, y + j, radius + k) > here) return false;
    return true;
  };
  for (int radius = 0; radius < kRadii; ++radius)
    for (int y = 0; y < votes.height(); ++y)
      for (int x = 0; x < votes.width(); ++x) {
        const float share = votes.at(x, y, radius);
        if (share < 0.25f || !isPeak(x, y, radius)) continue;
        peaks.push_back({{glm::dvec2(x, y) + 0.5 - double(kBorder), double(radius + kMinRadius)}, share});
      }
  sortDownBy(peaks, &VotedRim::share);
  peaks.resize(std::min(peaks.size(), kMaxCandidates));
  return peaks;
}

}  // namespace

std::vector<Circle> voteForCircles(const Image& grey) {
  std::vector<Circle> circles;
  Image level = grey;
  for (double scale = 1.0; std::max(level.width(), level.height()) >= kMinRadius; scale *= 2.0) {
    Votes votes(level.width(), level.height());
    for (const Edge& edge : edgesOf(level)) votes.cast(edge);
    for (const VotedRim& peak : peaksOf(votes.smoothed()))
      circles.push_back({peak.circle.center_px * scale, peak.circle.radius_px * scale});
    if (std::min(level.width(), level.height()) <= kMinRadius) break;
    level = halved(level);
  }
  return circles;
}

}  // namespace mirrorball
