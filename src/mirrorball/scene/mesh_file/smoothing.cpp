#include "mirrorball/scene/mesh_file/smoothing.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "mirrorball/scene/mesh_file/corner_angle.h"

namespace mirrorball {
namespace {

using glm::dvec3;

/// cos 45°: edges over which faces turn farther are sharp.
constexpr double kSharpCosine = 0.70710678118654752;

/// cos 170°: a face's own back, in files that have each face from both sides, is no continuation of it.
constexpr double kBackCosine = -0.985;

/// How many of the faces at one edge each of them is compared with.
constexpr std::size_t kMaxAtAnEdge = 8;

/// One edge of one face.
struct Edge {
  std::uint32_t low;  ///< its two positions, the lower index first
  std::uint32_t high;
  std::uint32_t corner_at_low;  ///< corners of its face there
  std::uint32_t corner_at_high;
  std::uint32_t face;
  bool is_upwards;  ///< the face has it from low to high

  auto key() const { return std::pair(low, high); }
};

/// The sets of corners that share a normal, by union and find (Tarjan 1975) with halved paths.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }

  /// The lower one stays, whatever the order: the result is the same for any.
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Newell's normal, of a polygon that need not be plane; unit, or 0 for a degenerate one.
dvec3 normalOf(std::span<const glm::vec3> positions, const PolygonFace& face) {
  dvec3 sum(0.0);
  const dvec3 origin(positions[face.corners[0]]);
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
    sum += glm::cross(dvec3(positions[face.corners[i]]) - origin, dvec3(positions[face.corners[i + 1]]) - origin);
  return unitOr(sum, dvec3(0.0));
}

std::vector<Edge> edgesOf(std::span<const PolygonFace> faces) {
  std::vector<Edge> edges;
  std::uint32_t first = 0;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const std::span<const std::uint32_t> corners = faces[face].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      Edge edge{corners[i],
                corners[next],
                first + static_cast<std::uint32_t>(i),
                first + static_cast<std::uint32_t>(next),
                static_cast<std::uint32_t>(face),
                corners[i] < corners[next]};
      if (!edge.is_upwards) {
        std::swap(edge.low, edge.high);
        std::swap(edge.corner_at_low, edge.corner_at_high);
      }
      if (faces[face].smoothing != kFlat && edge.low != edge.high) edges.push_back(edge);
    }
    first += static_cast<std::uint32_t>(corners.size());
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
  return edges;
}

}  // namespace

CornerNormals cornerNormals(std::span<const glm::vec3> positions, std::span<const PolygonFace> faces) {
  std::vector<dvec3> face_normals;
  std::size_t count = 0;
  for (const PolygonFace& face : faces) {
    face_normals.push_back(normalOf(positions, face));
    count += face.corners.size();
  }

  Sets sets(count);
  const std::vector<Edge> edges = edgesOf(faces);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& a = edges[i];
    for (std::size_t j = i + 1; j < std::min(i + kMaxAtAnEdge, edges.size()) && edges[j].key() == a.key(); ++j) {
      const Edge& b = edges[j];
      const int group = faces[a.face].smoothing;
      const double cosine = glm::dot(face_normals[a.face], face_normals[b.face]);
      const bool is_smooth = group == faces[b.face].smoothing && a.is_upwards != b.is_upwards &&
                             cosine > (group == kSmoothByAngle ? kSharpCosine : kBackCosine);
      if (!is_smooth) continue;
      sets.join(a.corner_at_low, b.corner_at_low);
      sets.join(a.corner_at_high, b.corner_at_high);
    }
  }

  std::vector<dvec3> sums(count, dvec3(0.0));
  std::uint32_t corner = 0;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const std::span<const std::uint32_t> corners = faces[face].corners;
    const auto place = [&](std::size_t i) { return dvec3(positions[corners[i % corners.size()]]); };
    for (std::size_t i = 0; i < corners.size(); ++i)
      sums[sets.find(corner++)] += angleAt(place(i), place(i + 1), place(i + corners.size() - 1)) * face_normals[face];
  }

  CornerNormals result;
  std::vector<std::uint32_t> normal_of_set(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t set = sets.find(i);
    if (set == i) {  // the lowest of its set, and so the first that is met
      normal_of_set[i] = static_cast<std::uint32_t>(result.normals.size());
      result.normals.emplace_back(unitOr(sums[i], dvec3(0, 0, 1)));
    }
    result.of_corner.push_back(normal_of_set[set]);
  }
  return result;
}

}  // namespace mirrorball
