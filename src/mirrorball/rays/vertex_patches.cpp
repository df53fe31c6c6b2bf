#include "mirrorball/rays/vertex_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/frame.h"

namespace mirrorball {
namespace {

constexpr std::size_t kFewestPatches = 48;  // of one side of an instance
/// As far as a patch counts, in sizes of its cell: the middle of a cell is nearer than that from anywhere in it.
constexpr float kReach = 1.5f;
/// Both ends of the diagonal of a cell and what is reached from there.
constexpr float kFarthestNear = kReach + 1.7321f;
/// At most this many patches, the lowest numbers first.
constexpr std::size_t kMostNear = 64;
/// How much the plane through patches is held level, so that it is one where they lie in a line, too.
constexpr float kStiffness = 0.02f;

/// The vertices of one side of an instance: so many from the first on.
struct Side {
  std::size_t instance = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The most patches of a side with which all sides together have so many, but for the fewest.
std::size_t patchesOfSide(const std::vector<Side>& sides, std::size_t most) {
  const auto ofAll = [&](std::size_t of_side) {
    return std::accumulate(sides.begin(), sides.end(), std::size_t{0}, [&](std::size_t sum, const Side& side) {
      return sum + std::min<std::size_t>(side.count, of_side);
    });
  };
  std::size_t enough = kFewestPatches;
  std::size_t too_many = std::max(most, enough) + 1;
  while (enough + 1 < too_many) {
    const std::size_t middle = (enough + too_many) / 2;
    (ofAll(middle) <= most ? enough : too_many) = middle;
  }
  return enough;
}

/// Which vertices triangles connect: one number for all that are connected.
std::vector<std::uint32_t> connectedParts(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                          std::uint32_t vertices) {
  std::vector<std::uint32_t> parts(vertices);
  std::iota(parts.begin(), parts.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parts[v] != v) v = parts[v] = parts[parts[v]];
    return v;
  };
  for (const auto& [a, b, c] : triangles)
    for (const std::uint32_t other : {b, c}) {
      const std::uint32_t one = root(a), two = root(other);
      parts[std::max(one, two)] = std::min(one, two);
    }
  for (std::uint32_t v = 0; v < vertices; ++v) parts[v] = root(v);
  return parts;
}

/// Which of the six ways along the axes is nearest to a normal.
std::uint64_t facing(glm::vec3 n) {
  const glm::vec3 size = glm::abs(n);
  const int axis = size.x >= std::max(size.y, size.z) ? 0 : (size.y >= size.z ? 1 : 2);
  return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0.0f ? 1 : 0));
}

/// The vertices of a side, counted from its first, by the cells that they lie in.
struct SortedVertices {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_cell;
  float cell_size = 0.0f;  ///< 0: each vertex is alone

  std::size_t cells() const {
    std::size_t count = by_cell.empty() ? 0 : 1;
    for (std::size_t i = 1; i < by_cell.size(); ++i) count += by_cell[i].first != by_cell[i - 1].first ? 1 : 0;
    return count;
  }
};

SortedVertices eachAlone(std::uint32_t count) {
  SortedVertices sorted;
  for (std::uint32_t v = 0; v < count; ++v) sorted.by_cell.emplace_back(v, v);
  return sorted;
}

/// Sorts the vertices of a side into the cells of a grid.
class VertexGrid {
 public:
  VertexGrid(const VertexPlaces& places, const Side& side, std::vector<std::uint32_t> parts)
      : places_(places), side_(side), parts_(std::move(parts)) {
    for (std::uint32_t v = 0; v < side.count; ++v) {
      positions_.push_back(places.position(side.first + v));
      if (isFinite(positions_.back())) box_.include({positions_.back(), positions_.back()});
    }
  }

  SortedVertices sorted(std::size_t most) const;

 private:
  SortedVertices sortedBy(float along, bool by_parts) const;

  const VertexPlaces& places_;
  const Side& side_;
  std::vector<std::uint32_t> parts_;
  std::vector<glm::vec3> positions_;
  Box box_;
};

