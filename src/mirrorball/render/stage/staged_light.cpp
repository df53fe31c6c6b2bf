#include "mirrorball/render/stage/staged_light.h"

#include <utility>

namespace mirrorball {

Result<LightSampler> makeGroundSampler(const Environment& environment, const ProgressFunction& progress) {
  constexpr int kTexels = 512;  // about as small as the sun
  return LightSampler::make(environment, progress, kTexels);
}

Result<PrefilteredChain> LightForm::prefilteredChain(gl::Api api, BlurKind blur) {
  if (blur != BlurKind::gpu) return PrefilteredChain{&light_.prefiltered(), 1};
  if (!gpu_prefilter_) {
    const gl::Texture& cube = light_.cube();
    MIRRORBALL_TRY(made, GpuPrefilter::make(api, cube.width(), cube.format()));
    made.run(cube);
    gpu_prefilter_ = std::move(made);
  }
  return PrefilteredChain{&gpu_prefilter_->chain(), 0};
}

Result<const FlatLight*> LightForm::flatLight(gl::Api api, BlurKind blur) {
  MIRRORBALL_TRY(chain, prefilteredChain(api, blur));
  std::optional<FlatLight>& flat = flat_lights_[blur == BlurKind::gpu ? 1 : 0];
  if (!flat) {
    MIRRORBALL_TRY(made, FlatLight::make(light_, *chain.texture));
    flat = std::move(made);
  }
  return &*flat;
}

Result<void> StagedLight::set(Environment environment, const PreparedEnvironment& prepared, bool filters_floats) {
  StagedLight other;
  other.environment_ = std::make_shared<const Environment>(std::move(environment));
  MIRRORBALL_TRY_VOID(other.takeForm(prepared, filters_floats));
  environment_ = std::move(other.environment_);
  forms_ = std::move(other.forms_);
  versions_.change(StagePart::environment);
  return {};
}

Result<void> StagedLight::takeForm(const PreparedEnvironment& prepared, bool filters_floats) {
  std::shared_ptr<LightForm>& map = forms_[static_cast<std::size_t>(SunKind::map)];
  std::shared_ptr<LightForm>& split = forms_[static_cast<std::size_t>(SunKind::split)];
  const bool has_none = prepared.sun == SunKind::split && prepared.suns.empty();
  if (!has_none || !map) {
    MIRRORBALL_TRY(light, EnvironmentLight::make(prepared, filters_floats));
    auto form = std::make_shared<LightForm>(std::move(light), prepared.suns);
    (prepared.sun == SunKind::split && !has_none ? split : map) = std::move(form);
  }
  if (has_none) split = map;
  return {};
}

Result<std::shared_ptr<LightForm>> StagedLight::formFor(SunKind sun, const std::optional<CacheFolder>& cache,
                                                        bool filters_floats) {
  if (!hasForm(sun)) {
    MIRRORBALL_TRY(prepared, prepareEnvironment(*environment_, cache, {}, sun));
    MIRRORBALL_TRY_VOID(takeForm(prepared, filters_floats));
  }
  return forms_[static_cast<std::size_t>(sun)];
}

Result<const LightSampler*> StagedLight::groundSampler() {
  MIRRORBALL_TRY(sampler, ground_sampler_.tryGet(versions_, [&] { return makeGroundSampler(*environment_); }));
  return sampler;
}

}  // namespace mirrorball
