#include "mirrorball/scene/relief/prism_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "mirrorball/scene/relief/relief_surface.h"

namespace mirrorball {
namespace {

/// For each vertex the first one that stands at the same place with the same normal.
std::vector<std::uint32_t> sameVertices(const Mesh& mesh) {
  const auto key = [&](std::uint32_t index) {
    const Vertex& v = mesh.vertices[index];
    return std::tuple(v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z);
  };
  std::vector<std::uint32_t> order(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::uint32_t> same(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    same[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? same[order[i - 1]] : order[i];
  return same;
}

/// The corners of a triangle's sides x = 0, y = 0 and x + y = 1, in the triangle's sense.
constexpr std::array<std::array<std::size_t, 2>, 3> kSides{{{2, 0}, {0, 1}, {1, 2}}};

/// Heights in [0, 1], the lower one rounded down and the higher one up: unpackUnorm2x16 reads them.
std::uint32_t packedHeights(glm::vec2 heights) {
  constexpr float kGreatest = 65535.0f;
  const auto low = static_cast<std::uint32_t>(std::floor(kGreatest * std::clamp(heights.x, 0.0f, 1.0f)));
  const auto high = static_cast<std::uint32_t>(std::ceil(kGreatest * std::clamp(heights.y, 0.0f, 1.0f)));
  return low | high << 16;
}

}  // namespace

std::vector<glm::vec3> joinedSides(const Mesh& mesh) {
  const std::vector<std::uint32_t> same = sameVertices(mesh);
  // A neighbour goes along the side the other way.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  sides.reserve(mesh.indices.size());
  const auto side = [&](std::size_t triangle, std::size_t number) {
    return std::pair(same[mesh.indices[3 * triangle + kSides[number][0]]],
                     same[mesh.indices[3 * triangle + kSides[number][1]]]);
  };
  for (std::size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle)
    for (std::size_t number = 0; number < kSides.size(); ++number) sides.push_back(side(triangle, number));
  std::sort(sides.begin(), sides.end());
  std::vector<glm::vec3> joined(mesh.indices.size() / 3, glm::vec3(0.0f));
  for (std::size_t triangle = 0; triangle < joined.size(); ++triangle)
    for (std::size_t number = 0; number < kSides.size(); ++number) {
      const auto [from, to] = side(triangle, number);
      if (std::binary_search(sides.begin(), sides.end(), std::pair(to, from)))
        joined[triangle][static_cast<int>(number)] = 1.0f;
    }
  return joined;
}

std::vector<glm::uvec4> prismList(const Scene& scene, int index) {
  const Mesh& mesh = scene.meshes[std::size_t(index)];
  const Material& material = scene.materials[std::size_t(mesh.material)];
  const HeightTexture& heights = scene.height_textures[std::size_t(material.height_texture)];
  constexpr std::size_t kTexelsOfPrism = 16;
  const std::vector<glm::vec3> joined = joinedSides(mesh);
  std::vector<glm::uvec4> words;
  words.reserve(joined.size() * kTexelsOfPrism);
  const float reach = reachOf(mesh);
  for (std::size_t triangle = 0; triangle < joined.size(); ++triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vertex& vertex = mesh.vertices[mesh.indices[3 * triangle + corner]];
      for (const glm::vec4 texel :
           {glm::vec4(vertex.position, vertex.uv[0].x), glm::vec4(vertex.normal, vertex.uv[0].y),
            glm::vec4(vertex.uv[1], 0.0f, 0.0f), vertex.tangent, vertex.color})
        words.push_back(glm::floatBitsToUint(texel));
    }
    const glm::vec2 below = heightsBelow(reliefPrism(mesh, 3 * triangle, material, heights), heights.bounds, reach);
    words.emplace_back(glm::floatBitsToUint(joined[triangle]), packedHeights(below));
  }
  return words;
}

}  // namespace mirrorball
