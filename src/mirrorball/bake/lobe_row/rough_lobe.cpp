#include "mirrorball/bake/lobe_row/rough_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

constexpr double kPi = std::numbers::pi;

/// What facets that reflect all send from `light` to `eye`, times the cosine of the light.
double reflectedShare(float alpha, const glm::dvec3& eye, const glm::dvec3& light) {
  if (light.z <= 0.0) return 0.0;
  const glm::vec3 l(light);
  return double(formula::evalGgx(glm::vec2(alpha), glm::vec3(eye), l)) * double(l.z);
}

double schlickTerm(const glm::dvec3& eye, const glm::dvec3& light) {
  const double cosine = glm::dot(eye, glm::normalize(eye + light));
  return std::pow(1.0 - std::min(cosine, 1.0), 5.0);
}

double integral(const RoughLobe& lobe, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < lobe.size(); ++i) sum += lobe.solid_angles[i] * values[i];
  return sum;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// With s = sin²(θ/2) of the angle to the mirror direction, solid angles are 4π ds.
void placeDirections(RoughLobe& lobe, int circles) {
  const int points = lobe.points = circles / 3;
  const double begin = double(lobe.alpha) * double(lobe.alpha) / 4.0;
  const double growth = std::log(1.0 + 1.0 / begin);
  const glm::dvec3 up(lobe.cosine, 0.0, std::sqrt(1.0 - lobe.cosine * lobe.cosine));  // across it, towards the normal
  for (int circle = 0; circle < circles; ++circle) {
    const double grown = begin * std::exp(growth * (circle + 0.5) / circles);
    const double s = std::min(grown - begin, 1.0);
    const double step = grown * growth / circles;
    for (int point = 0; point < points; ++point) {
      const double turn = kPi * (point + 0.5) / points;
      const glm::dvec3 across = std::cos(turn) * up + std::sin(turn) * glm::dvec3(0, 1, 0);
      lobe.directions.push_back((1.0 - 2.0 * s) * lobe.mirrored + 2.0 * std::sqrt(s * (1.0 - s)) * across);
      lobe.solid_angles.push_back(4.0 * kPi * step / points);
    }
  }
}

}  // namespace

RoughLobe RoughLobe::make(float perceptual_roughness, double cosine, int circles) {
  RoughLobe lobe;
  lobe.alpha = formula::alphaFromPerceptualRoughness(perceptual_roughness);
  lobe.cosine = cosine;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const glm::dvec3 eye(sine, 0.0, cosine);
  lobe.mirrored = {-sine, 0.0, cosine};
  placeDirections(lobe, circles);

  std::vector<double> at_grazing;
  for (const glm::dvec3& light : lobe.directions) {
    lobe.of_metal.push_back(reflectedShare(lobe.alpha, eye, light));
    at_grazing.push_back(lobe.of_metal.back() * schlickTerm(eye, light));
  }
  const double whole = integral(lobe, lobe.of_metal);
  scale(lobe.of_metal, 1.0 / whole);
  scale(at_grazing, (1.0 - kDielectric) / whole);
  for (std::size_t i = 0; i < lobe.size(); ++i)
    lobe.of_dielectric.push_back(kDielectric * lobe.of_metal[i] + at_grazing[i]);
  const double of_dielectric = integral(lobe, lobe.of_dielectric);
  scale(lobe.of_dielectric, 1.0 / of_dielectric);
  lobe.grazing = 1.0 - kDielectric / of_dielectric;
  return lobe;
}

std::vector<double> sharesOfPatches(const RoughLobe& lobe, const std::vector<double>& values) {
  constexpr int kAround = 3;
  constexpr int kOutwards = 7;
  const auto patchOf = [](std::size_t index, std::size_t count, int patches) {
    return index * std::size_t(patches) / count;
  };
  const auto points = std::size_t(lobe.points);
  std::vector<double> shares(std::size_t(kAround * kOutwards), 0.0);
  for (std::size_t i = 0; i < lobe.size(); ++i)
    shares[patchOf(i / points, lobe.size() / points, kOutwards) * kAround + patchOf(i % points, points, kAround)] +=
        lobe.solid_angles[i] * values[i];
  return shares;
}

double relativeDistance(const RoughLobe& lobe, const std::vector<double>& target, const std::vector<double>& mixture) {
  double apart = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < lobe.size(); ++i) {
    apart += lobe.solid_angles[i] * (target[i] - mixture[i]) * (target[i] - mixture[i]);
    whole += lobe.solid_angles[i] * target[i] * target[i];
  }
  return std::sqrt(apart / whole);
}

}  // namespace mirrorball
