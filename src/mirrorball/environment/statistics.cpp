#include "mirrorball/environment/statistics.h"

#include <cmath>
#include <limits>

#include "formula/color.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {

RadianceStatistics radianceStatistics(const EnvironmentMap& map) {
  RadianceStatistics statistics;
  statistics.min = glm::vec3(std::numeric_limits<float>::infinity());
  statistics.max = -statistics.min;
  float max_luminance = -std::numeric_limits<float>::infinity();
  glm::dvec3 flux(0.0);
  double solid_angle = 0.0;
  for (int face = 0; face < map.faces(); ++face) {
    const Image& image = map.face(face);
    const glm::ivec2 size(image.width(), image.height());
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::vec3 light = rgbAt(image, x, y);
        const float weight = texelSolidAngle(map.projection(), size, {x, y});
        if (weight == 0.0f || !std::isfinite(light.x + light.y + light.z)) continue;
        statistics.min = glm::min(statistics.min, light);
        statistics.max = glm::max(statistics.max, light);
        flux += glm::dvec3(light) * double(weight);
        solid_angle += double(weight);
        if (formula::luminance(light) <= max_luminance) continue;
        max_luminance = formula::luminance(light);
        statistics.brightest = light;
        statistics.brightest_direction =
            directionAt(map.projection(), {face, (glm::vec2(x, y) + 0.5f) / glm::vec2(size)});
      }
  }
  if (solid_angle == 0.0) return {};
  statistics.mean = glm::vec3(flux / solid_angle);
  return statistics;
}

}  // namespace mirrorball
