#pragma once

#include <glm/glm.hpp>

#include "mirrorball/bake/irradiance.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// An environment made ready for the GPU, still on the CPU: independent of any GL context, so that it can be made while
/// the driver starts.
struct PreparedEnvironment {
  ImageSet chain;  ///< cube with all mip levels
  IrradianceHarmonics irradiance{};
  bool needs_floats = false;  ///< some radiance is above 65504, the largest half float
};

/// A face side at which a cube has at least that many texels a radian everywhere, rounded up to a multiple of 64 so that
/// the first mip levels halve evenly.
int cubeSideFor(float texels_per_radian);

/// Lays the environment out as a cube with mip levels, and projects it on harmonics for diffuse light. A cube stays as
/// it is; anything else is resampled so that no detail is lost in the middle of a face, where texels are widest.
///
/// errors   too_large
Result<PreparedEnvironment> prepareEnvironment(const Environment& environment);

/// The light of an environment on the GPU.
class EnvironmentLight {
 public:
  /// errors   too_large (for this driver)
  static Result<EnvironmentLight> make(const PreparedEnvironment& prepared);

  const gl::Texture& cube() const { return cube_; }
  const IrradianceHarmonics& irradiance() const { return irradiance_; }

  /// The mip level that stands for roughness 1: the one of 4² texels a face, or the last there is.
  float roughestLevel() const;

  /// Of level 0, in the middle of a face.
  float texelsPerRadian() const;

 private:
  EnvironmentLight(gl::Texture cube, const IrradianceHarmonics& irradiance)
      : cube_(std::move(cube)), irradiance_(irradiance) {}

  gl::Texture cube_;
  IrradianceHarmonics irradiance_;
};

}  // namespace mirrorball
