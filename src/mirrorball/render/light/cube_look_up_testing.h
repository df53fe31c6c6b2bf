#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball::testing {

/// What OpenGL 4.6, chapters 8.13 and 8.14, says of a trilinear look-up in a cube that is filtered across its edges,
/// with the greatest of the light that it was made from.
struct CubeLookUp {
  glm::vec3 light{0.0f};
  float max = 0.0f;

  CubeLookUp(const ImageSet& chain, glm::vec3 d, float lod) {
    const float last = static_cast<float>(chain.levels() - 1);
    const int level = static_cast<int>(std::clamp(lod, 0.0f, last));
    const float coarser = std::clamp(lod, 0.0f, last) - static_cast<float>(level);
    add(chain, level, d, 1.0f - coarser);
    if (coarser > 0.0f) add(chain, level + 1, d, coarser);
  }

 private:
  /// A texel of a face; a place beyond one of its edges is the nearest texel of the face that is there.
  static glm::vec3 texelAt(const ImageSet& chain, int level, int face, glm::ivec2 texel) {
    const int side = chain.at(level, face).width();
    if (glm::clamp(texel, 0, side - 1) == texel) return rgbAt(chain.at(level, face), texel.x, texel.y);
    const glm::vec2 beyond = (glm::vec2(texel) + 0.5f) / static_cast<float>(side);
    // As far beyond the edge as to be on the other face whatever the rounding, but not past its first texel.
    const glm::vec2 just =
        glm::clamp(beyond, -0.01f / static_cast<float>(side), 1.0f + 0.01f / static_cast<float>(side));
    const MapPosition across = positionOf(Projection::cube, directionAt(Projection::cube, {face, just}));
    const glm::ivec2 there = glm::clamp(glm::ivec2(across.uv * static_cast<float>(side)), 0, side - 1);
    return rgbAt(chain.at(level, across.face), there.x, there.y);
  }

  void add(const ImageSet& chain, int level, glm::vec3 d, float weight) {
    const MapPosition position = positionOf(Projection::cube, d);
    const int side = chain.at(level, position.face).width();
    const glm::vec2 place = position.uv * static_cast<float>(side) - 0.5f;
    const glm::ivec2 first = glm::floor(place);
    const glm::vec2 part = place - glm::vec2(first);
    glm::vec3 texels[4];
    glm::vec3 sum(0.0f);
    int corner = -1;
    for (int i = 0; i < 4; ++i) {
      const glm::ivec2 texel = first + glm::ivec2(i % 2, i / 2);
      const glm::bvec2 is_beyond(texel.x < 0 || texel.x >= side, texel.y < 0 || texel.y >= side);
      if (glm::all(is_beyond)) {
        corner = i;
        continue;
      }
      texels[i] = texelAt(chain, level, position.face, texel);
      sum += texels[i];
      max = std::max({max, texels[i].x, texels[i].y, texels[i].z});
    }
    // At a cube's corner three texels meet; their mean stands for the fourth.
    if (corner >= 0) texels[corner] = sum / 3.0f;
    light += weight * glm::mix(glm::mix(texels[0], texels[1], part.x), glm::mix(texels[2], texels[3], part.x), part.y);
  }
};

}  // namespace mirrorball::testing
