#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/light/environment_light.h"

namespace mirrorball {

/// A cube map with its six faces side by side in one picture, as formula/projection/flat_cube.glsl reads it. Copied on
/// the GPU, texel by texel.
///
/// cube     of all mip levels down to one texel a face, or of one that is read at lod 0; of a format that can be drawn
///          into
/// errors   too_large: three faces are wider than the driver takes
Result<gl::Texture> flattened(const gl::Texture& cube);

/// The light of an environment for shaders that find texels by themselves.
struct FlatLight {
  gl::Texture environment;
  gl::Texture prefiltered;
  gl::Texture irradiance;

  /// prefiltered   the chain that the frame reads
  /// errors        as flattened's
  static Result<FlatLight> make(const EnvironmentLight& light, const gl::Texture& prefiltered);
};

}  // namespace mirrorball
