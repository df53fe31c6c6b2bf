#include "mirrorball/environment/fill.h"

#include <algorithm>
#include <vector>

#include "formula/projection.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// A texel's centre, or a neighbour's, on the continued plane of the face.
glm::vec3 directionOf(int face, int size, glm::vec2 texel) {
  return glm::normalize(formula::cubePoint(face, (texel + 0.5f) / static_cast<float>(size)));
}

struct EdgeLight {
  glm::vec3 direction;
  glm::vec3 light;
};

glm::vec3 meanByDistance(const std::vector<EdgeLight>& edge, glm::vec3 direction) {
  constexpr float kSmallest = 1e-6f;  // chord², far below a texel's
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (const EdgeLight& point : edge) {
    const glm::vec3 chord = point.direction - direction;
    const float weight = 1.0f / std::max(glm::dot(chord, chord), kSmallest);
    sum += weight * point.light;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

Result<EnvironmentMap> continueSmoothly(const KnownRadiance& known, int size) {
  ImageSet images(1, 6);
  const std::size_t side = std::size_t(size);
  std::vector<char> is_known(6 * side * side);
  std::vector<char> is_edge(6 * side * side);
  for (int face = 0; face < 6; ++face) images.at(0, face) = Image(size, size, 3);
  const auto forEachTexel = [&](auto&& visit) {
    parallelFor(6 * side, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        for (int x = 0; x < size; ++x) visit(int(row / side), x, int(row % side), row * side + std::size_t(x));
    });
  };
  const auto write = [&](int face, int x, int y, glm::vec3 light) {
    for (int c = 0; c < 3; ++c) images.at(0, face).texel(x, y)[c] = light[c];
  };
  forEachTexel([&](int face, int x, int y, std::size_t index) {
    const auto light = known(directionOf(face, size, {x, y}));
    is_known[index] = light.has_value();
    if (!light) return;
    write(face, x, y, *light);
    for (const glm::vec2 step : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)})
      if (!known(directionOf(face, size, glm::vec2(x, y) + step))) is_edge[index] = 1;
  });
  if (std::count(is_known.begin(), is_known.end(), 1) == 0)
    return fail(ErrorCode::bad_shape, "light is known from no direction, so there is nothing to continue");

  std::vector<EdgeLight> edge;
  for (std::size_t index = 0; index < is_edge.size(); ++index) {
    if (!is_edge[index]) continue;
    const int face = int(index / (side * side));
    const int x = int(index % side), y = int(index / side % side);
    edge.push_back({directionOf(face, size, {x, y}), rgbAt(images.at(0, face), x, y)});
  }
  if (!edge.empty())
    forEachTexel([&](int face, int x, int y, std::size_t index) {
      if (!is_known[index]) write(face, x, y, meanByDistance(edge, directionOf(face, size, {x, y})));
    });
  return EnvironmentMap(Projection::cube, std::move(images));
}

}  // namespace mirrorball
