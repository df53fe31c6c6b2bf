#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "blur_methods.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball::bench {

/// An environment as the panorama whose texels all methods are given: fine enough for the sum over them to be the
/// integral under the narrowest lobe (LightHarmonics has the reason), without negative light.
///
/// errors   as loadEnvironment's
Result<EnvironmentMap> panoramaFor(const std::string& environment, const std::vector<BlurTarget>& targets);

/// A few hundred texels of a cube at which errors are taken: all of a small one; else of each face the corners, the
/// middle and others anywhere. Always the same.
std::vector<MapPosition> pickedTexels(int size);

/// The truth that the methods are held to, in double: the sum over all texels of a panorama, each a point of light at
/// its centre with the solid angle of its area, under GGX with n = v = r or the cosine,
/// divided by that of white texels.
class TexelSums {
 public:
  /// panorama   must outlive it
  explicit TexelSums(const EnvironmentMap& panorama);

  /// cost     about 2 ns a texel
  glm::dvec3 mean(const BlurTarget& target, glm::vec3 direction) const;

 private:
  template <typename Kernel>
  glm::dvec3 mean(const Kernel& kernel, glm::vec3 direction) const;

  const Image& image_;
  std::vector<glm::dvec2> columns_;  // sin and cos of the longitude
};

/// What is found at the picked texels against the truth, over all three channels.
struct Error {
  double relative_rms;  ///< root of the mean square of the differences, over that of the truth
  double mean;          ///< of the relative differences
  double max;           ///< of them
};
Error errorOf(const std::vector<glm::dvec3>& found, const std::vector<glm::dvec3>& truth);

}  // namespace mirrorball::bench