/// along   cells along the longest side of the box around all, up to 1023
SortedVertices VertexGrid::sortedBy(float along, bool by_parts) const {
  const glm::vec3 extent = box_.isEmpty() ? glm::vec3(0.0f) : box_.high - box_.low;
  SortedVertices sorted{.by_cell = {}, .cell_size = std::max({extent.x, extent.y, extent.z, 1e-30f}) / along};
  sorted.by_cell.reserve(side_.count);
  for (std::uint32_t v = 0; v < side_.count; ++v) {
    std::uint64_t key = by_parts ? parts_[v] : 0u;
    const glm::vec3 place = (positions_[v] - box_.low) / sorted.cell_size;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 10u | (isFinite(place) ? static_cast<std::uint64_t>(std::clamp(place[axis], 0.0f, 1023.0f)) : 0u);
    sorted.by_cell.emplace_back(key << 3u | facing(places_.normal(side_.first + v)), v);
  }
  std::sort(sorted.by_cell.begin(), sorted.by_cell.end());
  return sorted;
}

/// Into so many cells or somewhat fewer; where the connected parts alone are more, into cells that parts share.
SortedVertices VertexGrid::sorted(std::size_t most) const {
  SortedVertices fits = sortedBy(1.0f, true);
  const bool by_parts = fits.cells() <= most;
  if (!by_parts) fits = sortedBy(1.0f, false);
  // Each step comes nearer, as a surface has about the square of this in cells.
  constexpr int kMostSteps = 6;
  constexpr float kEnough = 0.75f;
  const auto wanted = static_cast<float>(most);
  float along = std::max(1.0f, std::sqrt(wanted / 3.0f));
  for (int step = 0; step < kMostSteps; ++step) {
    SortedVertices tried = sortedBy(along, by_parts);
    const auto cells = static_cast<float>(tried.cells());
    if (cells <= wanted && tried.cell_size < fits.cell_size) fits = std::move(tried);
    if (cells <= wanted && (cells >= kEnough * wanted || along == 1023.0f)) break;
    along = std::clamp(along * std::sqrt(0.9f * wanted / cells), 1.0f, 1023.0f);
  }
  return fits;
}

std::vector<Side> instanceSides(const Scene& scene, const VertexPlaces& places) {
  std::vector<Side> sides;
  for (const bool is_back : {false, true})
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const auto [first, count] = places.sideRange(i, is_back);
      if (count > 0) sides.push_back({i, first, count});
    }
  return sides;
}

void makeUnique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// How much a patch holds the plane at a vertex: less the farther away it is, above or below its tangent plane all the
/// more, and the more it is turned away.
///
/// place    in the vertex's frame, over what is reached
/// cosine   of their normals
float weightAt(glm::vec3 place, float cosine) {
  const float near = std::max(1.0f - glm::dot(place, place), 0.0f);
  const float beside = std::max(1.0f - 2.0f * std::abs(place.z), 0.0f);
  return near * near * beside * std::clamp((cosine - 0.3f) / 0.4f, 0.0f, 1.0f);
}

/// The triangles of an instance by the numbers of its vertices on one side, counted from that side's first.
std::vector<std::array<std::uint32_t, 3>> sideTriangles(const Scene& scene, const VertexPlaces& places,
                                                        const Side& side) {
  const std::uint32_t first_front = places.sideRange(side.instance, false).first;
  const std::vector<std::uint32_t>& indices = scene.meshes[std::size_t(scene.instances[side.instance].mesh)]->indices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    triangles.push_back({places.vertexNumber(side.instance, indices[i]) - first_front,
                         places.vertexNumber(side.instance, indices[i + 1]) - first_front,
                         places.vertexNumber(side.instance, indices[i + 2]) - first_front});
  return triangles;
}

}  // namespace

VertexPatches::VertexPatches(const Scene& scene, const VertexPlaces& places, std::size_t most)
    : places_(places), patches_(places.size()) {
  const std::vector<Side> sides = instanceSides(scene, places);
  const std::size_t of_side = patchesOfSide(sides, most);
  std::vector<SortedVertices> sorted(sides.size());
  parallelFor(sides.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sorted[i] =
          sides[i].count <= of_side
              ? eachAlone(sides[i].count)
              : VertexGrid(places, sides[i], connectedParts(sideTriangles(scene, places, sides[i]), sides[i].count))
                    .sorted(of_side);
  });
  std::vector<std::uint32_t> together;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& by_cell = sorted[i].by_cell;
    for (std::size_t begin = 0, end = 0; begin < by_cell.size(); begin = end) {
      together.clear();
      while (end < by_cell.size() && by_cell[end].first == by_cell[begin].first)
        together.push_back(sides[i].first + by_cell[end++].second);
      vertices_.add(together);
      addPatch(sorted[i].cell_size);
    }
  }
  findNeighbours(scene);
}

