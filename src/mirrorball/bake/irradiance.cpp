#include "mirrorball/bake/irradiance.h"

#include <vector>

#include <glm/glm.hpp>

#include "formula/formula.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

using Sums = std::array<glm::dvec3, 9>;

void addRow(const EnvironmentMap& map, int face, int y, Sums& sums) {
  const Image& image = map.face(face);
  const glm::ivec2 size(image.width(), image.height());
  for (int x = 0; x < size.x; ++x) {
    const float weight = texelSolidAngle(map.projection(), size, {x, y});
    if (weight == 0.0f) continue;
    const glm::vec3 d = directionAt(map.projection(), {face, (glm::vec2(x, y) + 0.5f) / glm::vec2(size)});
    const glm::vec3 light = rgbAt(image, x, y) * weight;
    for (int i = 0; i < 9; ++i) sums[std::size_t(i)] += glm::dvec3(light * formula::harmonic(i, d));
  }
}

int bandOf(int index) { return index == 0 ? 0 : index < 4 ? 1 : 2; }

}  // namespace

IrradianceHarmonics irradianceHarmonics(const EnvironmentMap& map) {
  // One sum a row, added up in the rows' order afterwards: the same for any number of threads.
  const auto height = std::size_t(map.size());
  std::vector<Sums> rows(height * std::size_t(map.faces()), Sums{});
  parallelFor(rows.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      addRow(map, static_cast<int>(row / height), static_cast<int>(row % height), rows[row]);
  });
  IrradianceHarmonics coefficients;
  for (int i = 0; i < 9; ++i) {
    glm::dvec3 sum(0.0);
    for (const Sums& row : rows) sum += row[std::size_t(i)];
    coefficients[std::size_t(i)] = glm::vec3(sum) * formula::cosineLobeBand(bandOf(i));
  }
  return coefficients;
}

}  // namespace mirrorball
