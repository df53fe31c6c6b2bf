#include "mirrorball/scene/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "mirrorball/scene/equal_vertices.h"
#include "mirrorball/scene/mesh_file/corner_angle.h"

namespace mirrorball {
namespace {

using glm::dvec3;

constexpr std::uint32_t kNone = ~0u;

/// Some unit vector orthogonal to the unit vector `normal`.
dvec3 anyOrthogonal(dvec3 normal) {
  const dvec3 away = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(away, normal));
}

dvec3 across(dvec3 normal, dvec3 direction) { return direction - normal * glm::dot(normal, direction); }

/// The tangent where the rule gives none: its x axis, brought into the surface.
glm::vec4 tangentOfNothing(dvec3 normal, float side = -1.0f) {
  return glm::vec4(glm::vec3(unitOr(across(normal, dvec3(1, 0, 0)), anyOrthogonal(normal))), side);
}

/// For each vertex the first one that counts as the same.
std::vector<std::uint32_t> firstOfSame(const Mesh& mesh, int set) {
  return firstOfEqual(mesh.vertices, [set](const Vertex& vertex) {
    const glm::vec3 p = vertex.position;
    const glm::vec3 n = vertex.normal;
    const glm::vec2 uv = vertex.uv[set];
    return std::array{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
  });
}

struct Triangle {
  std::array<std::uint32_t, 3> vertex{};                        ///< the first of equal ones
  std::array<std::uint32_t, 3> neighbour{kNone, kNone, kNone};  ///< beyond the edge from corner k to k + 1
  std::array<std::uint32_t, 3> group{kNone, kNone, kNone};      ///< of the corners
  dvec3 along_u{0.0};                                           ///< unit
  bool reads_rightly = false;                                   ///< else its picture is mirrored
  bool follows = true;    ///< has no direction of its own, and takes that of whoever comes first
  bool is_sound = false;  ///< its corners are at three places
};

/// Solves edge = p_u · step.x + p_v · step.y; of p_u the direction is kept.
void setDirection(Triangle& triangle, const std::array<const Vertex*, 3>& corners, int set) {
  const glm::vec2 step1 = corners[1]->uv[set] - corners[0]->uv[set];
  const glm::vec2 step2 = corners[2]->uv[set] - corners[0]->uv[set];
  // In single precision, as in all programs that follow the rule: the same triangles are found to have no area.
  const float area = step1.x * step2.y - step1.y * step2.x;
  // v grows downwards, and a picture that reads rightly from outside has a negative area.
  triangle.reads_rightly = area < 0.0f;
  if (!(std::abs(area) > std::numeric_limits<float>::min())) return;
  const dvec3 edge1 = dvec3(corners[1]->position) - dvec3(corners[0]->position);
  const dvec3 edge2 = dvec3(corners[2]->position) - dvec3(corners[0]->position);
  const double side = area > 0.0f ? 1.0 : -1.0;
  const dvec3 growing_u = side * (edge1 * double(step2.y) - edge2 * double(step1.y));
  const dvec3 growing_v = side * (edge2 * double(step1.x) - edge1 * double(step2.x));
  triangle.along_u = unitOr(growing_u, dvec3(0.0));
  triangle.follows = growing_u == dvec3(0.0) || growing_v == dvec3(0.0);
}

std::vector<Triangle> trianglesOf(const Mesh& mesh, int set) {
  const std::vector<std::uint32_t> firsts = firstOfSame(mesh, set);
  std::vector<Triangle> triangles(mesh.indices.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle& triangle = triangles[i];
    std::array<const Vertex*, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.vertex[k] = firsts[mesh.indices[3 * i + k]];
      corners[k] = &mesh.vertices[triangle.vertex[k]];
    }
    triangle.is_sound = corners[0]->position != corners[1]->position && corners[1]->position != corners[2]->position &&
                        corners[2]->position != corners[0]->position;
    if (triangle.is_sound) setDirection(triangle, corners, set);
  }
  return triangles;
}

/// One side of a triangle, by its ends.
struct TangentEdge {
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::uint32_t corner;  ///< at which it begins

