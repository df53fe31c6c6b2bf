#include "mirrorball/render/frame/frame_light.h"

#include <algorithm>
#include <utility>

#include "mirrorball/render/light/ground_caustics.h"
#include "mirrorball/render/surface/sphere_map.h"
#include "mirrorball/render/surface/texture_coordinates.h"

namespace mirrorball {

Result<LightUniforms> FrameLight::begin(StagedScene& staged, const FrameSettings& settings, const Camera& camera,
                                        const std::optional<CacheFolder>& cache) {
  MIRRORBALL_TRY_VOID(chooseForm(settings, cache));
  MIRRORBALL_TRY_VOID(placeProxy(staged, settings));
  const gl::Api api = device_->context.api();
  MIRRORBALL_TRY(chain, form_->prefilteredChain(api, settings.blur));
  LightUniforms uniforms{
      .prefiltered = chain, .environment_from_world = settings.environmentFromWorld(), .proxy = &proxy_};
  if (settings.look_up != LightLookUp::cube) {
    MIRRORBALL_TRY(flat, form_->flatLight(api, settings.blur));
    uniforms.flat = flat;
  }
  if (coordinateChoice(staged.scene(), settings).is_sphere_map) {
    MIRRORBALL_TRY_VOID(
        makeSphereMap(uniforms.environment_from_world * glm::transpose(glm::mat3(camera.view_from_world))));
    uniforms.sphere_map = &*sphere_map_;
  }
  if (!form_->suns().empty()) {
    MIRRORBALL_TRY(suns, placeSuns(staged, settings));
    uniforms.suns = std::move(suns);
  }
  return uniforms;
}

/// With suns in the map where one would shine out of the ground.
Result<void> FrameLight::chooseForm(const FrameSettings& settings, const std::optional<CacheFolder>& cache) {
  const bool filters_floats = device_->context.filtersFloats();
  MIRRORBALL_TRY(form, light_->formFor(settings.sunShown(), cache, filters_floats));
  const glm::mat3 world_from_environment = glm::transpose(settings.environmentFromWorld());
  const auto isBelow = [&](const formula::Sun& sun) { return (world_from_environment * sun.towards).y <= 0.0f; };
  if (settings.proxy.kind == ProxyKind::ground && std::any_of(form->suns().begin(), form->suns().end(), isBelow)) {
    MIRRORBALL_TRY(of_map, light_->formFor(SunKind::map, cache, filters_floats));
    form = std::move(of_map);
  }
  form_ = std::move(form);
  return {};
}

Result<SunUniforms> FrameLight::placeSuns(StagedScene& staged, const FrameSettings& settings) {
  const glm::mat3 environment_from_world = settings.environmentFromWorld();
  SunUniforms placed;
  for (formula::Sun sun : form_->suns()) {
    sun.towards = glm::normalize(glm::transpose(environment_from_world) * sun.towards);
    sun.irradiance *= settings.env_intensity;
    placed.suns.push_back(sun);
  }
  const std::uint64_t scene = staged.version(StagePart::meshes | StagePart::transforms | StagePart::materials);
  const int side = sunShadowSide(settings.size, placed.suns.size(), device_->context.largestTexture());
  const std::pair wanted(ShadowOf{environment_from_world, scene, light_->version(), light().unit()}, side);
  if (sun_shadows_of_ != wanted) {
    sun_shadows_of_.reset();
    if (!sun_shadows_) {
      MIRRORBALL_TRY(made, SunShadows::make(device_->context.api()));
      sun_shadows_ = std::move(made);
    }
    MIRRORBALL_TRY_VOID(sun_shadows_->draw(staged.scene(), staged.buffers(), placed.suns, staged.bounds(), side));
    sun_shadows_of_ = wanted;
  }
  placed.shadows = &sun_shadows_->picture();
  placed.shadow_rows = sun_shadows_->rows();
  return placed;
}

/// What the environment's light comes from, with the shadow on it.
Result<void> FrameLight::placeProxy(StagedScene& staged, const FrameSettings& settings) {
  const std::uint64_t places = staged.version(StagePart::meshes | StagePart::transforms);
  if (placed_in_ != places) proxy_.forgetScene();
  if (placed_in_ != places || proxy_.isOther(settings.proxy)) shadow_of_.reset();
  placed_in_ = places;
  MIRRORBALL_TRY_VOID(proxy_.place(settings.proxy, staged.scene()));
  if (settings.proxy.kind != ProxyKind::ground) return {};
  return makeGroundShadow(staged, settings.environmentFromWorld());
}

Result<void> FrameLight::makeGroundShadow(StagedScene& staged, const glm::mat3& environment_from_world) {
  // Half floats, which OpenGL ES adds the shadows up in, would lose more of smaller shares.
  const int count = device_->context.api() == gl::Api::desktop43 ? 512 : 256;
  const std::uint64_t scene = staged.version(StagePart::meshes | StagePart::transforms | StagePart::materials);
  const ShadowOf wanted{environment_from_world, scene, light_->version(), light().unit()};
  if (shadow_of_ == wanted) return {};
  shadow_of_.reset();
  MIRRORBALL_TRY(sampler, light_->groundSampler());
  if (const std::uint64_t casters = staged.version(StagePart::meshes); !ground_shadow_ || shadow_casters_ != casters) {
    ground_shadow_.reset();
    proxy_.forgetShadow();
    MIRRORBALL_TRY(made, GroundShadow::make(device_->context.api(), staged.casters()));
    ground_shadow_ = std::move(made);
    shadow_casters_ = casters;
  }
  const GroundLights lights = groundLights(light_->environment(), *sampler, environment_from_world, count);
  ground_shadow_->draw(staged.scene(), staged.bounds(), proxy_.proxy(), lights);
  if (hasCaustics(staged.scene())) {
    MIRRORBALL_TRY(rays, staged.rays());
    const Image caustics = groundCaustics(
        {staged.scene(), rays->geometry, staged.boxes()}, {light_->environment(), *sampler, environment_from_world},
        proxy_.proxy().ground, GroundShadow::areaAround(staged.bounds()), GroundShadow::kSize);
    MIRRORBALL_TRY_VOID(ground_shadow_->addLight(caustics));
  }
  proxy_.setShadow(*ground_shadow_, lights.irradiance / light().unit());
  shadow_of_ = wanted;
  return {};
}

Result<void> FrameLight::makeSphereMap(const glm::mat3& environment_from_view) {
  const int size = std::min(light_->environment().naturalSize(Projection::sphere), 2048);
  Image image = sphereMapTexture(light_->environment(), environment_from_view, size);
  for (float& light_sample : image.samples()) light_sample /= light().unit();
  const gl::Format format = light().cube().format();
  MIRRORBALL_TRY(made, gl::Texture::fromImages(format, ImageSet(std::move(image))));
  made.setSampling({.filter = gl::Sampling::Filter::linear});
  sphere_map_ = std::move(made);
  return {};
}

}  // namespace mirrorball
