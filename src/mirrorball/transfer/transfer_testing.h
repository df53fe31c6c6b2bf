#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/tangents.h"
#include "mirrorball/transfer/detail_transfer.h"

namespace mirrorball::testing {

/// A grid over [−1, 1]² in the plane z = 0, facing +Z, raised by a height; u grows with x, v with falling y.
template <typename Height>
Mesh plateMesh(int cells, const Height& height_at) {
  Mesh mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const glm::vec2 uv = glm::vec2(i, j) / float(cells);
      Vertex& vertex = mesh.vertices.emplace_back();
      vertex.uv[0] = uv;
      const glm::vec2 place(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y);
      vertex.position = glm::vec3(place, height_at(place));
    }
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      for (const auto& [a, b] : {std::pair(i, j), std::pair(i + 1, j), std::pair(i, j + 1), std::pair(i, j + 1),
                                 std::pair(i + 1, j), std::pair(i + 1, j + 1)})
        mesh.indices.push_back(index(a, b));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  computeNormals(mesh);
  computeTangents(mesh);
  return mesh;
}

inline Mesh flatPlate() {
  return plateMesh(1, [](glm::vec2) { return 0.0f; });
}

inline float degreesBetween(glm::vec3 a, glm::vec3 b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace mirrorball::testing
