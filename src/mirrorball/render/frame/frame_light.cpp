#include "mirrorball/render/frame/frame_light.h"

#include <algorithm>
#include <utility>

#include "mirrorball/render/surface/sphere_map.h"

namespace mirrorball {

Result<void> FrameLight::setEnvironment(Environment environment, const PreparedEnvironment& prepared,
                                        bool filters_floats) {
  MIRRORBALL_TRY(light, EnvironmentLight::make(prepared, filters_floats));
  light_ = std::move(light);
  environment_ = std::move(environment);
  gpu_prefilter_.reset();
  flat_light_.reset();
  ground_sampler_.reset();
  shadow_from_world_.reset();
  return {};
}

void FrameLight::forgetScene() {
  proxy_.forgetScene();
  ground_shadow_.reset();
  shadow_from_world_.reset();
}

Result<void> FrameLight::begin(const gl::Context& context, const Scene& scene, const BoundingSphere& bounds,
                               const FrameSettings& settings, FrameUniforms& frame) {
  frame.environment_from_world = settings.environmentFromWorld();
  MIRRORBALL_TRY_VOID(placeProxy(context.api(), scene, bounds, settings));
  frame.proxy = &proxy_;
  light_->readNearest(false);
  MIRRORBALL_TRY(chain, prefilteredChain(context.api(), settings.blur));
  frame.prefiltered = chain;
  frame.flat = nullptr;
  if (settings.look_up != LightLookUp::cube) {
    MIRRORBALL_TRY_VOID(makeFlatLight(*chain.texture));
    frame.flat = &*flat_light_;
  }
  light_->readNearest(settings.texture_filter == TextureFilter::nearest);
  return {};
}

/// What the environment's light comes from, with the shadow on it.
Result<void> FrameLight::placeProxy(gl::Api api, const Scene& scene, const BoundingSphere& bounds,
                                    const FrameSettings& settings) {
  if (proxy_.isOther(settings.proxy)) shadow_from_world_.reset();
  MIRRORBALL_TRY_VOID(proxy_.place(settings.proxy, scene));
  if (settings.proxy.kind != ProxyKind::ground) return {};
  return makeGroundShadow(api, scene, bounds, settings.environmentFromWorld());
}

Result<void> FrameLight::makeGroundShadow(gl::Api api, const Scene& scene, const BoundingSphere& bounds,
                                          const glm::mat3& environment_from_world) {
  constexpr int kLights = 256;
  constexpr int kTexels = 512;  // about as small as the sun
  if (shadow_from_world_ == environment_from_world) return {};
  if (!ground_sampler_) {
    MIRRORBALL_TRY(sampler, LightSampler::make(*environment_, {}, kTexels));
    ground_sampler_ = std::move(sampler);
  }
  if (!ground_shadow_) {
    MIRRORBALL_TRY(made, GroundShadow::make(api, scene, bounds));
    ground_shadow_ = std::move(made);
  }
  const GroundLights lights = groundLights(*environment_, *ground_sampler_, environment_from_world, kLights);
  ground_shadow_->draw(scene, proxy_.proxy(), lights);
  proxy_.setShadow(*ground_shadow_, lights.irradiance / light_->unit());
  shadow_from_world_ = environment_from_world;
  return {};
}

Result<PrefilteredChain> FrameLight::prefilteredChain(gl::Api api, BlurKind blur) {
  if (blur != BlurKind::gpu) return PrefilteredChain{&light_->prefiltered(), 1};
  if (!gpu_prefilter_) {
    const gl::Texture& cube = light_->cube();
    MIRRORBALL_TRY(made, GpuPrefilter::make(api, cube.width(), cube.format()));
    gpu_prefilter_ = std::move(made);
    gpu_prefilter_->run(cube);
  }
  return PrefilteredChain{&gpu_prefilter_->chain(), 0};
}

Result<void> FrameLight::makeFlatLight(const gl::Texture& prefiltered) {
  if (flat_light_ && flattened_chain_ == &prefiltered) return {};
  MIRRORBALL_TRY(made, FlatLight::make(*light_, prefiltered));
  flat_light_ = std::move(made);
  flattened_chain_ = &prefiltered;
  return {};
}

Result<void> FrameLight::makeSphereMap(FrameUniforms& frame) {
  const glm::mat3 environment_from_view =
      frame.environment_from_world * glm::transpose(glm::mat3(frame.camera.view_from_world));
  const int size = std::min(environment_->naturalSize(Projection::sphere), 2048);
  Image image = sphereMapTexture(*environment_, environment_from_view, size);
  for (float& light_sample : image.samples()) light_sample /= light_->unit();
  const gl::Format format = light_->cube().format();
  MIRRORBALL_TRY(made, gl::Texture::fromImages(format, ImageSet(std::move(image))));
  made.setSampling({.filter = gl::Sampling::Filter::linear});
  sphere_map_ = std::move(made);
  frame.sphere_map = &*sphere_map_;
  return {};
}

}  // namespace mirrorball