void VertexPatches::Lists::add(std::span<const std::uint32_t> list) {
  numbers.insert(numbers.end(), list.begin(), list.end());
  first.push_back(static_cast<std::uint32_t>(numbers.size()));
}

/// Of the last list of vertices.
void VertexPatches::addPatch(float cell_size) {
  const auto number = static_cast<std::uint32_t>(size());
  glm::vec3 center(0.0f), normal(0.0f);
  float weights = 0.0f;
  for (const std::uint32_t vertex : vertices_.of(number)) {
    patches_[vertex] = number;
    // Rays begin at all of its triangles alike.
    const auto weight = static_cast<float>(places_.triangles(vertex));
    if (weight > 0.0f) center += weight * places_.position(vertex);
    normal += places_.normal(vertex);
    weights += weight;
  }
  centers_.push_back(weights > 0.0f ? center / weights : center);
  normals_.push_back(unitOrNone(normal));
  sizes_.push_back(cell_size);
}

/// Patches whose triangles have no area know nothing, so they have no neighbours.
void VertexPatches::findNeighbours(const Scene& scene) {
  std::vector<std::uint8_t> has_area(size());
  for (std::uint32_t i = 0; i < has_area.size(); ++i) {
    const auto vertices = vertices_.of(i);
    has_area[i] =
        std::any_of(vertices.begin(), vertices.end(), [&](auto v) { return places_.triangles(v) > 0; }) ? 1 : 0;
  }
  std::vector<std::vector<std::uint32_t>> beside(size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (a != b && has_area[a] != 0 && has_area[b] != 0) beside[a].push_back(b);
  };
  for (const Side& side : instanceSides(scene, places_))
    for (const auto& triangle : sideTriangles(scene, places_, side))
      for (const std::uint32_t a : triangle)
        for (const std::uint32_t b : triangle) join(patch(side.first + a), patch(side.first + b));
  parallelFor(beside.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) makeUnique(beside[i]);
  });
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < beside.size(); ++i) {
    beside_.add(beside[i]);
    near.clear();
    if (sizes_[i] > 0.0f) {
      near.push_back(i);
      for (const std::uint32_t next : beside[i]) {
        near.push_back(next);
        // Those farther away count nowhere in the patch.
        const auto isInReach = [&](std::uint32_t other) {
          return glm::distance(centers_[i], centers_[other]) <= kFarthestNear * sizes_[i];
        };
        std::copy_if(beside[next].begin(), beside[next].end(), std::back_inserter(near), isInReach);
      }
      makeUnique(near);
    }
    near_.add(near);
  }
}

void VertexPatches::findWeights(std::size_t vertex, std::vector<PatchWeight>& found) const {
  found.clear();
  const std::uint32_t own = patches_[vertex];
  const Frame frame(places_.normal(vertex));
  const glm::vec3 position = places_.position(vertex);
  std::array<glm::vec2, kMostNear> places;
  float sum = 0.0f;
  glm::vec2 first_moment(0.0f);
  glm::mat2 second_moment(0.0f);
  for (const std::uint32_t patch : near_.of(own)) {
    if (found.size() == kMostNear) break;
    const glm::vec3 place = frame.toLocal(centers_[patch] - position) / (kReach * sizes_[patch]);
    const float weight = weightAt(place, glm::dot(frame.n, normals_[patch]));
    if (!(weight > 0.0f)) continue;
    const glm::vec2 along(place);
    places[found.size()] = along;
    found.push_back({patch, weight});
    sum += weight;
    first_moment += weight * along;
    second_moment += weight * glm::outerProduct(along, along);
  }
  if (found.empty()) {
    found.push_back({own, 1.0f});
    return;
  }
  second_moment += kStiffness * sum * glm::mat2(1.0f);
  const glm::vec2 slope = glm::inverse(second_moment) * first_moment;
  const float all = sum - glm::dot(slope, first_moment);
  for (std::size_t i = 0; i < found.size(); ++i) found[i].weight *= (1.0f - glm::dot(slope, places[i])) / all;
}

}  // namespace mirrorball
