#include "mirrorball/transfer/unwrap/chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>

#include "mirrorball/base/range.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/scene/equal_vertices.h"
#include "mirrorball/transfer/unwrap/flat_triangles.h"

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t kNone = ~0u;

/// cos 60°: how far from its chart's mean a triangle may be turned while the chart grows.
constexpr double kGrowingCosine = 0.5;

/// cos 75°: and in the end. What is turned so far is stretched by 3.9.
constexpr double kFinalCosine = 0.2588190;

struct Face {
  dvec3 cross{0.0};   ///< along the normal, twice as long as the area
  dvec3 normal{0.0};  ///< unit; 0 of a triangle without an area
  std::array<std::uint32_t, 3> neighbour{kNone, kNone, kNone};
};

/// Faces with their neighbours over edges at which just two meet.
std::vector<Face> facesOf(const Mesh& mesh) {
  const std::vector<std::uint32_t> firsts = firstAtPlace(mesh.vertices);
  std::vector<Face> faces(mesh.indices.size() / 3);
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> edges;  // ends, face, corner
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const auto index = [&](std::uint32_t k) { return firsts[mesh.indices[std::size_t{3} * i + k % 3]]; };
    const auto place = [&](std::uint32_t k) { return dvec3(mesh.vertices[index(k)].position); };
    faces[i].cross = glm::cross(place(1) - place(0), place(2) - place(0));
    if (const double length = glm::length(faces[i].cross); length > 0.0) faces[i].normal = faces[i].cross / length;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({index(k), index(k + 1)});
      edges.emplace_back(low, high, i, k);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[j]) &&
           std::get<1>(edges[i]) == std::get<1>(edges[j]);
  };
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (same(i, end)) ++end;
    if (end == i + 2) {
      const auto [low_a, high_a, face_a, corner_a] = edges[i];
      const auto [low_b, high_b, face_b, corner_b] = edges[i + 1];
      faces[face_a].neighbour[corner_a] = face_b;
      faces[face_b].neighbour[corner_b] = face_a;
    }
    i = end;
  }
  return faces;
}

class ChartGrowth {
 public:
  explicit ChartGrowth(const Mesh& mesh)
      : mesh_(mesh), faces_(facesOf(mesh)), is_taken_(faces_.size(), false), visit_(faces_.size(), 0) {}

  std::vector<Chart> charts() {
    std::vector<std::uint32_t> seeds(faces_.size());
    std::iota(seeds.begin(), seeds.end(), 0u);
    sortDownBy(seeds, [&](std::uint32_t i) { return glm::dot(faces_[i].cross, faces_[i].cross); });
    std::vector<Chart> charts;
    for (const std::uint32_t seed : seeds)
      while (!is_taken_[seed]) charts.push_back(flatPart(gather(seed)));
    return charts;
  }

 private:
  /// Faces about a seed, which is the first, that are turned nearly the same way.
  std::vector<std::uint32_t> gather(std::uint32_t seed) {
    ++round_;
    std::vector<std::uint32_t> members;
    dvec3 sum(0.0);
    // The least turned first; of equal ones the lowest number.
    std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
        candidates;
    candidates.emplace(0.0, seed);
    while (!candidates.empty()) {
      const std::uint32_t face = candidates.top().second;
      candidates.pop();
      if (visit_[face] == round_ || !isTurnedAs(sum, face, kGrowingCosine)) continue;
      visit_[face] = round_;
      members.push_back(face);
      sum += faces_[face].cross;
      for (const std::uint32_t beyond : faces_[face].neighbour)
        if (beyond != kNone && !is_taken_[beyond] && visit_[beyond] != round_)
          candidates.emplace(1.0 - glm::dot(faces_[beyond].normal, unitOf(sum)), beyond);
    }
    return members;
  }

  static dvec3 unitOf(dvec3 sum) {
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : dvec3(0.0);
  }

  bool isTurnedAs(dvec3 sum, std::uint32_t face, double least_cosine) const {
    const dvec3 normal = faces_[face].normal;
    if (normal == dvec3(0.0) || sum == dvec3(0.0)) return true;
    return glm::dot(normal, unitOf(sum)) >= least_cosine;
  }

  /// Of the gathered faces those that lie side by side when they are seen along their mean normal, joined to the seed.
  Chart flatPart(const std::vector<std::uint32_t>& members) {
    dvec3 sum(0.0);
    for (const std::uint32_t face : members) sum += faces_[face].cross;
    // The seed is the largest and fits any chart that began with it.
    if (!isTurnedAs(sum, members[0], kFinalCosine)) sum = faces_[members[0]].cross;
    const Frame frame(sum == dvec3(0.0) ? glm::vec3(0, 0, 1) : glm::vec3(unitOf(sum)));
    ++round_;
    for (const std::uint32_t face : members) visit_[face] = round_;  // may be joined

    Chart chart;
    FlatTriangles flat(members.size());
    std::queue<std::uint32_t> next;
    const auto consider = [&](std::uint32_t face) {
      if (face == kNone || visit_[face] != round_ || is_taken_[face]) return;
      const std::array<dvec2, 3> corners = seenAlong(frame, face);
      visit_[face] = 0;
      const bool fits = chart.triangles.empty() || (isTurnedAs(sum, face, kFinalCosine) && !flat.overlaps(corners));
      if (!fits) return;
      is_taken_[face] = true;
      flat.add(corners);
      chart.triangles.push_back(face);
      chart.corners.push_back(corners);
      next.push(face);
    };
    flat.setCell(std::sqrt(0.5 * glm::length(sum) / double(members.size())));
    for (consider(members[0]); !next.empty(); next.pop())
      for (const std::uint32_t beyond : faces_[next.front()].neighbour) consider(beyond);
    return chart;
  }

  std::array<dvec2, 3> seenAlong(const Frame& frame, std::uint32_t face) const {
    std::array<dvec2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 place(mesh_.vertices[mesh_.indices[std::size_t{3} * face + k]].position);
      corners[k] = {glm::dot(place, dvec3(frame.t)), glm::dot(place, dvec3(frame.b))};
    }
    return corners;
  }

  const Mesh& mesh_;
  std::vector<Face> faces_;
  std::vector<bool> is_taken_;
  std::vector<std::uint32_t> visit_;  ///< the last round in which a face was met
  std::uint32_t round_ = 0;
};

struct Box {
  dvec2 low{std::numeric_limits<double>::infinity()};
  dvec2 high{-std::numeric_limits<double>::infinity()};
};

Box boxOf(const Chart& chart, dvec2 turn) {
  Box box;
  for (const auto& corners : chart.corners)
    for (const dvec2 p : corners) {
      const dvec2 turned(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
      box.low = glm::min(box.low, turned);
      box.high = glm::max(box.high, turned);
    }
  return box;
}

}  // namespace

std::vector<Chart> chartsOf(const Mesh& mesh) { return ChartGrowth(mesh).charts(); }

void turnUpright(Chart& chart) {
  constexpr int kTurns = 64;  // in half a turn
  dvec2 best(1.0, 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTurns; ++i) {
    const double angle = std::numbers::pi * i / kTurns;
    const dvec2 turn(std::cos(angle), std::sin(angle));
    const Box box = boxOf(chart, turn);
    const dvec2 side = box.high - box.low;
    if (side.x > side.y || side.x * side.y >= least) continue;
    least = side.x * side.y;
    best = turn;
  }
  const Box box = boxOf(chart, best);
  for (auto& corners : chart.corners)
    for (dvec2& p : corners) p = dvec2(best.x * p.x - best.y * p.y, best.y * p.x + best.x * p.y) - box.low;
}

}  // namespace mirrorball
