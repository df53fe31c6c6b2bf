#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball::testing {

/// A body of glass.
inline Scene glassOf(Mesh mesh) {
  Material glass;
  glass.transmission = 1.0f;
  return meshScene(std::move(mesh), glass);
}

/// The volume inside a closed mesh, negative where it is turned inside out.
inline double signedVolume(const Mesh& mesh) {
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
    volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
  }
  return volume;
}

/// How many edges have no partner that runs the other way; vertices within about 1e-5 of each other count as one. A
/// closed surface of consistent orientation has none.
inline std::size_t openEdgeCount(const Mesh& mesh) {
  using Point = std::array<long, 3>;
  std::map<std::pair<Point, Point>, int> balance;
  const auto place = [&](std::uint32_t index) {
    const glm::vec3 scaled = glm::round(mesh.vertices[index].position * 65536.0f);
    return Point{static_cast<long>(scaled.x), static_cast<long>(scaled.y), static_cast<long>(scaled.z)};
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point from = place(mesh.indices[i + k]);
      const Point to = place(mesh.indices[i + (k + 1) % 3]);
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

inline void expectUnitBounds(const Scene& scene) {
  const BoundingSphere bounds = boundingSphere(scene);
  EXPECT_LT(glm::length(bounds.center), 1e-5f);
  EXPECT_NEAR(bounds.radius, 1.0f, 1e-5f);
}

/// Expects that each edge is one of exactly two triangles, which have it in opposite directions. Vertices at one
/// place, to the last digit, count as one.
inline void expectEdgesPaired(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> count;
  const auto place = [&](std::size_t i) {
    const glm::vec3 p = mesh.vertices[mesh.indices[i]].position + 0.0f;  // −0 is 0
    return Place{p.x, p.y, p.z};
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++count[{place(i + k), place(i + (k + 1) % 3)}];
  for (const auto& [edge, times] : count) {
    const auto opposite = count.find({edge.second, edge.first});
    ASSERT_EQ(times, 1) << "at " << edge.first[0] << ", " << edge.first[1] << ", " << edge.first[2];
    ASSERT_TRUE(opposite != count.end()) << "at " << edge.first[0] << ", " << edge.first[1] << ", " << edge.first[2];
  }
}

/// Expects unit normals that agree with the triangles' winding, and unit tangents in the surface.
///
/// min_cosine  between a triangle's normal and those of its corners
inline void expectSound(const Mesh& mesh, float min_cosine) {
  ASSERT_FALSE(mesh.indices.empty());
  ASSERT_EQ(mesh.indices.size() % 3, 0u);
  for (const Vertex& vertex : mesh.vertices) {
    ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f);
    ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-5f);
    ASSERT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-5f);
    ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) ASSERT_LT(mesh.indices[i + k], mesh.vertices.size());
    const auto corner = [&](std::size_t k) -> const Vertex& { return mesh.vertices[mesh.indices[i + k]]; };
    const glm::dvec3 origin(corner(0).position);
    const glm::dvec3 normal =
        glm::normalize(glm::cross(glm::dvec3(corner(1).position) - origin, glm::dvec3(corner(2).position) - origin));
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_GT(glm::dot(normal, glm::dvec3(corner(k).normal)), min_cosine) << "triangle " << i / 3;
  }
}

/// Expects tangents along growing u, and bitangents towards falling v,
/// as computeTangents finds them from the triangles.
inline void expectTangentsAlongU(const Mesh& mesh, float min_cosine) {
  Mesh computed = mesh;
  computeTangents(computed);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec4 given = mesh.vertices[mesh.indices[i]].tangent;
    const glm::vec4 found = computed.vertices[computed.indices[i]].tangent;
    ASSERT_EQ(given.w, found.w) << "corner " << i;
    ASSERT_GT(glm::dot(glm::vec3(given), glm::vec3(found)), min_cosine) << "corner " << i;
  }
}

}  // namespace mirrorball::testing
