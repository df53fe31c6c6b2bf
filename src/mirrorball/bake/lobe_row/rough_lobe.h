#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// How light that a rough surface reflects towards an eye is shared out over the directions it comes from: GGX with
/// Smith's masking and shadowing correlated by height, after one bounce. The surface's normal is +Z, the eye lies in
/// the plane of x and z.
///
/// It is symmetric about that plane, so half of the directions stand for all. They crowd about the mirror direction,
/// on circles whose distance grows in proportion from α / 2 on.
struct RoughLobe {
  float alpha = 0.0f;
  double cosine = 0.0;       ///< n·v
  glm::dvec3 mirrored{0.0};  ///< the mirror direction
  double grazing = 0.0;      ///< of what a dielectric reflects, the share that Schlick's term adds at this angle

  std::vector<glm::dvec3> directions;  ///< y > 0
  std::vector<double> solid_angles;    ///< [sr]; twice that of the half: their sum is the sphere's
  std::vector<double> of_metal;        ///< [1/sr] integral 1: facets that reflect all
  std::vector<double> of_dielectric;   ///< [1/sr] integral 1: by Schlick's form, 4 % at normal incidence

  /// What they reflect at normal incidence.
  static constexpr double kDielectric = 0.04;

  int points = 0;  ///< on half of a circle: directions go circle by circle

  std::size_t size() const { return directions.size(); }

  /// perceptual_roughness  in [0.05, 1]
  /// cosine                n·v in (0, 1)
  /// circles               of directions; points on half of each: a third as many
  static RoughLobe make(float perceptual_roughness, double cosine, int circles);
};

/// What each of some 20 patches of directions has of an integral.
std::vector<double> sharesOfPatches(const RoughLobe& lobe, const std::vector<double>& values);

/// The relative L2 distance of a mixture of lobes from one of the two: √(∫ (K − M)² / ∫ K²).
double relativeDistance(const RoughLobe& lobe, const std::vector<double>& target, const std::vector<double>& mixture);

}  // namespace mirrorball
