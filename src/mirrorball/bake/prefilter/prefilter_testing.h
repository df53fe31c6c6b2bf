#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/prefilter/prefilter.h"
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
  std::vector<glm::dvec2> meridians;  // their x and z on the equator
  for (int x = 0; x < image.width(); ++x) {
    const double phi = 2.0 * std::numbers::pi * (x + 0.5) / image.width();
    meridians.emplace_back(std::sin(phi), -std::cos(phi));
  }
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    const double theta = std::numbers::pi * (y + 0.5) / image.height();
    const double area =
        std::cos(std::numbers::pi * y / image.height()) - std::cos(std::numbers::pi * (y + 1) / image.height());
    for (int x = 0; x < image.width(); ++x) {
      const glm::dvec2 meridian = std::sin(theta) * meridians[std::size_t(x)];
      const glm::dvec3 texel(meridian.x, std::cos(theta), meridian.y);
      const glm::dvec3 difference = texel - middle;
      const double weight = area * kernel(glm::dot(difference, difference) / 4.0);
      if (weight == 0.0) continue;
      sum += weight * glm::dvec3(rgbAt(image, x, y));
      weights += weight;
    }
  }
  return sum / weights;
}

/// The angles of a light l about the normal n of a surface that is seen along its normal, n = v = r.
struct LightAngles {
  double n_l;
  double n_h;     ///< h = (n + l) / |n + l|
  double sine_h;  ///< of the angle between n and h
};

inline LightAngles lightAngles(double s) {
  const glm::dvec2 normal(0.0, 1.0);
  const glm::dvec2 light(2.0 * std::sqrt(s * (1.0 - s)), 1.0 - 2.0 * s);  // s = sin²(θ/2)
  const glm::dvec2 half = glm::normalize(normal + light);
  return {light.y, half.y, half.x};
}

/// What a lobe weighs light with, of s = sin²(θ/2) and up to a factor. Those below are written anew in double, as they
/// are published, and share nothing with formula/.
using LobeKernel = std::function<double(double s)>;

/// `weight` of the lights above the horizon.
inline LobeKernel kernelOf(const std::function<double(const LightAngles&)>& weight) {
  return [weight](double s) { return s < 0.5 ? weight(lightAngles(s)) : 0.0; };
}

/// D(h) n·l, where D = α² / π ((n·h)² (α² − 1) + 1)² (Walter et al. 2007, eq. 33).
inline LobeKernel ggxKernel(double perceptual_roughness) {
  const double alpha2 = std::pow(perceptual_roughness, 4.0);
  return kernelOf([alpha2](const LightAngles& at) {
    const double q = at.n_h * at.n_h * (alpha2 - 1.0) + 1.0;
    return alpha2 / (std::numbers::pi * q * q) * at.n_l;
  });
}

/// D(h) n·l, where D ∝ (n·h)^p (Blinn 1977) and p = 2/α² − 2 (Walter et al. 2007, p. 8).
inline LobeKernel blinnKernel(double perceptual_roughness) {
  const double exponent = 2.0 / std::pow(perceptual_roughness, 4.0) - 2.0;
  return kernelOf([exponent](const LightAngles& at) { return std::pow(at.n_h, exponent) * at.n_l; });
}

/// (r·l)^q (Phong 1975), q a quarter of Blinn's p and at least 1.
inline LobeKernel phongKernel(double perceptual_roughness) {
  const double exponent = std::max((2.0 / std::pow(perceptual_roughness, 4.0) - 2.0) / 4.0, 1.0);
  return kernelOf([exponent](const LightAngles& at) { return std::pow(at.n_l, exponent); });
}

/// D(h) n·l, where D ∝ (sin θ_h)^(1/α) (Estevez & Kulla 2017, eq. 2).
inline LobeKernel charlieKernel(double perceptual_roughness) {
  const double exponent = 1.0 / (perceptual_roughness * perceptual_roughness);
  return kernelOf([exponent](const LightAngles& at) { return std::pow(at.sine_h, exponent) * at.n_l; });
}

inline LobeKernel cosineKernel() {
  return kernelOf([](const LightAngles& at) { return at.n_l; });
}

/// Smooth and fine light, in another colour everywhere.
inline glm::vec3 landscape(glm::vec3 d) {
  const float ground = d.y < 0.0f ? 0.2f : 1.0f;
  const float fine = 0.5f + 0.5f * std::sin(40.0f * d.x) * std::cos(31.0f * d.z);
  return {ground * (0.3f + fine), ground * (0.8f + 0.5f * d.y), 0.2f + 0.2f * fine + std::max(d.z, 0.0f)};
}

/// The same under a small sun.
inline glm::vec3 landscapeWithSun(glm::vec3 d) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.4f, 0.7f, -0.5f));
  const bool is_sun = std::acos(std::clamp(glm::dot(d, sun), -1.0f, 1.0f)) < glm::radians(0.7f);
  return is_sun ? glm::vec3(1e5f, 0.8e5f, 0.5e5f) : landscape(d);
}

inline ImageSet chainOf(const Environment& environment, const PrefilterOptions& options) {
  const std::vector<PrefilterLevel> levels = prefilterLevels(options);
  const auto light = LightHarmonics::make(environment, lobesOf(levels));
  return *prefilter(environment, *light, levels);
}

inline ImageSet chainOf(const EnvironmentMap& map, int size) { return chainOf(Environment(map), {.size = size}); }

/// Of a matt white surface: irradiance / π.
inline ImageSet irradianceCubeOf(const EnvironmentMap& map, int size) {
  const Lobe lobe = Lobe::cosine();
  const auto light = LightHarmonics::make(Environment(map), {lobe});
  return cubeOf(*light, lobe, size).value().takeImages();
}

}  // namespace mirrorball
