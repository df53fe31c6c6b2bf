#include "mirrorball/scene/mesh_file/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/glm.hpp>

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;
using Triangle = std::array<std::uint32_t, 3>;

/// Twice the polygon's area along its normal (Newell's method: exact for any plane polygon, sensible for a bent one).
dvec3 areaVector(std::span<const glm::vec3> corners) {
  dvec3 sum(0.0);
  const dvec3 origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += glm::cross(dvec3(corners[i]) - origin, dvec3(corners[(i + 1) % corners.size()]) - origin);
  return sum;
}

/// Corners as they are seen along the polygon's normal, from where it is wound counter-clockwise.
///
/// normal   of a length near 1: its third power must be a double
std::vector<dvec2> seenAlong(dvec3 normal, std::span<const glm::vec3> corners) {
  // The axis that the normal is farthest from makes the frame; of a polygon in a plane of axes it is of axes too.
  const dvec3 size = glm::abs(normal);
  const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                     : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                          : dvec3(0, 0, 1);
  const dvec3 across = glm::cross(axis, normal);
  const dvec3 up = glm::cross(normal, across);
  const double across_length = glm::length(across);
  const double up_length = glm::length(up);
  std::vector<dvec2> seen;
  seen.reserve(corners.size());
  for (const glm::vec3& corner : corners)
    seen.emplace_back(glm::dot(dvec3(corner), across) / across_length, glm::dot(dvec3(corner), up) / up_length);
  return seen;
}

/// Twice the area of a triangle; positive where it is wound counter-clockwise.
double turn(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x); }

/// Whether a point lies in a triangle that is wound counter-clockwise, or on its edge.
bool contains(dvec2 a, dvec2 b, dvec2 c, dvec2 point) {
  return turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
}

/// Corners of a polygon, and which of them lie in a triangle, by a grid of square cells: its columns go along the
/// longer side of the corners' box, so that corners on a straight line are apart in it, too.
class CornerGrid {
 public:
  CornerGrid(const std::vector<dvec2>& corners, std::vector<std::uint32_t> held)
      : corners_(corners), held_(std::move(held)), place_(corners.size(), kNone) {
    dvec2 high(std::numeric_limits<double>::lowest());
    low_ = -high;
    for (std::size_t i = 0; i < held_.size(); ++i) {
      place_[held_[i]] = i;
      low_ = glm::min(low_, corners_[held_[i]]);
      high = glm::max(high, corners_[held_[i]]);
    }
    if (!held_.empty()) shape(high - low_);
    // Each is one place behind its own until its cell is filled: what counts up to the cell's end is the next one's.
    first_in_cell_.assign(columns_ * rows_ + 2, 0);
    for (const std::uint32_t corner : held_) ++first_in_cell_[cellHolding(corner) + 2];
    std::partial_sum(first_in_cell_.begin(), first_in_cell_.end(), first_in_cell_.begin());
    in_cells_.resize(held_.size());
    for (const std::uint32_t corner : held_) in_cells_[first_in_cell_[cellHolding(corner) + 1]++] = corner;
    next_held_.resize(held_.size() + 1);
    std::iota(next_held_.begin(), next_held_.end(), std::size_t{0});
  }

  void remove(std::uint32_t corner) {
    const std::size_t place = std::exchange(place_[corner], kNone);
    if (place == kNone) return;
    held_[place] = held_.back();
    if (held_[place] != corner) place_[held_[place]] = place;
    held_.pop_back();
  }

