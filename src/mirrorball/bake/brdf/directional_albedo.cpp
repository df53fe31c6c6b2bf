// The integral is taken over the half vector h, at an angle θ from the normal and φ around it from the viewer's side:
// dl = 4 (v·h) dh, so that the share is ∫ 4 D(h) (v·h) V (n·l) F dh. Its borders are known: light comes from above the
// horizon, n·l = 2 (n·h)(v·h) − n·v > 0, up to
//   cos φ_max = −cot 2θ cot θ_v,
// which is all around for θ below θ₁ = (90° − θ_v) / 2 and nowhere for θ above θ₂ = (90° + θ_v) / 2. On [0, θ₁] and on
// [θ₁, θ₂] the integrand has no kink and no edge inside, and Gauss' rule converges fast in φ. Along θ it runs over y in
// [0, 1), tan θ = width · y / (1 − y²), which spreads the peak of D over the middle; the rule's places are gathered at
// both ends of each stretch, where square roots begin and where what is of the size of the peak ends and what is of the
// size of the hemisphere begins.
//
// directional_albedo_test holds this to an integral over l that shares nothing with it.

#include "mirrorball/bake/brdf/directional_albedo.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "mirrorball/bake/harmonics/gauss_legendre.h"
#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/brdf/directional_albedo.cpp"
// Highway needs its headers in this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>
// clang-format on