  auto order() const { return std::tie(low, high, triangle, corner); }
  bool sameEnds(const TangentEdge& other) const { return low == other.low && high == other.high; }
};

/// Finds who lies beyond each edge: of those that run the other way between the same two vertices, the first that has
/// no neighbour yet.
void joinNeighbours(std::vector<Triangle>& triangles) {
  std::vector<TangentEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t k = 0; triangles[i].is_sound && k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[i].vertex[k], triangles[i].vertex[(k + 1) % 3]);
      edges.push_back({low, high, i, k});
    }
  std::sort(edges.begin(), edges.end(),
            [](const TangentEdge& a, const TangentEdge& b) { return a.order() < b.order(); });
  const auto neighbour = [&](const TangentEdge& edge) -> std::uint32_t& {
    return triangles[edge.triangle].neighbour[edge.corner];
  };
  const auto begin = [&](const TangentEdge& edge) { return triangles[edge.triangle].vertex[edge.corner]; };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (neighbour(edges[i]) != kNone) continue;
    for (std::size_t j = i + 1; j < edges.size() && edges[j].sameEnds(edges[i]); ++j) {
      if (neighbour(edges[j]) != kNone || begin(edges[j]) == begin(edges[i])) continue;
      neighbour(edges[i]) = edges[j].triangle;
      neighbour(edges[j]) = edges[i].triangle;
      break;
    }
  }
}

/// The corners at a vertex that share a frame.
struct Group {
  dvec3 sum{0.0};  ///< of unit vectors along growing u, by angle
  bool reads_rightly = false;
};

/// Puts corners into groups.
class Grouping {
 public:
  Grouping(const Mesh& mesh, std::vector<Triangle>& triangles) : mesh_(mesh), triangles_(triangles) {}

  std::vector<Group> groups() {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
      for (std::size_t k = 0; !triangles_[i].follows && k < 3; ++k)
        if (triangles_[i].group[k] == kNone) gather(i, triangles_[i].vertex[k]);
    return std::move(groups_);
  }

 private:
  /// A new group about a vertex, of a triangle and all that are joined to it by edges at that vertex.
  void gather(std::uint32_t first, std::uint32_t vertex) {
    groups_.push_back({dvec3(0.0), triangles_[first].reads_rightly});
    // Depth first, what lies beyond the edge that begins at the vertex before the other: the order decides which way
    // those are turned that follow.
    pending_ = {first};
    while (!pending_.empty()) {
      const std::uint32_t index = pending_.back();
      pending_.pop_back();
      Triangle& triangle = triangles_[index];
      const auto k =
          std::size_t(std::find(triangle.vertex.begin(), triangle.vertex.end(), vertex) - triangle.vertex.begin());
      if (!join(triangle, k)) continue;
      for (const std::uint32_t beyond : {triangle.neighbour[(k + 2) % 3], triangle.neighbour[k]})
        if (beyond != kNone) pending_.push_back(beyond);
    }
  }

  /// Adds a corner to the last group if it fits and is in none.
  bool join(Triangle& triangle, std::size_t k) {
    Group& group = groups_.back();
    if (triangle.group[k] != kNone) return false;
    if (triangle.follows && std::count(triangle.group.begin(), triangle.group.end(), kNone) == 3)
      triangle.reads_rightly = group.reads_rightly;
    if (triangle.reads_rightly != group.reads_rightly) return false;
    triangle.group[k] = static_cast<std::uint32_t>(groups_.size() - 1);
    if (!triangle.follows) group.sum += directionAt(triangle, k);
    return true;
  }

