#include "mirrorball/scene/animation/deformation.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "formula/tangent.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

using Basis = MeshDeformation::Basis;

constexpr std::size_t kVerticesAPiece = 4096;

void morph(const MeshDeformation& how, std::span<const float> weights, std::vector<Basis>& vertices) {
  for (std::size_t target = 0; target < std::min(weights.size(), how.targets.size()); ++target) {
    const float weight = weights[target];
    if (weight == 0.0f) continue;
    for (const MeshDeformation::Displacement& moved : how.targets[target]) {
      Basis& vertex = vertices[moved.vertex];
      vertex.position += weight * moved.position;
      vertex.normal += weight * moved.normal;
      vertex.tangent += weight * glm::vec4(moved.tangent, 0.0f);
    }
  }
}

/// The matrix that moves a vertex: the mean of its joints'.
glm::mat4 blended(const MeshDeformation& how, std::size_t vertex, std::span<const glm::mat4> joints) {
  glm::mat4 sum(0.0f);
  for (std::size_t i = how.first_influence[vertex]; i < how.first_influence[vertex + 1]; ++i)
    sum += how.influences[i].weight * joints[how.influences[i].joint];
  return sum;
}

/// Moves a vertex; returns whether that mirrors it.
bool move(const glm::mat4& matrix, Basis& vertex) {
  const glm::dmat3 axes(matrix);
  const glm::dmat3 cofactors(glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]), glm::cross(axes[0], axes[1]));
  const bool mirrors = glm::dot(axes[0], cofactors[0]) < 0.0;
  const glm::dvec3 normal = cofactors * glm::dvec3(vertex.normal);
  const double length = glm::length(normal);
  vertex.position = glm::vec3(matrix * glm::vec4(vertex.position, 1.0f));
  // What is scaled to a line or a point has no normal, and keeps the one that it had.
  if (length > 0.0) vertex.normal = glm::vec3((mirrors ? -1.0 : 1.0) / length * normal);
  vertex.tangent = glm::vec4(glm::vec3(axes * glm::dvec3(vertex.tangent)), vertex.tangent.w);
  return mirrors;
}

/// Gives each triangle its own normal, where it has an area.
void flatten(std::vector<Basis>& vertices, bool mirrored) {
  for (std::size_t first = 0; first + 2 < vertices.size(); first += 3) {
    const glm::dvec3 origin(vertices[first].position);
    const glm::dvec3 normal = glm::cross(glm::dvec3(vertices[first + 1].position) - origin,
                                         glm::dvec3(vertices[first + 2].position) - origin);
    const double length = glm::length(normal);
    if (!(length > 0.0)) continue;
    for (std::size_t i = 0; i < 3; ++i)
      vertices[first + i].normal = glm::vec3((mirrored ? -1.0 : 1.0) / length * normal);
  }
}

/// Makes the normal a unit vector, and the tangent one across it.
void straighten(Basis& vertex, const Basis& before) {
  const auto unit = [](glm::vec3 of, glm::vec3 otherwise) {
    const float length = glm::length(of);
    return length > 0.0f && std::isfinite(length) ? of / length : otherwise;
  };
  vertex.normal = unit(vertex.normal, before.normal);
  const glm::vec3 tangent(vertex.tangent);
  const glm::vec3 across = tangent - glm::dot(tangent, vertex.normal) * vertex.normal;
  vertex.tangent = glm::vec4(unit(across, formula::anyTangent(vertex.normal)), before.tangent.w);
}

/// A place; what is no number, or larger than any, is as far away as one may be, where checkExtent (load_model.h)
/// refuses it.
glm::vec3 withinFloats(glm::vec3 place) {
  constexpr float kFarthest = 1e30f;
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(place[axis]) < kFarthest)) place[axis] = kFarthest;
  return place;
}

}  // namespace

std::size_t MeshDeformation::work() const {
  std::size_t work = vertices.size() + influences.size();
  for (const std::vector<Displacement>& target : targets) work += target.size();
  return work;
}

std::uint64_t MeshDeformation::size() const {
  std::uint64_t size = sizeof(MeshDeformation) + std::uint64_t{sizeof(Basis)} * vertices.size() +
                       std::uint64_t{sizeof(Influence)} * influences.size() +
                       std::uint64_t{sizeof(std::size_t)} * first_influence.size();
  for (const std::vector<Displacement>& target : targets)
    size += sizeof(target) + std::uint64_t{sizeof(Displacement)} * target.size();
  return size;
}

bool deform(const MeshDeformation& how, std::span<const float> weights, std::span<const glm::mat4> joints, Mesh& mesh) {
  std::vector<Basis> vertices = how.vertices;
  morph(how, weights, vertices);
  std::atomic<std::size_t> mirrored_vertices = 0;
  if (!joints.empty())
    parallelFor(vertices.size(), kVerticesAPiece, [&](std::size_t begin, std::size_t end) {
      std::size_t count = 0;
      for (std::size_t i = begin; i < end; ++i) count += move(blended(how, i, joints), vertices[i]) ? 1 : 0;
      mirrored_vertices += count;
    });
  const bool is_mirrored = 2 * mirrored_vertices > vertices.size();
  const bool is_bent =
      !joints.empty() || std::any_of(weights.begin(), weights.end(), [](float weight) { return weight != 0.0f; });
  if (is_bent && how.is_flat) flatten(vertices, is_mirrored);
  parallelFor(vertices.size(), kVerticesAPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (is_bent) straighten(vertices[i], how.vertices[i]);
      mesh.vertices[i].position = withinFloats(vertices[i].position);
      mesh.vertices[i].normal = vertices[i].normal;
      mesh.vertices[i].tangent = vertices[i].tangent;
    }
  });
  return is_mirrored;
}

}  // namespace mirrorball
