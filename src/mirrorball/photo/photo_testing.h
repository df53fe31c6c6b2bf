#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include <glm/gtc/constants.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/photo/pinhole.h"

namespace mirrorball::testing {

/// A mirror ball of radius 1 before a camera in the origin that looks along −Z, photographed by tracing rays: nothing
/// here uses the formulas of BallView.
struct BallScene {
  glm::ivec2 size{480, 360};
  double focal_px = 900.0;
  glm::dvec3 center{0.0, 0.0, -8.0};
  RadianceFunction environment;  ///< seen in the ball
  RadianceFunction background;   ///< seen beside it; none: the environment
  double turn_deg = 0.0;         ///< camera and ball's axis turned about the vertical, 90: from +X
  double reflectance = 0.75;     ///< 1 would make the rim invisible: there the ball shows what stands right behind it
  /// Things that stand before everything: their light, or nothing.
  std::function<std::optional<glm::vec3>(glm::dvec2 position_px)> foreground;
  int rays_per_side = 3;

  glm::vec3 lightAt(glm::dvec2 position_px) const {
    if (foreground)
      if (const auto light = foreground(position_px)) return *light;
    const glm::dvec2 middle = glm::dvec2(size) / 2.0;
    const glm::dvec3 ray =
        glm::normalize(glm::dvec3((position_px.x - middle.x) / focal_px, (middle.y - position_px.y) / focal_px, -1.0));
    const double b = glm::dot(ray, center);
    const double discriminant = b * b - glm::dot(center, center) + 1.0;
    if (discriminant < 0.0) return background ? background(glm::vec3(ray)) : environment(world(ray));
    const glm::dvec3 normal = (b - std::sqrt(discriminant)) * ray - center;
    return static_cast<float>(reflectance) * environment(world(glm::reflect(ray, normal)));
  }

  Image photograph() const {
    Image image(size.x, size.y, 3);
    parallelFor(std::size_t(size.y), 8, [&](std::size_t begin, std::size_t end) {
      for (int y = int(begin); y < int(end); ++y)
        for (int x = 0; x < size.x; ++x) {
          glm::vec3 sum(0.0f);
          for (int j = 0; j < rays_per_side; ++j)
            for (int i = 0; i < rays_per_side; ++i)
              sum += lightAt(glm::dvec2(x, y) + (glm::dvec2(i, j) + 0.5) / double(rays_per_side));
          sum /= static_cast<float>(rays_per_side * rays_per_side);
          for (int c = 0; c < 3; ++c) image.texel(x, y)[c] = sum[c];
        }
    });
    return image;
  }

  double distance() const { return glm::length(center); }

  /// Positions on the ball's true outline.
  std::vector<glm::dvec2> outline(int count) const {
    const glm::dvec3 axis = glm::normalize(center);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 v = glm::cross(u, axis);
    const double half_angle = std::asin(1.0 / distance());
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
      const double angle = glm::two_pi<double>() * i / count;
      const glm::dvec3 ray =
          std::cos(half_angle) * axis + std::sin(half_angle) * (std::cos(angle) * u + std::sin(angle) * v);
      points.push_back(glm::dvec2(size) / 2.0 + focal_px * glm::dvec2(ray.x, -ray.y) / -ray.z);
    }
    return points;
  }

 private:
  glm::vec3 world(glm::dvec3 d) const {
    const double c = std::cos(glm::radians(turn_deg)), s = std::sin(glm::radians(turn_deg));
    return {c * d.x + s * d.z, d.y, -s * d.x + c * d.z};
  }
};

/// Adds noise like a sensor's: a part that grows with the root of the light, and a constant one. Always the same.
inline void addNoise(Image& image, float shot, float read, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  for (float& sample : image.samples())
    sample = std::max(0.0f, sample + normal(random) * (shot * std::sqrt(std::max(sample, 0.0f)) + read));
}

/// Codes of a camera that exposes for `exposure`: `encode` lays light 0 … 1 onto 0 … 1.
inline Image8 exposed(const Image& light, double exposure, const std::function<double(double)>& encode) {
  Image8 codes(light.width(), light.height(), 4, 255);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const double captured = std::min(1.0, exposure * double(light.texel(x, y)[c]));
        codes.texel(x, y)[c] = static_cast<std::uint8_t>(std::lround(255.0 * encode(captured)));
      }
  return codes;
}

}  // namespace mirrorball::testing
