#include "mirrorball/bake/blurred_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mirrorball/bake/point_light_batch.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

/// A sun of half a degree has 101 texels in a panorama of 8192 × 4096.
constexpr int kMostBrightTexels = 256;

/// A sum over texels is the integral as long as they lie close enough under the narrowest lobe: of its Fourier transform
/// at the texels' own frequency e^(−2 α · 2 rows) is left, 5e-5.
int leastRows(float alpha) { return static_cast<int>(std::ceil(2.5f / alpha)); }

bool isDenseEnough(const EnvironmentMap& map, int rows) {
  const glm::ivec2 extent = map.extent();
  if (map.projection() == Projection::equirect) return extent.y >= rows && extent.x >= 2 * rows;
  return texelDensity(map.projection(), map.size()) >= texelDensity(Projection::equirect, rows);
}

}  // namespace

Result<LightHarmonics> LightHarmonics::make(const Environment& environment, int bands) {
  // GGX's last band is at 5.5 / α; what other lobes need is their own.
  const int rows = leastRows(5.5f / static_cast<float>(bands));
  const EnvironmentMap* map = environment.map();
  if (!map || !isDenseEnough(*map, rows)) {
    MIRRORBALL_TRY(panorama, convert(environment, Projection::equirect,
                                     std::max(rows, environment.naturalSize(Projection::equirect))));
    return ofPanorama(panorama, bands);
  }
  if (map->projection() == Projection::equirect) return ofPanorama(*map, bands);
  // Single texels are points of light in the map that they come from; converted they would be smeared.
  BrightTexels bright = brightTexels(*map, kMostBrightTexels);
  EnvironmentMap without = *map;
  subtract(bright, without);
  const int height = std::max(rows, environment.naturalSize(Projection::equirect));
  MIRRORBALL_TRY(panorama, convert(Environment(std::move(without)), Projection::equirect, height));
  return LightHarmonics(analyse(panorama, {}, bands), std::move(bright));
}

LightHarmonics LightHarmonics::ofPanorama(const EnvironmentMap& panorama, int bands) {
  BrightTexels bright = brightTexels(panorama, kMostBrightTexels);
  HarmonicCoefficients coefficients = analyse(panorama, bright, bands);
  return LightHarmonics(std::move(coefficients), std::move(bright));
}

BlurredLight LightHarmonics::blurred(const Lobe& lobe) const {
  return BlurredLight(lobe, synthesize(coefficients_, lobe.bands()), bright_);
}

void BlurredLight::sample(PointBatch& points, glm::vec4* values) const {
  positionsOf(Projection::equirect, points);
  grid_.sample(points, values);
  const LightChannels light = lightOfPoints(*bright_, lobe_, points);
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    glm::vec4& value = values[i];
    for (int c = 0; c < 3; ++c)
      value[c] = std::max(value[c] + value.w * light.channel[static_cast<std::size_t>(c)][i], 0.0f);
  }
}

}  // namespace mirrorball
