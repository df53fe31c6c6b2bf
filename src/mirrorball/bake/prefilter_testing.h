#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// A panorama of which each texel is the light at its centre.
inline EnvironmentMap panoramaOf(int width, int height, const std::function<glm::vec3(glm::vec3)>& light) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const glm::vec3 value = light(directionAt(Projection::equirect, {0, uv}));
      for (int c = 0; c < 3; ++c) image.texel(x, y)[c] = value[c];
    }
  return EnvironmentMap(Projection::equirect, ImageSet(std::move(image)));
}

/// The truth: the sum over all texels of a panorama, in double, each at its centre with the solid angle of its area.
///
/// kernel   of s = sin²(θ/2); any scale, since the sum is divided by that of white texels
inline glm::dvec3 meanOfTexels(const EnvironmentMap& panorama, const std::function<double(double)>& kernel,
                               glm::vec3 direction) {
  const Image& image = panorama.face(0);
  const glm::dvec3 middle = glm::normalize(glm::dvec3(direction));
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    const double theta = std::numbers::pi * (y + 0.5) / image.height();
    const double area =
        std::cos(std::numbers::pi * y / image.height()) - std::cos(std::numbers::pi * (y + 1) / image.height());
    for (int x = 0; x < image.width(); ++x) {
      const double phi = 2.0 * std::numbers::pi * (x + 0.5) / image.width();
      const glm::dvec3 texel(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
      const glm::dvec3 difference = texel - middle;
      const double weight = area * kernel(glm::dot(difference, difference) / 4.0);
      sum += weight * glm::dvec3(rgbAt(image, x, y));
      weights += weight;
    }
  }
  return sum / weights;
}

/// GGX with n = v = r, written anew in double.
inline std::function<double(double)> ggxKernel(double perceptual_roughness) {
  const double alpha2 = std::pow(perceptual_roughness, 4.0);
  return [alpha2](double s) {
    const double n_l = 1.0 - 2.0 * s;
    const double n_h2 = 1.0 - s;
    const double q = n_h2 * (alpha2 - 1.0) + 1.0;
    return n_l <= 0.0 ? 0.0 : n_l / (q * q);
  };
}

}  // namespace mirrorball