#ifndef MIRRORBALL_REFLECTED_SHARE_ONCE
#define MIRRORBALL_REFLECTED_SHARE_ONCE
namespace mirrorball {

/// Where the integrand is taken in [0, 1], and what each place stands for.
struct SharePlaces {
  std::vector<float> along;           ///< θ in each of the two stretches: a multiple of the lanes
  std::vector<float> along_from_end;  ///< 1 − along
  std::vector<float> along_weights;
  std::vector<float> around;          ///< φ, on one side of the plane of n and v
  std::vector<float> around_cosines;  ///< cos(π · around)
  std::vector<float> around_weights;
};

/// What is the same for all places of one integral.
struct ShareSetting {
  float alpha;
  float width;   ///< of the scale of tan θ
  float cosine;  ///< n·v
  float sine;
  float masking_of_eye;  ///< ggx: √(α² + (1 − α²) (n·v)²); blinn: n·v Λ(v)
};

/// A stretch of y, by its ends and by how far they are from 1, which y near 1 does not tell.
struct ShareStretch {
  double begin;
  double end;
  double end_to_one;
  bool all_around;  ///< φ_max = π
};

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 8>;
using Floats = hn::Vec<Lanes>;

constexpr float kPi = std::numbers::pi_v<float>;

/// Small enough to change no sum that matters, and keeps 0 / 0 away.
constexpr float kTiny = 1e-20f;

HWY_INLINE Floats set(float value) { return hn::Set(Lanes(), value); }

/// 4 D(h) sin θ dθ/dy without the width², which the change of variable takes away.
template <Distribution kDistribution>
HWY_INLINE Floats weightedDistribution(const ShareSetting& setting, Floats y, Floats to_one, Floats t) {
  const Lanes d;
  const Floats rest = to_one * (set(1.0f) + y);  // 1 − y²
  const Floats stretch = (set(1.0f) + y * y) / (rest * rest);
  const Floats tangent = set(setting.width) * t;
  const Floats tangent2 = tangent * tangent;
  const Floats cosine2 = set(1.0f) / (set(1.0f) + tangent2);
  // sin θ dθ = cos³θ tan θ d(tan θ)
  const Floats ring = set(4.0f) * t * stretch * cosine2 * hn::Sqrt(cosine2);
  const float a2 = setting.alpha * setting.alpha;
  switch (kDistribution) {
    case Distribution::charlie: {
      const Floats log_sine2 = set(0.0f) - hn::Log1p(d, set(1.0f) / hn::Max(tangent2, set(kTiny)));
      const float inverse = 1.0f / setting.alpha;
      return ring * set((2.0f + inverse) / (2.0f * kPi)) * hn::Exp(d, set(0.5f * inverse) * log_sine2);
    }
    case Distribution::phong:
    case Distribution::blinn:
      // (p + 2) / 2π · α² = 1 / π, and cosᵖ θ with p / 2 = (1 − α²) / α²
      return ring * set(1.0f / kPi) *
             hn::Exp(d, set(0.0f) - set((1.0f - a2) / std::max(a2, kTiny)) * hn::Log1p(d, tangent2));
    case Distribution::ggx:
      break;
  }
  const Floats slope = (set(1.0f) + t * t) * cosine2;
  return ring * set(1.0f / kPi) / (slope * slope);
}

/// V n·l, where `light` is n·l.
template <Distribution kDistribution>
HWY_INLINE Floats weightedVisibility(const ShareSetting& setting, Floats light) {
  const Floats eye = set(setting.cosine);
  const Floats masking = set(setting.masking_of_eye);
  const float a2 = setting.alpha * setting.alpha;
  switch (kDistribution) {
    case Distribution::charlie:
      return set(0.25f) * light / (light + eye - light * eye + set(kTiny));
    case Distribution::phong:
    case Distribution::blinn: {
      // Λ = (1 − G1) / G1 of Walter's G1(a), a = 1 / (α tan θ_l); 0 from 1.6 on.
      const Floats sine = hn::Sqrt(hn::Max(set(1.0f) - light * light, hn::Zero(Lanes())));
      const Floats a = hn::Max(light, set(kTiny)) / hn::Max(set(setting.alpha) * sine, set(kTiny));
      const Floats lambda = (set(1.0f) + a * (set(0.396f) * a - set(1.259f))) / (a * (set(3.535f) + set(2.181f) * a));
      const Floats shadowing = hn::IfThenElseZero(a < set(1.6f), lambda);
      return set(0.25f) / (eye + masking + eye * shadowing + set(kTiny));
    }
    case Distribution::ggx:
      break;
  }
  const Floats shadowing = hn::Sqrt(set(a2) + set(1.0f - a2) * light * light);
  return set(0.5f) * light / (eye * shadowing + light * masking + set(kTiny));
}

/// Adds one stretch of θ.
template <Distribution kDistribution>
void addStretchOf(const ShareSetting& setting, const SharePlaces& places, const ShareStretch& stretch, double& whole,
                  double& grazing, double& tilt) {
  const Lanes d;
  const auto length = static_cast<float>(stretch.end - stretch.begin);
  const Floats eye = set(setting.cosine);
  Floats sum = hn::Zero(d);
  Floats grazing_sum = hn::Zero(d);
  Floats tilt_sum = hn::Zero(d);
  for (std::size_t i = 0; i < places.along.size(); i += hn::Lanes(d)) {
    const Floats y = set(static_cast<float>(stretch.begin)) + set(length) * hn::LoadU(d, &places.along[i]);
    const Floats to_one =
        set(static_cast<float>(stretch.end_to_one)) + set(length) * hn::LoadU(d, &places.along_from_end[i]);
    const Floats t = y / (to_one * (set(1.0f) + y));
    const Floats tangent = set(setting.width) * t;
    const Floats cosine = hn::Sqrt(set(1.0f) / (set(1.0f) + tangent * tangent));
    const Floats sine = tangent * cosine;
    // −cot 2θ cot θ_v
    const Floats edge =
        (tangent * tangent - set(1.0f)) / (set(2.0f) * tangent) * set(setting.cosine / std::max(setting.sine, kTiny));
    const Floats around = stretch.all_around ? set(kPi) : hn::Acos(d, hn::Min(hn::Max(edge, set(-1.0f)), set(1.0f)));
    Floats ring = hn::Zero(d);
    Floats grazing_ring = hn::Zero(d);
    Floats tilt_ring = hn::Zero(d);
    for (std::size_t j = 0; j < places.around.size(); ++j) {
      const Floats across =
          stretch.all_around ? set(places.around_cosines[j]) : hn::Cos(d, around * set(places.around[j]));
      const Floats towards = set(setting.sine) * sine * across;
      const Floats eye_half = hn::MulAdd(eye, cosine, towards);
      // 2 (n·h)(v·h) − n·v, of terms that are all as small as n·l where that is small.
      const Floats light =
          hn::Max(eye * (set(1.0f) - set(2.0f) * sine * sine) + set(2.0f) * cosine * towards, hn::Zero(d));
      const Floats share = eye_half * weightedVisibility<kDistribution>(setting, light) * set(places.around_weights[j]);
      const Floats past = set(1.0f) - eye_half;
      const Floats past2 = past * past;
      ring = ring + share;
      grazing_ring = hn::MulAdd(share, past2 * past2 * past, grazing_ring);
      tilt_ring = hn::MulAdd(share, past, tilt_ring);
    }
    // Both sides of the plane of n and v.
    const Floats weight = set(2.0f) * around * weightedDistribution<kDistribution>(setting, y, to_one, t) *
                          hn::LoadU(d, &places.along_weights[i]) * set(length);
    sum = hn::MulAdd(ring, weight, sum);
    grazing_sum = hn::MulAdd(grazing_ring, weight, grazing_sum);
    tilt_sum = hn::MulAdd(tilt_ring, weight, tilt_sum);
  }
  whole += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)));
  grazing += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, grazing_sum)));
  tilt += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, tilt_sum)));
}