  /// Whether a condition holds of a corner that is held and lies in a triangle; others that are held may be asked, too.
  ///
  /// steps   is raised by what it costs
  template <typename Condition>
  bool any(std::array<dvec2, 3> triangle, const Condition& holds, std::uint64_t& steps) {
    for (dvec2& corner : triangle) corner = inCells(corner);
    const double bottom = std::min({triangle[0].y, triangle[1].y, triangle[2].y});
    const double top = std::max({triangle[0].y, triangle[1].y, triangle[2].y});
    const std::size_t first = clampedIndex(bottom - kMargin, rows_),
                      last = std::max(first, clampedIndex(top + kMargin, rows_));
    if (held_.size() <= last - first + 1) {
      steps += held_.size();
      return std::any_of(held_.begin(), held_.end(), holds);
    }
    for (std::size_t row = first; row <= last; ++row) {
      const auto [left, right] = reachInRow(triangle, static_cast<double>(row));
      const std::size_t begin = first_in_cell_[row * columns_ + clampedIndex(left - kMargin, columns_)];
      const std::size_t end = first_in_cell_[row * columns_ + clampedIndex(right + kMargin, columns_) + 1];
      ++steps;
      for (std::size_t i = firstHeld(begin); i < end; i = firstHeld(i + 1), ++steps)
        if (holds(in_cells_[i])) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  static constexpr double kMargin = 1e-6;  // of a cell, for what is rounded

  /// The first corner of in_cells_ from a place on that is still held. What is passed over once is stepped over later.
  std::size_t firstHeld(std::size_t at) {
    while (at < in_cells_.size() && place_[in_cells_[at]] == kNone) {
      const std::size_t next = std::max(next_held_[at], at + 1);
      at = next_held_[at] = std::max(next, next_held_[next]);
    }
    return at;
  }

  /// Lays about as many cells as corners into a box of that size.
  void shape(dvec2 size) {
    longer_ = size.y > size.x ? 1 : 0;
    const double longer = size[longer_], shorter = size[1 - longer_];
    const auto count = static_cast<double>(held_.size());
    const double cell = std::max(std::sqrt(longer * shorter / count), longer / count);
    if (!(cell > 0.0) || !std::isfinite(cell) || !std::isfinite(1.0 / cell)) return;
    cells_per_unit_ = 1.0 / cell;
    columns_ = static_cast<std::size_t>(std::min(longer / cell, count)) + 1;
    rows_ = static_cast<std::size_t>(std::min(shorter / cell, count)) + 1;
  }

  /// A place in cells along and across the longer side.
  dvec2 inCells(dvec2 point) const {
    const dvec2 cells = (point - low_) * cells_per_unit_;
    return {cells[longer_], cells[1 - longer_]};
  }

  static std::size_t clampedIndex(double cells, std::size_t count) {
    return cells > 0.0 ? static_cast<std::size_t>(std::min(cells, static_cast<double>(count - 1))) : 0;
  }

  std::size_t cellHolding(std::uint32_t corner) const {
    const dvec2 cells = inCells(corners_[corner]);
    return clampedIndex(cells.y, rows_) * columns_ + clampedIndex(cells.x, columns_);
  }

  /// From where to where a triangle reaches in a row of cells.
  static std::pair<double, double> reachInRow(const std::array<dvec2, 3>& triangle, double row) {
    double left = std::numeric_limits<double>::max(), right = -left;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec2 from = triangle[i], along = triangle[(i + 1) % 3] - from;
      const bool is_level = along.y == 0.0;
      if (is_level && (from.y < row - kMargin || from.y > row + 1.0 + kMargin)) continue;
      const double enters = (row - kMargin - from.y) / along.y, leaves = (row + 1.0 + kMargin - from.y) / along.y;
      const double begin = is_level ? 0.0 : std::clamp(std::min(enters, leaves), 0.0, 1.0);
      const double end = is_level ? 1.0 : std::clamp(std::max(enters, leaves), 0.0, 1.0);
      // Where both ends were clamped to the same one, that corner lies outside of the row, and others decide.
      if (begin == end && along != dvec2(0.0)) continue;
      for (const double share : {begin, end}) {
        left = std::min(left, from.x + share * along.x);
        right = std::max(right, from.x + share * along.x);
      }
    }
    return {left, right};
  }

  const std::vector<dvec2>& corners_;
  std::vector<std::uint32_t> held_;
  std::vector<std::size_t> place_;  // of each corner in that list; kNone: it is not held
  dvec2 low_;
  int longer_ = 0;  // axis
  double cells_per_unit_ = 0.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::size_t> first_in_cell_;  // row by row, and the end of all
  std::vector<std::uint32_t> in_cells_;     // those that were held at first
  std::vector<std::size_t> next_held_;      // of in_cells_ and its end: before which place none is held any more
};

/// What is left of a polygon while ears are cut off.
///
/// Only corners that do not bend outwards can be the innermost of those within an ear, so only they are looked at; and
/// a cut changes nothing for corners but those beside it (Eberly, "Triangulation by Ear Clipping", 2002). So each
/// corner is compared with the inward ones near it three times, and not with all at each cut.
class Clipping {
 public:
  explicit Clipping(const std::vector<dvec2>& corners)
      : corners_(corners),
        size_(corners.size()),
        next_(size_),
        before_(size_),
        is_ear_(size_),
        inward_(corners, inwardCorners(corners)) {
    for (std::size_t i = 0; i < size_; ++i) {
      next_[i] = static_cast<std::uint32_t>(i + 1 == size_ ? 0 : i + 1);
      before_[next_[i]] = static_cast<std::uint32_t>(i);
    }
    for (std::uint32_t i = 0; i < corners_.size(); ++i) look(i);
  }

