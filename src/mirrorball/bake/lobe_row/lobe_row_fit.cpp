#include "mirrorball/bake/lobe_row/lobe_row_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "formula/bsdf.h"
#include "mirrorball/base/linear_system.h"

namespace mirrorball {
namespace {

/// Of a lobe's α over the surface's. Narrower ones would stand beside each other without touching, where the true
/// lobe is a streak.
constexpr double kNarrowest = 0.12;

/// The lobes of a row with numbers of full precision, which differences need.
struct RowLobe {
  double offset, roughness, weight, grazing_weight;
};

std::vector<RowLobe> lobesOf(const RowParameters& row) {
  std::vector<RowLobe> lobes;
  double weight = 0.0;
  double grazing_weight = 0.0;
  for (auto number = row.values.begin(); number != row.values.end(); number += 4) {
    lobes.push_back({number[0], std::sqrt(kNarrowest + std::exp(number[1])), std::exp(number[2]), std::exp(number[3])});
    weight += lobes.back().weight;
    grazing_weight += lobes.back().grazing_weight;
  }
  for (RowLobe& lobe : lobes) {
    lobe.weight /= weight;
    lobe.grazing_weight /= grazing_weight;
  }
  return lobes;
}

/// The integral of formula::ggxLobe: 4π ∫ (a² / (a² + k s))² (1 − 2 s) ds from 0 to ½, with k = 1 − a².
double lobeIntegral(double alpha) {
  const double a2 = alpha * alpha;
  const double k = 1.0 - a2;
  const auto antiderivative = [&](double q) { return -(1.0 + 2.0 * a2 / k) / q - 2.0 / k * std::log(q); };
  return 4.0 * std::numbers::pi * a2 * a2 / k * (antiderivative(a2 + k / 2.0) - antiderivative(a2));
}

/// formula::lobeOfRow and formula::ggxLobe in full precision.
RowMixture mixtureOfLobes(const RoughLobe& lobe, const std::vector<RowLobe>& row) {
  RowMixture mixture{std::vector<double>(lobe.size(), 0.0), std::vector<double>(lobe.size(), 0.0)};
  const glm::dvec3 towards_normal = glm::dvec3(0, 0, 1) - lobe.cosine * lobe.mirrored;
  for (const RowLobe& one : row) {
    const glm::dvec3 middle = glm::normalize(lobe.mirrored + double(lobe.alpha) * one.offset * towards_normal);
    const double alpha = std::min(double(lobe.alpha) * one.roughness * one.roughness, 0.9999);
    const double a2 = alpha * alpha;
    const double scale = 1.0 / lobeIntegral(alpha);
    const double of_dielectric = one.weight + lobe.grazing * (one.grazing_weight - one.weight);
    for (std::size_t i = 0; i < lobe.size(); ++i) {
      const glm::dvec3 between = lobe.directions[i] - middle;
      const double s = glm::dot(between, between) / 4.0;
      if (s >= 0.5) continue;
      const double q = a2 / (a2 + (1.0 - a2) * s);
      const double value = scale * q * q * (1.0 - 2.0 * s);
      mixture.of_metal[i] += one.weight * value;
      mixture.of_dielectric[i] += of_dielectric * value;
    }
  }
  return mixture;
}

/// What patches of directions send counts as a whole, beside the distance: light changes slowly from place to place,
/// and sees the sum of a long tail rather than the height of a peak.
constexpr double kPatches = 2.0;

/// The sum that is to be least, and what its steps need.
class RowProblem {
 public:
  RowProblem(const RoughLobe& lobe, const RowPrior& prior)
      : lobe_(lobe),
        prior_(prior),
        metal_shares_(sharesOfPatches(lobe, lobe.of_metal)),
        dielectric_shares_(sharesOfPatches(lobe, lobe.of_dielectric)) {
    double metal = 0.0;
    double dielectric = 0.0;
    for (std::size_t i = 0; i < lobe.size(); ++i) {
      metal += lobe.solid_angles[i] * lobe.of_metal[i] * lobe.of_metal[i];
      dielectric += lobe.solid_angles[i] * lobe.of_dielectric[i] * lobe.of_dielectric[i];
    }
    for (std::size_t i = 0; i < lobe.size(); ++i) {
      metal_scales_.push_back(std::sqrt(lobe.solid_angles[i] / metal));
      dielectric_scales_.push_back(std::sqrt(lobe.solid_angles[i] / dielectric));
    }
  }

