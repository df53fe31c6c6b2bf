#pragma once

#include <glm/glm.hpp>

#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball {

/// The uniform `height_map` of shaders/height_sampler.glsl.
inline glm::vec4 heightMapUniform(const HeightTexture& texture) {
  const formula::HeightMap map = heightMapOf(texture);
  return {map.size, map.wrap, map.last_level};
}

}  // namespace mirrorball