  std::size_t size() const { return size_; }
  std::uint32_t next(std::uint32_t corner) const { return next_[corner]; }
  bool isEar(std::uint32_t corner) const { return is_ear_[corner]; }
  /// Of all looks.
  std::uint64_t steps() const { return steps_; }
  /// Whether they were too many: no more ears are found.
  bool gaveUp() const { return steps_ > mostSteps(corners_.size()); }

  /// Takes an ear away.
  Triangle cut(std::uint32_t ear) {
    const std::uint32_t before = before_[ear], next = next_[ear];
    next_[before] = next;
    before_[next] = before;
    next_[ear] = ear;
    --size_;
    for (const std::uint32_t beside : {before, next}) {
      if (bendsOutwards(beside)) inward_.remove(beside);
      look(beside);
    }
    return {before, ear, next};
  }

  /// The corners that are left, in order.
  std::vector<std::uint32_t> remaining() const {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < corners_.size(); ++i)
      if (next_[i] != i) left.push_back(i);
    return left;
  }

 private:
  static std::vector<std::uint32_t> inwardCorners(const std::vector<dvec2>& corners) {
    std::vector<std::uint32_t> inward;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec2 before = corners[(i == 0 ? corners.size() : i) - 1],
                  next = corners[i + 1 == corners.size() ? 0 : i + 1];
      if (!(turn(before, corners[i], next) > 0.0)) inward.push_back(static_cast<std::uint32_t>(i));
    }
    return inward;
  }

  bool bendsOutwards(std::uint32_t i) const {
    return turn(corners_[before_[i]], corners_[i], corners_[next_[i]]) > 0.0;
  }

  /// Finds out whether a corner can be cut off: it bends outwards, and no other corner lies inside.
  void look(std::uint32_t corner) {
    const dvec2 a = corners_[before_[corner]], b = corners_[corner], c = corners_[next_[corner]];
    const auto isInTheWay = [&](std::uint32_t index) {
      const dvec2 other = corners_[index];
      return other != a && other != b && other != c && contains(a, b, c, other);
    };
    is_ear_[corner] = !gaveUp() && bendsOutwards(corner) && !inward_.any({a, b, c}, isInTheWay, steps_);
  }

  const std::vector<dvec2>& corners_;
  std::size_t size_;                   // how many are left
  std::vector<std::uint32_t> next_;    // of each that is left; of others themselves
  std::vector<std::uint32_t> before_;  // of each that is left
  std::vector<bool> is_ear_;
  CornerGrid inward_;  // the corners that are left and do not bend outwards
  std::uint64_t steps_ = 0;
};

}  // namespace

std::vector<Triangle> triangulate(std::span<const glm::vec3> corners, TriangulationWork* work) {
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() - 2);
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);

  const dvec3 normal = areaVector(corners);
  const double area = glm::length(normal);
  TriangulationWork done;
  if (corners.size() > 3 && area > 0.0 && std::isfinite(area)) {
    // By a power of two, which rounds nothing.
    const std::vector<dvec2> seen = seenAlong(normal * std::scalbn(1.0, -std::ilogb(area)), corners);
    Clipping clipping(seen);
    // Starting at the second corner makes a convex polygon a fan about the first.
    std::uint32_t corner = 1;
    std::size_t refused = 0;
    while (clipping.size() > 3 && refused < clipping.size() && !clipping.gaveUp()) {
      const std::uint32_t next = clipping.next(corner);
      const bool is_ear = clipping.isEar(corner);
      refused = is_ear ? 0 : refused + 1;
      if (is_ear) triangles.push_back(clipping.cut(corner));
      corner = next;
    }
    left = clipping.remaining();
    done = {clipping.steps(), clipping.gaveUp() && left.size() > 3};
  }
  if (work != nullptr) *work = done;
  // The last triangle; for a polygon without ears (crossing itself, without area) a fan of what is left.
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

}  // namespace mirrorball