  /// What the row leaves to be explained: the sum of its squares is to be least.
  std::vector<double> residuals(const RowParameters& row) const {
    const RowMixture mixture = mixtureOfLobes(lobe_, lobesOf(row));
    std::vector<double> left;
    for (std::size_t i = 0; i < lobe_.size(); ++i) {
      left.push_back(metal_scales_[i] * (lobe_.of_metal[i] - mixture.of_metal[i]));
      left.push_back(dielectric_scales_[i] * (lobe_.of_dielectric[i] - mixture.of_dielectric[i]));
    }
    const std::vector<double> metal = sharesOfPatches(lobe_, mixture.of_metal);
    const std::vector<double> dielectric = sharesOfPatches(lobe_, mixture.of_dielectric);
    for (std::size_t i = 0; i < metal.size(); ++i) {
      left.push_back(kPatches * (metal_shares_[i] - metal[i]));
      left.push_back(kPatches * (dielectric_shares_[i] - dielectric[i]));
    }
    for (std::size_t k = 0; k < row.values.size(); ++k) {
      // Weights of lobes that do not count would go on and on.
      left.push_back(1e-3 * row.values[k]);
      if (prior_.parameters)
        left.push_back(std::sqrt(prior_.strength) * (row.values[k] - prior_.parameters->values[k]));
    }
    return left;
  }

 private:
  const RoughLobe& lobe_;
  RowPrior prior_;
  std::vector<double> metal_shares_, dielectric_shares_;
  std::vector<double> metal_scales_, dielectric_scales_;
};

double squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// The equations JᵀJ x = −Jᵀr of a step, J being how the residuals change with the row.
std::vector<std::vector<double>> normalEquations(const RowProblem& problem, const RowParameters& row,
                                                 const std::vector<double>& residuals) {
  constexpr double kStep = 1e-4;
  const std::size_t count = row.values.size();
  std::vector<std::vector<double>> slopes;
  for (std::size_t k = 0; k < count; ++k) {
    RowParameters moved = row;
    moved.values[k] += kStep;
    slopes.push_back(problem.residuals(moved));
    for (std::size_t i = 0; i < residuals.size(); ++i) slopes[k][i] = (slopes[k][i] - residuals[i]) / kStep;
  }
  std::vector<std::vector<double>> equations(count, std::vector<double>(count + 1, 0.0));
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t m = 0; m < count; ++m)
      for (std::size_t i = 0; i < residuals.size(); ++i) equations[k][m] += slopes[k][i] * slopes[m][i];
    for (std::size_t i = 0; i < residuals.size(); ++i) equations[k][count] -= slopes[k][i] * residuals[i];
  }
  return equations;
}

RowParameters stepped(RowParameters row, std::vector<std::vector<double>> equations, double damping) {
  constexpr double kLongest = 0.5;
  for (std::size_t k = 0; k < equations.size(); ++k) equations[k][k] *= 1.0 + damping;
  const std::vector<double> step = solved(std::move(equations));
  for (std::size_t k = 0; k < row.values.size(); ++k) row.values[k] += std::clamp(step[k], -kLongest, kLongest);
  return row;
}

}  // namespace

RowParameters RowParameters::even(int lobes) {
  RowParameters row;
  for (int i = 0; i < lobes; ++i) {
    const double offset = 3.0 * (i + 0.5) / lobes - 1.0;
    row.values.insert(row.values.end(), {offset, -0.7, 0.0, 0.0});
  }
  return row;
}

std::vector<glm::vec4> texelsOf(const RowParameters& row) {
  std::vector<glm::vec4> texels;
  for (const RowLobe& lobe : lobesOf(row))
    texels.emplace_back(lobe.offset, lobe.roughness, lobe.weight, lobe.grazing_weight);
  return texels;
}

RowMixture mixtureOf(const RoughLobe& lobe, std::span<const glm::vec4> row) {
  std::vector<RowLobe> lobes;
  for (const glm::vec4& texel : row) lobes.push_back({texel.x, texel.y, texel.z, texel.w});
  return mixtureOfLobes(lobe, lobes);
}

RowParameters fitted(const RoughLobe& lobe, RowParameters row, const RowPrior& prior, int steps) {
  const RowProblem problem(lobe, prior);
  std::vector<double> residuals = problem.residuals(row);
  double damping = 1e-3;
  for (int step = 0; step < steps; ++step) {
    const auto equations = normalEquations(problem, row, residuals);
    const double before = squares(residuals);
    double after = before;
    for (int attempt = 0; attempt < 8 && after >= before; ++attempt) {
      const RowParameters tried = stepped(row, equations, damping);
      std::vector<double> left = problem.residuals(tried);
      after = squares(left);
      if (after < before) {
        row = tried;
        residuals = std::move(left);
        damping = std::max(damping / 4.0, 1e-9);
      } else {
        damping *= 4.0;
      }
    }
    if (after > before * (1.0 - 1e-7)) break;
  }
  return row;
}

}  // namespace mirrorball
