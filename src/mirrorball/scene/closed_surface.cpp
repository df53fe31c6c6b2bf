#include "mirrorball/scene/closed_surface.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/box.h"

namespace mirrorball {
namespace {

/// A number whose bits all depend on all of `bits` (the finalizer of SplitMix64; Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// The same for the same place.
std::uint64_t hashOf(glm::vec3 place) {
  place += 0.0f;  // −0 is 0
  std::array<std::uint32_t, 3> bits;
  std::memcpy(bits.data(), &place.x, sizeof bits);
  return mixed(mixed((std::uint64_t{bits[0]} << 32) | bits[1]) + bits[2]);
}

/// Opposite numbers for the two directions of an edge, modulo 2⁶⁴.
std::uint64_t hashOfEdge(std::uint64_t from, std::uint64_t to) {
  if (from == to) return 0;
  return from < to ? mixed(from + mixed(to)) : -mixed(to + mixed(from));
}

}  // namespace

// The border is empty if and only if the directed edges cancel out. Their hashes then sum to 0, in any order; if they
// do not cancel out, the sum is as good as random.
bool isClosed(const Mesh& mesh) {
  std::atomic<std::uint64_t> sum = 0;
  parallelFor(mesh.indices.size() / 3, 1 << 14, [&](std::size_t begin, std::size_t end) {
    std::uint64_t of_piece = 0;
    for (std::size_t triangle = begin; triangle < end; ++triangle) {
      const auto corner = [&](std::size_t i) { return hashOf(mesh.vertices[mesh.indices[3 * triangle + i]].position); };
      const std::uint64_t a = corner(0), b = corner(1), c = corner(2);
      of_piece += hashOfEdge(a, b) + hashOfEdge(b, c) + hashOfEdge(c, a);
    }
    sum += of_piece;
  });
  return sum == 0;
}

bool isBall(const Mesh& mesh) {
  constexpr float kOff = 1e-4f;
  constexpr float kLeastMiddle = 0.97f;  // of triangles whose edges are up to 0.4 long
  Box box;
  for (const Vertex& vertex : mesh.vertices) box.include({vertex.position, vertex.position});
  const glm::vec3 middle = box.center();
  const float radius = (box.high.x - box.low.x) / 2.0f;
  if (mesh.indices.empty() || !(radius > 0.0f)) return false;
  const auto place = [&](std::size_t corner) { return mesh.vertices[mesh.indices[corner]].position - middle; };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t corner = i; corner < i + 3; ++corner)
      if (!(std::abs(glm::length(place(corner)) - radius) <= kOff * radius)) return false;
    const glm::vec3 middle_of_three = place(i) + place(i + 1) + place(i + 2);
    if (glm::length(middle_of_three) < 3.0f * kLeastMiddle * radius) return false;
    const glm::vec3 normal = glm::cross(place(i + 1) - place(i), place(i + 2) - place(i));
    if (glm::dot(normal, middle_of_three) < 0.0f) return false;  // a hollow ball is seen from inside
  }
  return true;
}

bool facesInwards(const Mesh& mesh) {
  if (mesh.indices.empty()) return false;
  // The sum of the tetrahedra between one place and the triangles, which count as negative where they face it.
  const glm::dvec3 apex(mesh.vertices[mesh.indices[0]].position);
  double volume = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position) - apex; };
    volume += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
  }
  return volume < 0.0 && isClosed(mesh);
}

std::vector<std::string> openBodies(const Scene& scene) {
  std::vector<std::size_t> bodies(scene.materials.size(), 0), open(scene.materials.size(), 0);
  for (const Mesh& mesh : scene.meshes) {
    const auto material = static_cast<std::size_t>(mesh.material);
    if (!isBody(scene.materials[material])) continue;
    ++bodies[material];
    if (!isClosed(mesh)) ++open[material];
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i] == 0) continue;
    const std::string& name = scene.materials[i].name;
    const std::string of_material =
        name.empty() ? "material " + std::to_string(i) : "the material '" + excerpt(name) + "'";
    const std::string surfaces = bodies[i] == 1 ? "the surface of " + of_material + " is"
                                                : std::to_string(open[i]) + " of " + std::to_string(bodies[i]) +
                                                      " surfaces of " + of_material + " are";
    lines.push_back(surfaces + " open, so light that enters there may never leave the body");
  }
  return lines;
}

}  // namespace mirrorball
