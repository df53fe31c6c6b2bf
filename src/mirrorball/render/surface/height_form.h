#pragma once

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball {

/// How a material's heights are kept, as shaders/height_sampler.glsl reads it.
inline glm::vec4 heightForm(const HeightTexture& texture, float slope_unit = 1.0f, int steps = 0) {
  const int wrap = texture.edges == MapEdges::tiled ? formula::kWrapRepeat : formula::kWrapClampToEdge;
  return {wrap, texture.levels.levels() - 1, slope_unit, steps};
}

}  // namespace mirrorball
