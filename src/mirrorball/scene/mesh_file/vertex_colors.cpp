#include "mirrorball/scene/mesh_file/vertex_colors.h"

#include <algorithm>
#include <cmath>

#include "formula/color.h"

namespace mirrorball {

glm::vec3 linearFromCodes(glm::vec3 codes) {
  glm::vec3 linear(1.0f);
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isnan(codes[channel])) linear[channel] = formula::linearFromSrgb1(std::clamp(codes[channel], 0.0f, 1.0f));
  return linear;
}

Material materialOfColors(bool has_colors) {
  Material material;
  if (has_colors) material.base_color = glm::vec3(1.0f);
  return material;
}

}  // namespace mirrorball
