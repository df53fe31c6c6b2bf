#include "mirrorball/render/stage/staged_light.h"

#include <utility>

namespace mirrorball {

Result<LightSampler> makeGroundSampler(const Environment& environment, const ProgressFunction& progress) {
  constexpr int kTexels = 512;  // about as small as the sun
  return LightSampler::make(environment, progress, kTexels);
}

Result<void> StagedLight::set(Environment environment, const PreparedEnvironment& prepared, bool filters_floats) {
  MIRRORBALL_TRY(light, EnvironmentLight::make(prepared, filters_floats));
  light_ = std::move(light);
  environment_ = std::make_shared<const Environment>(std::move(environment));
  versions_.change(StagePart::environment);
  return {};
}

Result<PrefilteredChain> StagedLight::prefilteredChain(gl::Api api, BlurKind blur) {
  if (blur != BlurKind::gpu) return PrefilteredChain{&light_->prefiltered(), 1};
  const auto make = [&]() -> Result<GpuPrefilter> {
    const gl::Texture& cube = light_->cube();
    MIRRORBALL_TRY(made, GpuPrefilter::make(api, cube.width(), cube.format()));
    made.run(cube);
    return Result<GpuPrefilter>(std::move(made));
  };
  MIRRORBALL_TRY(prefilter, gpu_prefilter_.tryGet(versions_, make));
  return PrefilteredChain{&prefilter->chain(), 0};
}

Result<const FlatLight*> StagedLight::flatLight(gl::Api api, BlurKind blur) {
  MIRRORBALL_TRY(chain, prefilteredChain(api, blur));
  Derived<FlatLight>& flat = flat_lights_[blur == BlurKind::gpu ? 1 : 0];
  MIRRORBALL_TRY(made, flat.tryGet(versions_, [&] { return FlatLight::make(*light_, *chain.texture); }));
  return made;
}

Result<const LightSampler*> StagedLight::groundSampler() {
  MIRRORBALL_TRY(sampler, ground_sampler_.tryGet(versions_, [&] { return makeGroundSampler(*environment_); }));
  return sampler;
}

}  // namespace mirrorball
