#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// Radiance as a function of the unit direction that it arrives from; safe to call from many threads.
using RadianceFunction = std::function<glm::vec3(glm::vec3 direction)>;

/// The light around a point: images, or a function.
class Environment {
 public:
  explicit Environment(EnvironmentMap map) : light_(std::move(map)) {}
  /// panorama_height  how many texels high a panorama must be to show all its detail
  Environment(RadianceFunction radiance, int panorama_height)
      : light_(std::move(radiance)), panorama_height_(panorama_height) {}

  glm::vec3 radiance(glm::vec3 direction) const;

  /// The images, if the light is held in images.
  const EnvironmentMap* map() const { return std::get_if<EnvironmentMap>(&light_); }
  EnvironmentMap* map() { return std::get_if<EnvironmentMap>(&light_); }

  /// The memory of its images.
  std::uint64_t bytes() const;

  /// The size that shows all its detail in that projection.
  int naturalSize(Projection projection) const;

  /// Texels per radian that are worth sampling.
  float texelDensity() const;

 private:
  std::variant<EnvironmentMap, RadianceFunction> light_;
  int panorama_height_ = 0;
};

}  // namespace mirrorball
