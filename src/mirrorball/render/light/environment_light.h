#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "formula/sun.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image_set.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// An environment made ready for the GPU, still on the CPU: independent of any GL context, so that it can be made while
/// the driver starts. All are cubes.
struct PreparedEnvironment {
  ImageSet chain;             ///< the environment, with all mip levels
  ImageSet prefiltered;       ///< bake/prefilter/prefilter.h
  ImageSet irradiance;        ///< divided by π
  bool needs_floats = false;  ///< some radiance is above 65504, the largest half float
  SunKind sun = SunKind::map;
  /// Those that are not in the cubes; empty: the environment has none, or they are in the map.
  std::vector<formula::Sun> suns = {};
};

/// A face side at which a cube has at least that many texels a radian everywhere, rounded up to a multiple of 64 so
/// that the first mip levels halve evenly.
int cubeSideFor(float texels_per_radian);

/// Lays the environment out as a cube with mip levels, prefilters it for rough surfaces, and blurs it for diffuse ones.
/// A cube stays as it is; anything else is resampled so that no detail is lost in the middle of a face, where texels
/// are widest.
///
/// sun      whether its suns are in the cubes, or stand apart (withoutSuns)
/// cache    where prefiltered environments are kept; optional
/// progress may be called from several threads, but not at once
/// errors   too_large; interrupted
Result<PreparedEnvironment> prepareEnvironment(const Environment& environment,
                                               const std::optional<CacheFolder>& cache = {},
                                               const ProgressFunction& progress = {}, SunKind sun = SunKind::map);

/// The light of an environment on the GPU.
class EnvironmentLight {
 public:
  /// filters_floats   gl::Context::filtersFloats: else light too bright for half floats is kept in larger units
  /// errors           too_large (for this driver)
  static Result<EnvironmentLight> make(const PreparedEnvironment& prepared, bool filters_floats);

  const gl::Texture& cube() const { return cube_; }
  /// How the cube is read where its level 0 is by its nearest texel.
  const gl::Sampler& nearestSampler() const { return nearest_sampler_; }
  /// PreparedEnvironment::prefiltered: level 1 and the further ones of a chain.
  const gl::Texture& prefiltered() const { return prefiltered_; }
  const gl::Texture& irradiance() const { return irradiance_; }

  /// The radiance for which a 1 in the textures stands.
  float unit() const { return unit_; }

 private:
  EnvironmentLight(gl::Texture cube, gl::Texture prefiltered, gl::Texture irradiance, float unit)
      : cube_(std::move(cube)), prefiltered_(std::move(prefiltered)), irradiance_(std::move(irradiance)), unit_(unit) {}

  gl::Texture cube_;
  gl::Texture prefiltered_;
  gl::Texture irradiance_;
  gl::Sampler nearest_sampler_{{.filter = gl::Sampling::Filter::trilinear, .magnify_nearest = true}};
  float unit_;
};

}  // namespace mirrorball
