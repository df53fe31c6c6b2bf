#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/stage/staged_light.h"
#include "mirrorball/render/stage/staged_scene.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/render/surface/sun_shadows.h"

namespace mirrorball {

/// A stage's light as a view shows it: what it comes from, with the shadow on it, and the forms that its frames read.
class FrameLight {
 public:
  /// Of a light on a device; both outlive it.
  FrameLight(Device::State& device, StagedLight& light) : device_(&device), light_(&light), proxy_(device.proxies) {}

  /// Of the frame that has begun last.
  const EnvironmentLight& light() const { return form_->light(); }
  const gl::Texture& sphereMap() const { return *sphere_map_; }

  /// Makes what a frame of a scene reads.
  ///
  /// cache    of prepareEnvironment; optional
  /// returns  valid until the next call
  /// errors   too_large; unsupported (the driver does not compile a shader)
  Result<LightUniforms> begin(StagedScene& staged, const FrameSettings& settings, const Camera& camera,
                              const std::optional<CacheFolder>& cache);

 private:
  /// Photographs the mirror ball from the camera's direction, so that the lecture's look-up is right for every camera.
  ///
  /// errors   too_large
  Result<void> makeSphereMap(const glm::mat3& environment_from_view);
  /// What the shadow on the ground depends on, beside where that is.
  struct ShadowOf {
    glm::mat3 environment_from_world;
    std::uint64_t scene;
    std::uint64_t environment;
    float unit;  ///< of its cubes
    bool operator==(const ShadowOf&) const = default;
  };
  Result<void> chooseForm(const FrameSettings& settings, const std::optional<CacheFolder>& cache);
  /// Puts the form's suns into the world, and draws what hides them.
  ///
  /// errors   unsupported; too_large; no_gl
  Result<SunUniforms> placeSuns(StagedScene& staged, const FrameSettings& settings);
  Result<void> placeProxy(StagedScene& staged, const FrameSettings& settings);
  Result<void> makeGroundShadow(StagedScene& staged, const glm::mat3& environment_from_world);

  Device::State* device_;
  StagedLight* light_;
  std::shared_ptr<LightForm> form_;
  std::optional<gl::Texture> sphere_map_;
  ProxyUniforms proxy_;
  std::uint64_t placed_in_ = 0;  ///< the scene's version
  std::optional<GroundShadow> ground_shadow_;
  std::uint64_t shadow_casters_ = 0;   ///< the version of the meshes that it takes its shapes from
  std::optional<ShadowOf> shadow_of_;  ///< that it was drawn for; none: it must be drawn
  std::optional<SunShadows> sun_shadows_;
  std::optional<std::pair<ShadowOf, int>> sun_shadows_of_;  ///< likewise, and their side
};

}  // namespace mirrorball
