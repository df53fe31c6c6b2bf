#include "mirrorball/bake/blurred_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mirrorball/bake/light_contrast.h"
#include "mirrorball/bake/point_light_batch.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

/// A sun of half a degree has 101 texels in a panorama of 8192 × 4096 at the horizon, and twice as many 60° above it.
constexpr int kMostBrightLights = 256;

/// What may be missing at the darkest part of a map, by the bound of lightContrast. What is missing in fact is ten to
/// thirty times less (docs/prefiltering.md).
constexpr float kTolerance = 3e-3f;

/// A sum over texels is the integral as long as they lie close enough under the narrowest lobe: of its Fourier transform
/// at the texels' own frequency e^(−2 α · 2 rows) is left, 5e-5. And a row has at least as many texels as wide lobes have
/// bands: white texels then have no light in any order but 0, by which all is divided.
int leastRows(const std::vector<Lobe>& lobes) {
  float narrowest = 1.0f;
  for (const Lobe& lobe : lobes) narrowest = std::min(narrowest, lobe.width());
  return std::max(static_cast<int>(std::ceil(2.5f / narrowest)), Lobe::kCheapBands / 2);
}

bool isDenseEnough(const EnvironmentMap& map, int rows) {
  const glm::ivec2 extent = map.extent();
  if (map.projection() == Projection::equirect) return extent.y >= rows && extent.x >= 2 * rows;
  return texelDensity(map.projection(), map.size()) >= texelDensity(Projection::equirect, rows);
}

bool isDensePanorama(const EnvironmentMap* map, int rows) {
  return map && map->projection() == Projection::equirect && isDenseEnough(*map, rows);
}

/// How an environment is laid out as a panorama.
struct Layout {
  int rows;
  Interpolation interpolation;

  std::uint64_t bytes() const { return std::uint64_t(rows) * std::uint64_t(2 * rows) * 3 * sizeof(float); }
};
Layout layoutOf(const Environment& environment, int least_rows) {
  const int natural = environment.naturalSize(Projection::equirect);
  // A function may be as smooth as it likes: with that many rows the first harmonics are right to 1e-4.
  constexpr int kLeastRowsOfFunction = 256;
  // Few texels are seen as tents between which nothing is lost; a cubic would be raised beside a lamp in the dark, and
  // more than two points across each keep its flux.
  constexpr int kPointsAcrossTexel = 4;
  constexpr int kMostRowsForThat = 2048;
  const int rows = std::max(least_rows, natural);
  const EnvironmentMap* map = environment.map();
  if (!map) return {std::max(rows, kLeastRowsOfFunction), Interpolation::bicubic};
  if (isDenseEnough(*map, least_rows)) return {rows, Interpolation::bicubic};
  return {std::max(rows, std::min(kPointsAcrossTexel * natural, kMostRowsForThat)), Interpolation::bilinear};
}

Result<EnvironmentMap> laidOut(const Environment& environment, int least_rows, const ProgressFunction& progress) {
  const Layout layout = layoutOf(environment, least_rows);
  return convert(environment, Projection::equirect, layout.rows, {.interpolation = layout.interpolation}, progress);
}

}  // namespace

Result<LightHarmonics> LightHarmonics::make(const Environment& environment, const std::vector<Lobe>& lobes,
                                            const ProgressFunction& progress) {
  const int rows = leastRows(lobes);
  const EnvironmentMap* map = environment.map();
  // Single texels are points of light in the map that they come from; converted they would be smeared. But of a map of
  // very few texels they would be seen as points.
  BrightLights bright;
  if (map && isDenseEnough(*map, rows / 4)) bright = brightLights(*map, kMostBrightLights);
  if (isDensePanorama(map, rows)) return ofPanorama(*map, bright, bright, lobes, progress);
  // Analysing takes a few times as long as laying out.
  constexpr std::size_t kSteps = 4000;
  const ProgressFunction lay_out = partOf(progress, 0, kSteps / 4, kSteps);
  const ProgressFunction analyse = partOf(progress, kSteps / 4, kSteps * 3 / 4, kSteps);
  if (bright.texels.empty()) {
    MIRRORBALL_TRY(panorama, laidOut(environment, rows, lay_out));
    bright = brightLights(panorama, kMostBrightLights);
    return ofPanorama(panorama, bright, bright, lobes, analyse);
  }
  EnvironmentMap without = *map;
  subtract(bright, without);
  MIRRORBALL_TRY(panorama, laidOut(Environment(std::move(without)), rows, lay_out));
  return ofPanorama(panorama, {}, bright, lobes, analyse);
}

Result<LightHarmonics> LightHarmonics::ofPanorama(const EnvironmentMap& panorama, const BrightLights& without,
                                                  const BrightLights& bright, const std::vector<Lobe>& lobes,
                                                  const ProgressFunction& progress) {
  const float tolerance = kTolerance / lightContrast(panorama, without);
  int bands = 1;
  for (const Lobe& lobe : lobes) bands = std::max(bands, lobe.bandsFor(tolerance));
  MIRRORBALL_TRY(coefficients, analyse(panorama, without, bands, progress));
  return LightHarmonics(tolerance, std::move(coefficients), bright);
}

LightHarmonics::Memory LightHarmonics::memoryFor(const Environment& environment, const std::vector<Lobe>& lobes) {
  std::size_t bands = 1;
  for (const Lobe& lobe : lobes) bands = std::max(bands, lobe.bands().size());
  const std::uint64_t kept = harmonicBytes(static_cast<int>(bands));
  const std::uint64_t analysed = kept + analysisBytes(static_cast<int>(bands));
  const int rows = leastRows(lobes);
  if (isDensePanorama(environment.map(), rows)) return {analysed, kept};
  // A copy without the bright texels goes when it has been laid out.
  return {layoutOf(environment, rows).bytes() + std::max(environment.bytes(), analysed), kept};
}

Result<BlurredLight> LightHarmonics::blurred(const Lobe& lobe, const ProgressFunction& progress) const {
  std::vector<float> weights = lobe.bands();
  weights.resize(static_cast<std::size_t>(std::min(lobe.bandsFor(tolerance_), coefficients_.bands())));
  MIRRORBALL_TRY(grid, synthesize(coefficients_, weights, progress));
  return BlurredLight(lobe, std::move(grid), bright_);
}

void BlurredLight::sample(PointBatch& points, glm::vec4* values) const {
  positionsOf(Projection::equirect, points);
  grid_.sample(points, values);
  const LightChannels light = lightOfPoints(bright_->points, lobe_, points);
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    glm::vec4& value = values[i];
    for (int c = 0; c < 3; ++c)
      value[c] = std::max(value[c] + value.w * light.channel[static_cast<std::size_t>(c)][i], 0.0f);
  }
}

}  // namespace mirrorball
