#include "mirrorball/scene/relief/relief_surface.h"

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
          .joined = glm::vec3(0.0f)};
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