void addStretch(Distribution distribution, const ShareSetting& setting, const SharePlaces& places,
                const ShareStretch& stretch, double& whole, double& grazing, double& tilt) {
  switch (distribution) {
    case Distribution::charlie:
      return addStretchOf<Distribution::charlie>(setting, places, stretch, whole, grazing, tilt);
    case Distribution::phong:
    case Distribution::blinn:
      return addStretchOf<Distribution::blinn>(setting, places, stretch, whole, grazing, tilt);
    case Distribution::ggx:
      return addStretchOf<Distribution::ggx>(setting, places, stretch, whole, grazing, tilt);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {
namespace {

HWY_EXPORT(addStretch);

/// Gauss' rule on [0, 1], its places moved towards both ends by x² (3 − 2 x).
QuadratureRule gatheredRule(int count) {
  QuadratureRule rule = gaussLegendre(count);
  for (std::size_t i = 0; i < rule.places.size(); ++i) {
    const double x = (1.0 + rule.places[i]) / 2.0;
    rule.places[i] = x * x * (3.0 - 2.0 * x);
    rule.weights[i] *= 3.0 * x * (1.0 - x);
  }
  return rule;
}

SharePlaces makePlaces(int along_count, int around_count) {
  SharePlaces places;
  const QuadratureRule along = gatheredRule(along_count);
  for (const double place : along.places) places.along.push_back(static_cast<float>(place));
  for (const double weight : along.weights) places.along_weights.push_back(static_cast<float>(weight));
  // The rule is the same from both ends.
  places.along_from_end.assign(places.along.rbegin(), places.along.rend());
  const QuadratureRule around = gaussLegendre(around_count);
  for (std::size_t j = 0; j < around.places.size(); ++j) {
    const double place = (1.0 + around.places[j]) / 2.0;
    places.around.push_back(static_cast<float>(place));
    places.around_cosines.push_back(static_cast<float>(std::cos(std::numbers::pi * place)));
    places.around_weights.push_back(static_cast<float>(around.weights[j] / 2.0));
  }
  return places;
}

/// As many as leave an error of 5e-5. Walter's masking has a kink at a = 1.6, and cloth reflects from the far end of θ.
const SharePlaces& placesFor(Distribution distribution) {
  static const SharePlaces kSmooth = makePlaces(24, 8);
  static const SharePlaces kOthers = makePlaces(64, 32);
  return distribution == Distribution::ggx ? kSmooth : kOthers;
}

/// y and 1 − y for which y / (1 − y²) = t, which may be infinite.
struct Place {
  double y;
  double to_one;
};
Place placeOf(double t) {
  const double root = std::sqrt(1.0 + 4.0 * t * t);
  const double to_one = (1.0 + 1.0 / (root + 2.0 * t)) / (1.0 + root);
  return {t < 1.0 ? 2.0 * t / (1.0 + root) : 1.0 - to_one, to_one};
}

/// √(α² + (1 − α²) (n·v)²) for ggx, n·v Λ(v) for blinn.
double maskingOfEye(Distribution distribution, double alpha, double cosine, double sine) {
  if (distribution == Distribution::ggx) return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
  const double a = cosine / std::max(alpha * sine, 1e-20);
  if (distribution == Distribution::charlie || a >= 1.6) return 0.0;
  return alpha * sine * (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a);
}

}  // namespace

float DirectionalAlbedo::grazing() const {
  return total() > 0.0f ? std::pow(std::clamp(bias / total(), 0.0f, 1.0f), 0.2f) : 1.0f;
}

float DirectionalAlbedo::meanTilt() const { return total() > 0.0f ? std::clamp(tilt / total(), 0.0f, 1.0f) : 1.0f; }

DirectionalAlbedo directionalAlbedo(Distribution distribution, float perceptual_roughness, float cosine) {
  assert(perceptual_roughness >= 0.0f && perceptual_roughness <= 1.0f && cosine >= 0.0f && cosine <= 1.0f);
  const bool is_cloth = distribution == Distribution::charlie;
  if (perceptual_roughness == 0.0f) {
    if (is_cloth) return {};
    const float grazing = std::pow(1.0f - cosine, 5.0f);
    return {1.0f - grazing, grazing, 1.0f - cosine};
  }
  const double alpha = double(perceptual_roughness) * double(perceptual_roughness);
  const double eye = cosine;
  const double sine = std::sqrt((1.0 - eye) * (1.0 + eye));
  // Cloth reflects where h lies at the horizon, so its tangent has no scale of its own.
  const double width = is_cloth ? 1.0 : alpha;
  const ShareSetting setting{static_cast<float>(alpha), static_cast<float>(width), cosine, static_cast<float>(sine),
                             static_cast<float>(maskingOfEye(distribution, alpha, eye, sine))};
  const Place first = placeOf(eye / ((1.0 + sine) * width));   // tan θ₁
  const Place second = placeOf((1.0 + sine) / (eye * width));  // tan θ₂
  double whole = 0.0;
  double grazing = 0.0;
  double tilt = 0.0;
  const SharePlaces& places = placesFor(distribution);
  const auto add = HWY_DYNAMIC_DISPATCH(addStretch);
  add(distribution, setting, places, {0.0, first.y, first.to_one, true}, whole, grazing, tilt);
  if (second.to_one < first.to_one)
    add(distribution, setting, places, {first.y, second.y, second.to_one, false}, whole, grazing, tilt);
  if (is_cloth) return {static_cast<float>(whole), 0.0f};
  return {static_cast<float>(whole - grazing), static_cast<float>(grazing), static_cast<float>(tilt)};
}

float averageAlbedo(Distribution distribution, float perceptual_roughness) {
  static const QuadratureRule kRule = gatheredRule(24);
  double mean = 0.0;
  for (std::size_t i = 0; i < kRule.places.size(); ++i) {
    const auto cosine = static_cast<float>(kRule.places[i]);
    const double whole = directionalAlbedo(distribution, perceptual_roughness, cosine).total();
    mean += kRule.weights[i] * kRule.places[i] * whole;  // the rule's weights sum to 1
  }
  return static_cast<float>(2.0 * mean);
}

}  // namespace mirrorball
#endif
