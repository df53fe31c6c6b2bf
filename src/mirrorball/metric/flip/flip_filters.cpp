#include "mirrorball/metric/flip/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mirrorball::flip {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// One Gaussian of the contrast sensitivity: a √(π/b) exp(−π² x²/b), x in degrees.
struct Sensitivity {
  float a;
  float b;
};
constexpr Sensitivity kAchromatic{1.0f, 0.0047f};
constexpr Sensitivity kRedGreen{1.0f, 0.0053f};
constexpr Sensitivity kBlueYellowNarrow{34.1f, 0.04f};
constexpr Sensitivity kBlueYellowWide{13.5f, 0.025f};

/// The width of the detectors of features [degrees].
constexpr float kFeatureWidth = 0.082f;

/// One direction of a Gaussian whose two directions together have the height `a`√(π/b).
Filter gaussian(Sensitivity s, int radius, float pixels_per_degree) {
  const float height = std::sqrt(s.a * std::sqrt(kPi / s.b));
  const float pixel = 1.0f / pixels_per_degree;
  Filter filter;
  for (int i = -radius; i <= radius; ++i) {
    const float degrees = static_cast<float>(i) * pixel;
    filter.push_back(height * std::exp(-kPi * kPi * degrees * degrees / s.b));
  }
  return filter;
}

float sumOf(const Filter& filter) {
  float sum = 0.0f;
  for (const float weight : filter) sum += weight;
  return sum;
}

void scale(Filter& filter, float factor) {
  for (float& weight : filter) weight *= factor;
}

void normalize(Filter& filter) { scale(filter, 1.0f / sumOf(filter)); }

/// Of two that are added after both directions the squares of the sums make up 1.
void normalizeTogether(Filter& first, Filter& second) {
  const float factor = 1.0f / std::hypot(sumOf(first), sumOf(second));
  scale(first, factor);
  scale(second, factor);
}

/// Makes the weights above 0 sum to 1 and those below to −1.
void normalizeEachSign(Filter& filter) {
  float above = 0.0f;
  float below = 0.0f;
  for (const float weight : filter) (weight > 0.0f ? above : below) += std::abs(weight);
  for (float& weight : filter) weight /= weight > 0.0f ? above : below;
}

}  // namespace

int Filters::radius() const { return std::max(spatial_radius, feature_radius); }

Filters filtersFor(float pixels_per_degree) {
  Filters filters;
  // Three standard deviations of the widest.
  const float widest = std::max({kAchromatic.b, kRedGreen.b, kBlueYellowNarrow.b, kBlueYellowWide.b});
  filters.spatial_radius =
      static_cast<int>(std::ceil(3.0f * std::sqrt(widest / (2.0f * kPi * kPi)) * pixels_per_degree));
  filters.achromatic = gaussian(kAchromatic, filters.spatial_radius, pixels_per_degree);
  filters.red_green = gaussian(kRedGreen, filters.spatial_radius, pixels_per_degree);
  filters.blue_yellow_narrow = gaussian(kBlueYellowNarrow, filters.spatial_radius, pixels_per_degree);
  filters.blue_yellow_wide = gaussian(kBlueYellowWide, filters.spatial_radius, pixels_per_degree);
  normalize(filters.achromatic);
  normalize(filters.red_green);
  normalizeTogether(filters.blue_yellow_narrow, filters.blue_yellow_wide);

  const float deviation = 0.5f * kFeatureWidth * pixels_per_degree;
  filters.feature_radius = static_cast<int>(std::ceil(3.0f * deviation));
  for (int i = -filters.feature_radius; i <= filters.feature_radius; ++i) {
    const auto x = static_cast<float>(i);
    const float g = std::exp(-x * x / (2.0f * deviation * deviation));
    filters.smooth.push_back(g);
    filters.edge.push_back(-x * g);
    filters.point.push_back((x * x / (deviation * deviation) - 1.0f) * g);
  }
  normalize(filters.smooth);
  normalizeEachSign(filters.edge);
  normalizeEachSign(filters.point);
  return filters;
}

}  // namespace mirrorball::flip
