#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/unit_vector.h"

namespace mirrorball {

/// A place of a triangle near one of its corners.
struct PlaceByVertex {
  glm::vec3 position{0.0f};          ///< world
  glm::vec3 geometric_normal{0.0f};  ///< world, unit: facingOutwards
};

/// 0 for what is no direction.
inline glm::vec3 unitOrNone(glm::vec3 n) {
  return hasPlainSquare(n) ? n / std::sqrt(glm::dot(n, n)) : directionOr(n, glm::vec3(0.0f));
}

/// A triangle's counter-clockwise normal, or the other one where the normals of its corners clearly face that way.
/// Those at a thin rim lie across it, and tell nothing.
///
/// geometric_normal   unit
/// normals            the sum of three unit ones
inline glm::vec3 facingOutwards(glm::vec3 geometric_normal, glm::vec3 normals) {
  return glm::dot(geometric_normal, normals) < -0.6f ? -geometric_normal : geometric_normal;
}

/// The three corners of a triangle from one of them on; world.
///
/// index   into the indices of the instance's mesh
std::array<glm::vec3, 3> cornersFrom(const Scene& scene, std::size_t instance, std::size_t index);

/// The vertices of a scene where its instances put them, those of one instance once that share place and normal, with
/// the triangles around each. What is true of a vertex is asked at places of these triangles: at the vertex itself,
/// where they meet, a fold counts as seen from neither side. The back of a vertex is a vertex of its own.
class VertexPlaces {
 public:
  /// has_back   of each instance, not 0: its vertices have backs
  VertexPlaces(const Scene& scene, std::span<const std::uint8_t> has_back);

  /// Numbers that follow each other.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  /// How many different vertices there are in all instances.
  std::size_t size() const { return normals_.size() + fronts_.size(); }
  /// World, unit; 0 where the vertex has none.
  glm::vec3 normal(std::size_t vertex) const {
    return isBack(vertex) ? -normals_[frontNumber(vertex)] : normals_[vertex];
  }
  /// World; not a number where it has no triangles.
  glm::vec3 position(std::size_t vertex) const;
  /// The numbers of an instance's vertices on one side: of the backs, none where they are those of the fronts.
  Range sideRange(std::size_t instance, bool is_back) const { return ranges_[is_back ? 1 : 0][instance]; }
  /// Triangles of some area around it.
  std::size_t triangles(std::size_t vertex) const {
    const std::size_t front = frontNumber(vertex);
    return first_[front + 1] - first_[front];
  }
  /// On one of its triangles.
  ///
  /// away     how far from the vertex, towards the two other corners; each in [0, 1]
  PlaceByVertex place(std::size_t vertex, std::size_t triangle, glm::vec2 away) const;

  /// The number of a mesh's vertex in an instance, on the side of its normal.
  std::uint32_t vertexNumber(std::size_t instance, std::uint32_t of_mesh) const { return numbers_[instance][of_mesh]; }
  /// That of its back; of a vertex that has none, its own.
  ///
  /// vertex   on the side of its normal
  std::uint32_t backNumber(std::uint32_t vertex) const { return backs_[vertex]; }
  /// A triangle's normal, as facingOutwards.
  ///
  /// geometric_normal   unit, on the counter-clockwise side
  glm::vec3 outwardNormal(std::size_t instance, std::size_t triangle, glm::vec3 geometric_normal) const;

 private:
  void add(const Scene& scene, std::size_t instance);
  bool isBack(std::size_t vertex) const { return vertex >= normals_.size(); }
  std::size_t frontNumber(std::size_t vertex) const {
    return isBack(vertex) ? fronts_[vertex - normals_.size()] : vertex;
  }

  struct Corner {
    std::uint32_t instance;
    std::uint32_t index;  ///< into the indices of its mesh
  };
  const Scene& scene_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // of each instance's vertices
  std::vector<glm::vec3> normals_;
  std::vector<std::uint32_t> first_;  // of each vertex's corners, and the end
  std::vector<Corner> corners_;
  std::array<std::vector<Range>, 2> ranges_;  // of each instance's fronts, and of its backs
  std::vector<std::uint32_t> backs_;          // of each vertex, backNumber
  std::vector<std::uint32_t> fronts_;         // of each back, its vertex
};

}  // namespace mirrorball
