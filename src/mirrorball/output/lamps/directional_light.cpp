#include "mirrorball/output/lamps/directional_light.h"

#include <algorithm>

namespace mirrorball {

std::vector<DirectionalLight> directionalLights(std::span<const MapLamp> lamps) {
  std::vector<DirectionalLight> lights;
  for (const MapLamp& lamp : lamps) {
    const float greatest = std::max({lamp.irradiance.x, lamp.irradiance.y, lamp.irradiance.z});
    lights.push_back({.name = "lamp " + std::to_string(lights.size() + 1),
                      .towards = lamp.direction,
                      .color = greatest > 0.0f ? lamp.irradiance / greatest : glm::vec3(1.0f),
                      .intensity = greatest,
                      .angular_size_rad = lamp.angular_size_rad});
  }
  return lights;
}

}  // namespace mirrorball
