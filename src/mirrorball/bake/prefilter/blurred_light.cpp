#include "mirrorball/bake/prefilter/blurred_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mirrorball/bake/prefilter/high_band_contrast.h"
#include "mirrorball/bake/prefilter/point_light_batch.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

/// How many points of light are taken without a need: few cost little beside the harmonics.
constexpr int kFewBrightLights = 64;

/// And how many at most where lamps leave much of themselves in the harmonics, whose rounding would be seen in the dark
/// beside them.
constexpr std::array kMoreBrightLights{512, 4096};
constexpr float kHighContrast = 2.0f;

/// What may be missing at the darkest part of a map, as a root mean square, by the estimate of highBandContrast; errors
/// of single texels in maps of rooms and landscapes were a hundred times less to as much (docs/prefiltering.md).
constexpr float kTolerance = 6e-3f;

/// A sum over texels is the integral as long as they lie close enough under the narrowest lobe: of its Fourier
/// transform at the texels' own frequency e^(−2 α · 2 rows) is left, 5e-5. And a row has at least as many texels as
/// wide lobes have bands: white texels then have no light in any order but 0, by which all is divided.
int minRows(const std::vector<Lobe>& lobes) {
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
Layout layoutOf(const Environment& environment, int min_rows) {
  const int natural = environment.naturalSize(Projection::equirect);
  // A function may be as smooth as it likes: with that many rows the first harmonics are right to 1e-4.
  constexpr int kMinRowsOfFunction = 256;
  // Few texels are seen as tents between which nothing is lost; a cubic would be raised beside a lamp in the dark, and
  // more than two points across each keep its flux.
  constexpr int kPointsAcrossTexel = 4;
  constexpr int kMaxRowsForThat = 2048;
  const int rows = std::max(min_rows, natural);
  const EnvironmentMap* map = environment.map();
  if (!map) return {std::max(rows, kMinRowsOfFunction), Interpolation::bicubic};
  if (isDenseEnough(*map, min_rows)) return {rows, Interpolation::bicubic};
  return {std::max(rows, std::min(kPointsAcrossTexel * natural, kMaxRowsForThat)), Interpolation::bilinear};
}

Result<EnvironmentMap> laidOut(const Environment& environment, int min_rows, const ProgressFunction& progress) {
  const Layout layout = layoutOf(environment, min_rows);
  return convert(environment, Projection::equirect, layout.rows, {.interpolation = layout.interpolation}, progress);
}

/// The light of an environment as a panorama and points.
struct SplitLight {
  BrightLights bright;
  EnvironmentMap laid_out;              ///< without the bright lights
  const EnvironmentMap* own = nullptr;  ///< or the environment's, which still has them
  float contrast = 0.0f;                ///< of the panorama without them
};

/// Single texels are points of light in the map that they come from; converted they would be smeared. But of a map of
/// very few texels they would be seen as points.
///
/// max   points at most
Result<SplitLight> splitLight(const Environment& environment, int rows, int max, const ProgressFunction& progress) {
  SplitLight split;
  const EnvironmentMap* map = environment.map();
  if (map && isDenseEnough(*map, rows / 4)) split.bright = brightLights(*map, max);
  if (isDensePanorama(map, rows)) {
    split.own = map;
    split.contrast = highBandContrast(*map, split.bright);
    return split;
  }
  if (split.bright.texels.empty()) {
    MIRRORBALL_TRY(panorama, laidOut(environment, rows, progress));
    split.bright = brightLights(panorama, max);
    subtract(split.bright, panorama);
    split.laid_out = std::move(panorama);
  } else {
    EnvironmentMap without = *map;
    subtract(split.bright, without);
    MIRRORBALL_TRY(panorama, laidOut(Environment(std::move(without)), rows, progress));
    split.laid_out = std::move(panorama);
  }
  split.contrast = highBandContrast(split.laid_out, {});
  return split;
}

/// The same with as many points as are worth their while.
Result<SplitLight> splitLight(const Environment& environment, int rows, const ProgressFunction& progress) {
  constexpr std::size_t kSteps = 1000;
  const auto partOfTry = [&](std::size_t i) {
    return partOf(progress, i * kSteps, kSteps, (1 + kMoreBrightLights.size()) * kSteps);
  };
  MIRRORBALL_TRY(light, splitLight(environment, rows, kFewBrightLights, partOfTry(0)));
  for (std::size_t i = 0; i < kMoreBrightLights.size(); ++i) {
    if (light.contrast < kHighContrast || light.bright.is_complete) break;
    MIRRORBALL_TRY(other, splitLight(environment, rows, kMoreBrightLights[i], partOfTry(i + 1)));
    if (other.bright.is_complete || other.contrast < light.contrast / 2.0f) light = std::move(other);
  }
  return light;
}

}  // namespace

Result<LightHarmonics> LightHarmonics::make(const Environment& environment, const std::vector<Lobe>& lobes,
                                            const ProgressFunction& progress) {
  // Analysing takes a few times as long as laying out.
  constexpr std::size_t kSteps = 4000;
  constexpr std::size_t kLaidOut = kSteps / 4;
  MIRRORBALL_TRY(light, splitLight(environment, minRows(lobes), partOf(progress, 0, kLaidOut, kSteps)));
  const float tolerance = kTolerance / light.contrast;
  int bands = 1;
  for (const Lobe& lobe : lobes) bands = std::max(bands, lobe.bandsFor(tolerance));
  const ProgressFunction steps = partOf(progress, kLaidOut, kSteps - kLaidOut, kSteps);
  MIRRORBALL_TRY(coefficients, light.own ? analyse(*light.own, light.bright, bands, steps)
                                         : analyse(light.laid_out, {}, bands, steps));
  return LightHarmonics(tolerance, std::move(coefficients), std::move(light.bright));
}

LightHarmonics::Memory LightHarmonics::memoryFor(const Environment& environment, const std::vector<Lobe>& lobes) {
  std::size_t bands = 1;
  for (const Lobe& lobe : lobes) bands = std::max(bands, lobe.bands().size());
  const std::uint64_t kept = harmonicBytes(static_cast<int>(bands));
  const std::uint64_t analysed = kept + analysisBytes(static_cast<int>(bands));
  const int rows = minRows(lobes);
  if (isDensePanorama(environment.map(), rows)) return {analysed, kept};
  // A copy without the bright texels goes when it has been laid out; two of that are compared.
  const std::uint64_t laid_out = layoutOf(environment, rows).bytes();
  return {laid_out + std::max(laid_out + environment.bytes(), analysed), kept};
}

GridDensity LightHarmonics::gridDensityFor(const Lobe& lobe) {
  return lobe.shape().distribution == Distribution::ggx ? GridDensity::sparse : GridDensity::dense;
}

Result<BlurredLight> LightHarmonics::blurred(const Lobe& lobe, const ProgressFunction& progress) const {
  const std::vector<float>& bands = lobe.bands();
  const std::vector<float> weights(bands.begin(), bands.begin() + lobe.bandsFor(tolerance_));
  MIRRORBALL_TRY(grid, synthesize(coefficients_, weights, gridDensityFor(lobe), progress));
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
