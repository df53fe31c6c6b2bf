#pragma once

#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball {

/// A map of heights on the GPU: its slopes, and what a surface is searched for in that heights move.
struct HeightBuffers {
  struct Searched {
    gl::Texture heights;   ///< HeightTexture::picture, cones in green
    gl::Texture horizons;  ///< HorizonMap::slopes as layers
  };
  gl::Texture slopes;  ///< SlopeMoments::levels
  float slope_unit;
  std::optional<Searched> searched = {};  ///< where the heights have horizons

  /// errors   too_large (for this driver)
  static Result<HeightBuffers> make(const HeightTexture& texture);
};

/// A map of slopes on the GPU.
struct SlopeBuffer {
  gl::Texture texture;  ///< SlopeMoments::levels
  float unit;

  /// slopes   as of Scene::slope_textures
  /// errors   too_large (for this driver)
  static Result<SlopeBuffer> make(const Image& slopes);
};

}  // namespace mirrorball
