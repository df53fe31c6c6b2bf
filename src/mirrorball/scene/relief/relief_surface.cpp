#include "mirrorball/scene/relief/relief_surface.h"

#include <algorithm>

#include "formula/tangent.h"

namespace mirrorball {
namespace {

/// How much the heights rise from a texel to the next, along u and along v.
glm::vec2 slopeAtTexel(const HeightTexture& heights, glm::vec2 texel) {
  const formula::HeightMap map = heightMapOf(heights);
  const auto height = [&](float x, float y) { return formula::heightTexel(heights, map, texel + glm::vec2(x, y)).x; };
  const glm::vec3 above(0.0f, height(0.0f, -1.0f), 0.0f), below(0.0f, height(0.0f, 1.0f), 0.0f);
  const glm::vec3 row(height(-1.0f, 0.0f), 0.0f, height(1.0f, 0.0f));
  return formula::heightDifference(formula::kCentralDifference, above, row, below);
}

glm::vec2 slopeAt(const HeightTexture& heights, glm::vec2 place) {
  const glm::vec2 first = glm::floor(place);
  const glm::vec2 part = place - first;
  const auto slope = [&](float x, float y) { return slopeAtTexel(heights, first + glm::vec2(x, y)); };
  return glm::mix(glm::mix(slope(0.0f, 0.0f), slope(1.0f, 0.0f), part.x),
                  glm::mix(slope(0.0f, 1.0f), slope(1.0f, 1.0f), part.x), part.y);
}

}  // namespace

formula::ReliefPrism reliefPrism(const Mesh& mesh, std::size_t first, const Material& material,
                                 const HeightTexture& heights) {
  const Vertex& a = mesh.vertices[mesh.indices[first]];
  const Vertex& b = mesh.vertices[mesh.indices[first + 1]];
  const Vertex& c = mesh.vertices[mesh.indices[first + 2]];
  const glm::vec2 texels = material.height_frequency * heightMapOf(heights).size;
  const float depth = material.height_scale;
  return {.a = a.position,
          .along_x = b.position - a.position,
          .along_y = c.position - a.position,
          .up = depth * a.normal,
          .up_along_x = depth * (b.normal - a.normal),
          .up_along_y = depth * (c.normal - a.normal),
          .texel = a.uv[0] * texels - 0.5f,
          .texel_along_x = (b.uv[0] - a.uv[0]) * texels,
          .texel_along_y = (c.uv[0] - a.uv[0]) * texels,
          .joined = glm::vec3(0.0f),
          .heights = glm::vec2(0.0f, 1.0f)};
}

float reachOf(const Mesh& mesh) {
  float reach = 0.0f;
  for (const Vertex& vertex : mesh.vertices) reach = std::max(reach, glm::length(vertex.position));
  return reach;
}

glm::vec2 heightsBelow(const formula::ReliefPrism& prism, const HeightBounds& bounds, float reach) {
  const glm::vec2 b = prism.texel + prism.texel_along_x, c = prism.texel + prism.texel_along_y;
  const glm::vec2 low = glm::min(prism.texel, glm::min(b, c)), high = glm::max(prism.texel, glm::max(b, c));
  const glm::vec2 farthest = glm::max(glm::abs(low), glm::abs(high));
  // Too far away for the digits of a place, or no number.
  constexpr float kFarthest = 1e6f;
  if (!(farthest.x < kFarthest && farthest.y < kFarthest)) return {0.0f, 1.0f};
  // Prisms overlap (kOverlap), and shaders compute a place in another order.
  const glm::vec2 margin = 0.05f + 2.0f * formula::kOverlap * (high - low) + 1e-6f * farthest;
  const glm::vec2 heights = bounds.over(low - margin, high + margin);
  // A camera is some times as far away as the mesh reaches, and a ray's place is the sum of several rounded ones.
  const float rounding = 1e-5f * reach / std::max(glm::length(prism.up), 1e-30f);
  if (!(rounding < 1.0f)) return {0.0f, 1.0f};
  return {std::max(heights.x - rounding, 0.0f), std::min(heights.y + rounding, 1.0f)};
}

glm::vec3 reliefNormal(const HeightTexture& heights, const formula::ReliefPrism& prism, float depth, glm::vec2 x_y) {
  const glm::vec2 slope =
      depth * slopeAt(heights, prism.texel + x_y.x * prism.texel_along_x + x_y.y * prism.texel_along_y);
  const glm::vec3 normal = glm::normalize(prism.up + x_y.x * prism.up_along_x + x_y.y * prism.up_along_y);
  // The formula does not mind by which coordinates the place is told.
  return formula::displacedNormal(prism.along_x, prism.along_y, normal,
                                  {glm::dot(slope, prism.texel_along_x), glm::dot(slope, prism.texel_along_y)});
}

}  // namespace mirrorball