  /// The triangle's direction across a corner's normal, as long as the angle there.
  dvec3 directionAt(const Triangle& triangle, std::size_t k) const {
    const dvec3 normal(mesh_.vertices[triangle.vertex[k]].normal);
    const auto place = [&](std::size_t corner) {
      const dvec3 position(mesh_.vertices[triangle.vertex[corner % 3]].position);
      return across(normal, position);
    };
    return angleAt(place(k), place(k + 1), place(k + 2)) * unitOr(across(normal, triangle.along_u), dvec3(0.0));
  }

  const Mesh& mesh_;
  std::vector<Triangle>& triangles_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> pending_;
};

glm::vec4 tangentOf(const Group& group, dvec3 normal) {
  const dvec3 tangent = unitOr(across(normal, group.sum), dvec3(0.0));
  if (tangent == dvec3(0.0)) return tangentOfNothing(normal);
  return glm::vec4(glm::vec3(tangent), group.reads_rightly ? 1.0f : -1.0f);
}

/// The group of each corner. Where a triangle has corners at one place, that of the first sound triangle at the vertex.
std::vector<std::uint32_t> groupOfCorners(const Mesh& mesh, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> of_vertex(mesh.vertices.size(), kNone);
  std::vector<bool> is_known(mesh.vertices.size(), false);
  for (const Triangle& triangle : triangles)
    for (std::size_t k = 0; triangle.is_sound && k < 3; ++k)
      if (const std::uint32_t vertex = triangle.vertex[k]; !is_known[vertex]) {
        is_known[vertex] = true;
        of_vertex[vertex] = triangle.group[k];
      }
  std::vector<std::uint32_t> groups;
  groups.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      groups.push_back(triangle.is_sound ? triangle.group[k] : of_vertex[triangle.vertex[k]]);
  return groups;
}

/// Gives a mesh's corners their tangents: the first to a vertex itself, others to copies of it.
class VertexSplitting {
 public:
  explicit VertexSplitting(Mesh& mesh)
      : mesh_(mesh), is_set_(mesh.vertices.size(), false), copy_(mesh.vertices.size(), kNone) {}

  void set(std::uint32_t& index, glm::vec4 tangent) {
    std::uint32_t vertex = index;
    if (!is_set_[vertex]) {
      is_set_[vertex] = true;
      mesh_.vertices[vertex].tangent = tangent;
    }
    while (mesh_.vertices[vertex].tangent != tangent) {
      if (copy_[vertex] == kNone) append(vertex, tangent);
      vertex = copy_[vertex];
    }
    index = vertex;
  }

 private:
  void append(std::uint32_t vertex, glm::vec4 tangent) {
    copy_[vertex] = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(Vertex(mesh_.vertices[vertex]));
    mesh_.vertices.back().tangent = tangent;
    copy_.push_back(kNone);
    is_set_.push_back(true);
  }

  Mesh& mesh_;
  std::vector<bool> is_set_;
  std::vector<std::uint32_t> copy_;  ///< of each vertex the next with another tangent
};

}  // namespace

void computeTangents(Mesh& mesh, int set) {
  for (Vertex& vertex : mesh.vertices) vertex.tangent = tangentOfNothing(vertex.normal, 1.0f);
  const auto is_at_first = [&](const Vertex& vertex) { return vertex.uv[set] == mesh.vertices[0].uv[set]; };
  if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_at_first)) return;

  std::vector<Triangle> triangles = trianglesOf(mesh, set);
  joinNeighbours(triangles);
  const std::vector<Group> groups = Grouping(mesh, triangles).groups();
  const std::vector<std::uint32_t> group_of_corner = groupOfCorners(mesh, triangles);
  VertexSplitting splitting(mesh);
  for (std::size_t corner = 0; corner < group_of_corner.size(); ++corner) {
    const dvec3 normal(mesh.vertices[mesh.indices[corner]].normal);
    const std::uint32_t group = group_of_corner[corner];
    splitting.set(mesh.indices[corner], group == kNone ? tangentOfNothing(normal) : tangentOf(groups[group], normal));
  }
}

}  // namespace mirrorball
