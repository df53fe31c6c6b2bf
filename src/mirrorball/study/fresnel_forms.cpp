#include "mirrorball/study/fresnel_forms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "formula/bsdf.h"
#include "mirrorball/study/page/plot.h"

namespace mirrorball {
namespace {

constexpr int kCosines = 512;  // and both ends
constexpr float kDeepestOfF82 = 1.0f / 7.0f;

// The ranges of the material's parameters.
constexpr double kGreatestScale = 10.0;
constexpr double kLeastPower = 0.1;
constexpr double kGreatestPower = 20.0;

double cosineAt(int index) { return double(index) / kCosines; }

/// The place between two numbers where a function with a single valley is least (golden section).
double leastOf(double low, double high, double tolerance, const std::function<double(double)>& function) {
  constexpr double kGolden = 0.6180339887498949;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double at_left = function(left);
  double at_right = function(right);
  while (high - low > tolerance) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = function(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = function(right);
    }
  }
  return (low + high) / 2.0;
}

struct Line {
  double offset;
  double scale;
  double greatest_error;
};

/// Of one scale the best offset lies in the middle of what is left.
Line bestOffset(const std::vector<double>& x, const std::vector<double>& y, double scale) {
  double least = y[0] - scale * x[0];
  double most = least;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double rest = y[i] - scale * x[i];
    least = std::min(least, rest);
    most = std::max(most, rest);
  }
  const double offset = std::clamp((least + most) / 2.0, 0.0, 1.0);
  return {offset, scale, std::max(most - offset, offset - least)};
}

Line bestLine(const std::vector<double>& y, double power) {
  std::vector<double> x;
  for (int i = 0; i <= kCosines; ++i) x.push_back(std::pow(1.0 - cosineAt(i), power));
  const double scale =
      leastOf(0.0, kGreatestScale, 1e-4, [&](double tried) { return bestOffset(x, y, tried).greatest_error; });
  return bestOffset(x, y, scale);
}

float greatestError(const FresnelCurves& curves, FresnelForm form) {
  float greatest = 0.0f;
  for (int i = 0; i <= kCosines; ++i) {
    const auto cosine = static_cast<float>(cosineAt(i));
    const float error = curves.reflectance(form, cosine) - curves.reflectance(FresnelForm::exact, cosine);
    greatest = std::max(greatest, std::abs(error));
  }
  return greatest;
}

FresnelCurves curvesOf(std::string name, float n, float k) {
  FresnelCurves curves{.name = std::move(name), .n = n, .k = k};
  curves.f0 = curves.reflectance(FresnelForm::exact, 1.0f);
  const float schlick = curves.reflectance(FresnelForm::schlick, kDeepestOfF82);
  curves.f82_tint = std::clamp(curves.reflectance(FresnelForm::exact, kDeepestOfF82) / schlick, 0.0f, 1.0f);
  curves.empirical = fitEmpirical([&](float cosine) { return curves.reflectance(FresnelForm::exact, cosine); });
  curves.schlick_error = greatestError(curves, FresnelForm::schlick);
  curves.f82_error = greatestError(curves, FresnelForm::f82);
  return curves;
}

/// In the order of FresnelForm.
constexpr std::array<const char*, 4> kLegend{"exact", "Schlick", "F82, its tint fitted", "empirical, fitted"};

Plot plotOf(const FresnelCurves& curves, const std::string& title) {
  const std::string whole_title = title + (curves.name.empty() ? "" : ", " + curves.name);
  Plot plot{.title = whole_title,
            .x_label = "angle of incidence, degrees",
            .x_step = 15.0,
            .y_label = "reflectance of " + whole_title,
            .marks_points = false};
  for (std::size_t form = 0; form < kFresnelFormNames.size(); ++form) {
    Curve curve{.name = kLegend[form]};
    for (int degrees = 0; degrees <= 90; ++degrees)
      curve.points.emplace_back(degrees, curves.reflectanceAtAngle(FresnelForm(form), degrees));
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

EmpiricalFit fitEmpirical(const std::function<float(float cosine)>& reflectance) {
  std::vector<double> y;
  for (int i = 0; i <= kCosines; ++i) y.push_back(double(reflectance(static_cast<float>(cosineAt(i)))));
  const auto errorOf = [&](double log_power) { return bestLine(y, std::exp(log_power)).greatest_error; };
  // A first look over all powers: there may be more than one valley.
  constexpr int kPowers = 40;
  const double first = std::log(kLeastPower);
  const double step = (std::log(kGreatestPower) - first) / kPowers;
  int best = 0;
  double least = errorOf(first);
  for (int i = 1; i <= kPowers; ++i)
    if (const double error = errorOf(first + i * step); error < least) {
      best = i;
      least = error;
    }
  const double low = first + std::max(best - 1, 0) * step;
  const double high = first + std::min(best + 1, kPowers) * step;
  const double power = std::exp(leastOf(low, high, 1e-5, errorOf));
  const Line line = bestLine(y, power);
  return {static_cast<float>(line.offset), static_cast<float>(line.scale), static_cast<float>(power),
          static_cast<float>(line.greatest_error)};
}

float FresnelCurves::reflectance(FresnelForm form, float cosine) const {
  switch (form) {
    case FresnelForm::exact:
      return k > 0.0f ? formula::fresnelConductor1(cosine, n, k) : formula::fresnelDielectric(cosine, n);
    case FresnelForm::schlick:
      return formula::fresnelSchlick(cosine, glm::vec3(f0)).x;
    case FresnelForm::f82:
      return formula::fresnelF82(cosine, glm::vec3(f0), glm::vec3(f82_tint)).x;
    case FresnelForm::empirical:
      return formula::fresnelEmpirical(cosine, empirical.offset, empirical.scale, empirical.power);
  }
  return 0.0f;
}

float FresnelCurves::reflectanceAtAngle(FresnelForm form, int degrees) const {
  return reflectance(form, degrees == 90 ? 0.0f : std::cos(glm::radians(static_cast<float>(degrees))));
}

Result<std::vector<FresnelCurves>> fresnelCurves(const Material& material) {
  if (material.metallic == 0.0f) return std::vector{curvesOf("", material.ior, 0.0f)};
  const bool has_index = material.conductor_k.x + material.conductor_k.y + material.conductor_k.z > 0.0f;
  if (material.metallic < 1.0f || !has_index)
    return fail(ErrorCode::usage,
                "the material " + material.name +
                    " has no index of refraction that Fresnel's equations would take; name a metal or "
                    "a glass, such as gold or bk7");
  std::vector<FresnelCurves> curves;
  constexpr std::array<const char*, 3> kChannels{"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel)
    curves.push_back(
        curvesOf(kChannels[std::size_t(channel)], material.conductor_n[channel], material.conductor_k[channel]));
  return curves;
}

std::string fresnelPlotOf(const std::vector<FresnelCurves>& curves, const std::string& title) {
  std::vector<Plot> plots;
  for (const FresnelCurves& each : curves) plots.push_back(plotOf(each, title));
  return svgFileOf(plots);
}

}  // namespace mirrorball
