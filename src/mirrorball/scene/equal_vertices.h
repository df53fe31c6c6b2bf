#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// For each vertex the first one that has the same numbers; −0 is 0.
///
/// numbers_of   of a vertex: an array of floats
template <typename NumbersOf>
std::vector<std::uint32_t> firstOfEqual(std::span<const Vertex> vertices, const NumbersOf& numbers_of) {
  using Numbers = decltype(numbers_of(vertices[0]));
  const auto hash = [](const Numbers& numbers) {
    std::size_t bits = 0;
    for (const float number : numbers) bits = (bits ^ std::hash<float>()(number)) * 0x9E3779B97F4A7C15u;
    return bits ^ (bits >> 32u);
  };
  std::unordered_map<Numbers, std::uint32_t, decltype(hash)> first(vertices.size(), hash);
  std::vector<std::uint32_t> firsts;
  firsts.reserve(vertices.size());
  for (const Vertex& vertex : vertices) {
    Numbers numbers = numbers_of(vertex);
    for (float& number : numbers) number += 0.0f;
    firsts.push_back(first.emplace(numbers, static_cast<std::uint32_t>(firsts.size())).first->second);
  }
  return firsts;
}

/// For each vertex the first one at the same place.
inline std::vector<std::uint32_t> firstAtPlace(std::span<const Vertex> vertices) {
  return firstOfEqual(vertices, [](const Vertex& vertex) {
    return std::array{vertex.position.x, vertex.position.y, vertex.position.z};
  });
}

}  // namespace mirrorball
