#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "formula/sun.h"
#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/light/flat_light.h"
#include "mirrorball/render/light/gpu_prefilter.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/derived.h"
#include "mirrorball/render/surface/frame_uniforms.h"

namespace mirrorball {

/// Where an environment is bright, for a shadow on the ground.
///
/// errors   as LightSampler's
Result<LightSampler> makeGroundSampler(const Environment& environment, const ProgressFunction& progress = {});

/// An environment's cubes on the GPU, with its suns or without them, and what is computed from the cubes for all views.
class LightForm {
 public:
  LightForm(EnvironmentLight light, std::vector<formula::Sun> suns)
      : light_(std::move(light)), suns_(std::move(suns)) {}

  const EnvironmentLight& light() const { return light_; }
  /// Those that are not in the cubes.
  const std::vector<formula::Sun>& suns() const { return suns_; }

  /// The chain that this kind of blur reads.
  ///
  /// errors   too_large; unsupported (the driver does not compile a shader)
  Result<PrefilteredChain> prefilteredChain(gl::Api api, BlurKind blur);
  /// The same light in flat pictures, with the chain of that kind of blur.
  ///
  /// errors   as prefilteredChain's
  Result<const FlatLight*> flatLight(gl::Api api, BlurKind blur);

 private:
  EnvironmentLight light_;
  std::vector<formula::Sun> suns_;
  std::optional<GpuPrefilter> gpu_prefilter_;
  std::array<std::optional<FlatLight>, 2> flat_lights_;  ///< of both chains
};

/// An environment's light on the GPU, and what is computed from it for all views.
class StagedLight {
 public:
  /// Shows another one, whose cubes are prepared for one kind of sun.
  ///
  /// errors   too_large (a texture for this driver); then it is as before
  Result<void> set(Environment environment, const PreparedEnvironment& prepared, bool filters_floats);

  bool has() const { return environment_ != nullptr; }
  const Environment& environment() const { return *environment_; }
  const std::shared_ptr<const Environment>& sharedEnvironment() const { return environment_; }
  /// StageVersions::of the environment.
  std::uint64_t version() const { return versions_.of(StagePart::environment); }

  /// The cubes for a kind of sun, made if they are not there.
  ///
  /// cache    of prepareEnvironment; optional
  /// errors   as prepareEnvironment's; too_large (a texture for this driver)
  Result<std::shared_ptr<LightForm>> formFor(SunKind sun, const std::optional<CacheFolder>& cache, bool filters_floats);
  bool hasForm(SunKind sun) const { return forms_[static_cast<std::size_t>(sun)] != nullptr; }
  /// Those that were made elsewhere, of this environment.
  ///
  /// errors   too_large (a texture for this driver)
  Result<void> takeForm(const PreparedEnvironment& prepared, bool filters_floats);

  /// errors   as makeGroundSampler's
  Result<const LightSampler*> groundSampler();
  bool hasGroundSampler() const { return ground_sampler_.has(versions_); }
  /// Made elsewhere by makeGroundSampler, of this environment.
  void takeGroundSampler(LightSampler sampler) { ground_sampler_.offer(versions_, std::move(sampler)); }

 private:
  std::shared_ptr<const Environment> environment_;
  std::array<std::shared_ptr<LightForm>, 2> forms_;  ///< of each SunKind; the same where there are no suns
  StageVersions versions_;
  Derived<LightSampler> ground_sampler_{StagePart::environment};
};

}  // namespace mirrorball
