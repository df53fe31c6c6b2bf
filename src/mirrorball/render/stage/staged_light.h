#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "mirrorball/bake/light_sampler.h"
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

/// An environment's light on the GPU, and what is computed from it for all views.
class StagedLight {
 public:
  /// Shows another one.
  ///
  /// errors   too_large (a texture for this driver); then it is as before
  Result<void> set(Environment environment, const PreparedEnvironment& prepared, bool filters_floats);

  bool has() const { return light_.has_value(); }
  const Environment& environment() const { return *environment_; }
  const std::shared_ptr<const Environment>& sharedEnvironment() const { return environment_; }
  const EnvironmentLight& light() const { return *light_; }
  /// StageVersions::of the environment.
  std::uint64_t version() const { return versions_.of(StagePart::environment); }

  /// The chain that this kind of blur reads.
  ///
  /// errors   too_large; unsupported (the driver does not compile a shader)
  Result<PrefilteredChain> prefilteredChain(gl::Api api, BlurKind blur);
  /// The same light in flat pictures, with the chain of that kind of blur.
  ///
  /// errors   as prefilteredChain's
  Result<const FlatLight*> flatLight(gl::Api api, BlurKind blur);
  /// errors   as makeGroundSampler's
  Result<const LightSampler*> groundSampler();
  bool hasGroundSampler() const { return ground_sampler_.has(versions_); }
  /// Made elsewhere by makeGroundSampler, of this environment.
  void takeGroundSampler(LightSampler sampler) { ground_sampler_.offer(versions_, std::move(sampler)); }

 private:
  std::shared_ptr<const Environment> environment_;
  std::optional<EnvironmentLight> light_;
  StageVersions versions_;
  Derived<GpuPrefilter> gpu_prefilter_{StagePart::environment};
  Derived<LightSampler> ground_sampler_{StagePart::environment};
  std::array<Derived<FlatLight>, 2> flat_lights_{Derived<FlatLight>(StagePart::environment),
                                                 Derived<FlatLight>(StagePart::environment)};  ///< of both chains
};

}  // namespace mirrorball
