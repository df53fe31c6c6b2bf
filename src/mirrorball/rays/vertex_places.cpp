#include "mirrorball/rays/vertex_places.h"

#include <array>
#include <cmath>

#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/equal_vertices.h"

namespace mirrorball {
namespace {

/// Of a triangle's corners, the place that lies between them; the part of the triangle that is nearer to this vertex
/// than to its other two.
constexpr float kFarthestAway = 1.0f / 3.0f;

glm::vec3 cornerOf(const Scene& scene, std::size_t instance, std::size_t index) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  return glm::vec3(scene.instances[instance].world_from_object *
                   glm::vec4(mesh.vertices[mesh.indices[index]].position, 1.0f));
}

bool hasArea(const std::array<glm::vec3, 3>& corners) {
  return unitOrNone(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) != glm::vec3(0.0f);
}

}  // namespace

std::array<glm::vec3, 3> cornersFrom(const Scene& scene, std::size_t instance, std::size_t index) {
  const std::size_t triangle = index / 3 * 3;
  return {cornerOf(scene, instance, index), cornerOf(scene, instance, triangle + (index + 1) % 3),
          cornerOf(scene, instance, triangle + (index + 2) % 3)};
}

VertexPlaces::VertexPlaces(const Scene& scene, std::span<const std::uint8_t> has_back)
    : scene_(scene), numbers_(scene.instances.size()) {
  first_.push_back(0);
  for (std::size_t instance = 0; instance < scene.instances.size(); ++instance) {
    const auto first_front = static_cast<std::uint32_t>(normals_.size());
    const auto first_back = static_cast<std::uint32_t>(fronts_.size());
    add(scene, instance);
    for (auto vertex = static_cast<std::uint32_t>(backs_.size()); vertex < normals_.size(); ++vertex) {
      backs_.push_back(vertex);
      if (has_back[instance] != 0) fronts_.push_back(vertex);
    }
    ranges_[0].push_back({first_front, static_cast<std::uint32_t>(normals_.size()) - first_front});
    ranges_[1].push_back({first_back, static_cast<std::uint32_t>(fronts_.size()) - first_back});
  }
  for (Range& range : ranges_[1]) range.first += static_cast<std::uint32_t>(normals_.size());
  for (std::size_t i = 0; i < fronts_.size(); ++i) backs_[fronts_[i]] = static_cast<std::uint32_t>(normals_.size() + i);
}

void VertexPlaces::add(const Scene& scene, std::size_t instance) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const glm::mat3 linear(scene.instances[instance].world_from_object);
  const glm::mat3 world_from_normal = glm::transpose(glm::inverse(linear));
  const std::vector<std::uint32_t> firsts = firstOfEqual(mesh.vertices, [](const Vertex& v) {
    return std::array{v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z};
  });
  std::vector<std::uint32_t>& numbers = numbers_[instance];
  numbers.resize(mesh.vertices.size());
  const auto first_number = static_cast<std::uint32_t>(normals_.size());
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    if (firsts[i] == i) {
      numbers[i] = static_cast<std::uint32_t>(normals_.size());
      normals_.push_back(unitOrNone(world_from_normal * mesh.vertices[i].normal));
    } else {
      numbers[i] = numbers[firsts[i]];
    }
  }
  // The corners of each vertex in a row, as a counting sort puts them.
  std::vector<std::uint32_t> counts(normals_.size() - first_number, 0);
  std::vector<bool> counts_triangle(mesh.indices.size() / 3);
  for (std::size_t i = 0; i / 3 < counts_triangle.size(); ++i) {
    if (i % 3 == 0) counts_triangle[i / 3] = hasArea(cornersFrom(scene, instance, i));
    if (counts_triangle[i / 3]) ++counts[numbers[mesh.indices[i]] - first_number];
  }
  std::vector<std::uint32_t> next;
  for (const std::uint32_t count : counts) {
    next.push_back(first_.back());
    first_.push_back(first_.back() + count);
  }
  corners_.resize(first_.back());
  for (std::size_t i = 0; i / 3 < counts_triangle.size(); ++i)
    if (counts_triangle[i / 3])
      corners_[next[numbers[mesh.indices[i]] - first_number]++] = {static_cast<std::uint32_t>(instance),
                                                                   static_cast<std::uint32_t>(i)};
}

glm::vec3 VertexPlaces::outwardNormal(std::size_t instance, std::size_t triangle, glm::vec3 geometric_normal) const {
  const Mesh& mesh = scene_.meshes[std::size_t(scene_.instances[instance].mesh)];
  glm::vec3 normals(0.0f);
  for (std::size_t i = 3 * triangle; i < 3 * triangle + 3; ++i)
    normals += normals_[vertexNumber(instance, mesh.indices[i])];
  return facingOutwards(geometric_normal, normals);
}

glm::vec3 VertexPlaces::position(std::size_t vertex) const {
  const std::size_t front = frontNumber(vertex);
  if (first_[front] == first_[front + 1]) return glm::vec3(NAN);
  const Corner& corner = corners_[first_[front]];
  return cornerOf(scene_, corner.instance, corner.index);
}

PlaceByVertex VertexPlaces::place(std::size_t vertex, std::size_t triangle, glm::vec2 away) const {
  const Corner& corner = corners_[first_[frontNumber(vertex)] + triangle];
  const auto [a, b, c] = cornersFrom(scene_, corner.instance, corner.index);
  const glm::vec2 weights = kFarthestAway * away;
  const glm::vec3 outwards =
      outwardNormal(corner.instance, corner.index / 3, directionOr(glm::cross(b - a, c - a), glm::vec3(0.0f)));
  return {a + weights.x * (b - a) + weights.y * (c - a), isBack(vertex) ? -outwards : outwards};
}

}  // namespace mirrorball
