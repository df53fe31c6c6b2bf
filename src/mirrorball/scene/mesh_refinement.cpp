#include "mirrorball/scene/mesh_refinement.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "mirrorball/scene/equal_vertices.h"

namespace mirrorball {
namespace {

Vertex between(const Vertex& a, const Vertex& b) {
  const auto mean = [](auto x, auto y) { return 0.5f * (x + y); };
  return {.position = mean(a.position, b.position),
          .normal = mean(a.normal, b.normal),
          .tangent = mean(a.tangent, b.tangent),
          .uv = {mean(a.uv[0], b.uv[0]), mean(a.uv[1], b.uv[1])},
          .color = mean(a.color, b.color)};
}

/// Two numbers without their order.
std::uint64_t edgeOf(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32u) | std::max(a, b);
}

/// The length of a triangle's edges; the first is that from its first corner to its second.
std::array<float, 3> edgeLengths(const Mesh& mesh, std::size_t triangle) {
  std::array<glm::vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.vertices[mesh.indices[3 * triangle + i]].position;
  return {glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
          glm::distance(corners[2], corners[0])};
}

/// The triangles that one with the middles of some of its edges falls into.
///
/// corners, middles   numbers of vertices; the first middle lies between the first and the second corner
std::vector<glm::uvec3> pieces(const std::array<std::uint32_t, 3>& corners,
                               const std::array<std::optional<std::uint32_t>, 3>& middles) {
  const auto count = std::count_if(middles.begin(), middles.end(), [](const auto& m) { return m.has_value(); });
  if (count == 0) return {{corners[0], corners[1], corners[2]}};
  if (count == 3)
    return {{corners[0], *middles[0], *middles[2]},
            {*middles[0], corners[1], *middles[1]},
            {*middles[2], *middles[1], corners[2]},
            {*middles[0], *middles[1], *middles[2]}};
  // Turned so that the first edge is cut and the last is not.
  std::size_t first = 0;
  while (!middles[first] || middles[(first + 2) % 3]) ++first;
  const auto at = [&](std::size_t i) { return (first + i) % 3; };
  const std::uint32_t a = corners[first], b = corners[at(1)], c = corners[at(2)], ab = *middles[first];
  if (count == 1) return {{a, ab, c}, {ab, b, c}};
  const std::uint32_t bc = *middles[at(1)];
  return {{ab, b, bc}, {a, ab, bc}, {a, bc, c}};
}

}  // namespace

void refine(Mesh& mesh, const MeshRefinement& refinement) {
  if (refinement.empty()) return;
  mesh.vertices.reserve(mesh.vertices.size() + refinement.parents.size());
  for (const glm::uvec2 parents : refinement.parents)
    mesh.vertices.push_back(between(mesh.vertices[parents.x], mesh.vertices[parents.y]));
  mesh.indices = refinement.indices;
}

MeshRefiner::MeshRefiner(Mesh mesh)
    : mesh_(std::move(mesh)),
      places_(firstAtPlace(mesh_.vertices)),
      next_place_(static_cast<std::uint32_t>(mesh_.vertices.size())) {}

std::vector<std::uint32_t> MeshRefiner::cut(std::span<const std::uint8_t> is_cut) {
  Middles middles;
  for (std::size_t triangle = 0; triangle < is_cut.size(); ++triangle) {
    if (is_cut[triangle] == 0) continue;
    const std::array<float, 3> lengths = edgeLengths(mesh_, triangle);
    const float longest = *std::max_element(lengths.begin(), lengths.end());
    for (std::size_t i = 0; i < 3; ++i)
      if (lengths[i] > 0.5f * longest) addMiddle(middles, triangle, i);
  }
  return cutAt(middles);
}

bool MeshRefiner::cutEdges(const std::function<bool(glm::vec3, glm::vec3)>& is_cut) {
  Middles middles;
  for (std::size_t triangle = 0; triangle < mesh_.indices.size() / 3; ++triangle)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto end = [&](std::size_t corner) {
        return mesh_.vertices[mesh_.indices[3 * triangle + corner % 3]].position;
      };
      if (is_cut(end(i), end(i + 1))) addMiddle(middles, triangle, i);
    }
  if (middles.empty()) return false;
  cutAt(middles);
  return true;
}

/// edge   the first is that from the triangle's first corner to its second
void MeshRefiner::addMiddle(Middles& middles, std::size_t triangle, std::size_t edge) {
  const std::uint32_t a = places_[mesh_.indices[3 * triangle + edge]];
  const std::uint32_t b = places_[mesh_.indices[3 * triangle + (edge + 1) % 3]];
  if (middles.emplace(edgeOf(a, b), next_place_).second) ++next_place_;
}

/// returns   of each new triangle the old one that it lies in
std::vector<std::uint32_t> MeshRefiner::cutAt(const Middles& middles) {
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of_middle;
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b) -> std::optional<std::uint32_t> {
    const auto place = middles.find(edgeOf(places_[a], places_[b]));
    if (place == middles.end()) return std::nullopt;
    const auto [entry, is_new] =
        vertex_of_middle.emplace(edgeOf(a, b), static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      mesh_.vertices.push_back(between(mesh_.vertices[a], mesh_.vertices[b]));
      places_.push_back(place->second);
      parents_.emplace_back(a, b);
    }
    return entry->second;
  };
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> lies_in;
  for (std::uint32_t triangle = 0; triangle < mesh_.indices.size() / 3; ++triangle) {
    std::array<std::uint32_t, 3> corners;
    std::copy_n(mesh_.indices.begin() + std::ptrdiff_t{3} * triangle, 3, corners.begin());
    for (const glm::uvec3 piece : pieces(corners, {middleOf(corners[0], corners[1]), middleOf(corners[1], corners[2]),
                                                   middleOf(corners[2], corners[0])})) {
      indices.insert(indices.end(), {piece.x, piece.y, piece.z});
      lies_in.push_back(triangle);
    }
  }
  mesh_.indices = std::move(indices);
  return lies_in;
}

MeshRefinement MeshRefiner::refinement() const {
  if (parents_.empty()) return {};
  return {.parents = parents_, .indices = mesh_.indices};
}

}  // namespace mirrorball
