#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/light/flat_light.h"
#include "mirrorball/render/light/gpu_prefilter.h"
#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/surface/surface_program.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The environment's light in all forms that frames read it in, each made when a frame first asks for it.
class FrameLight {
 public:
  /// errors   too_large (a texture for this driver)
  Result<void> setEnvironment(Environment environment, const PreparedEnvironment& prepared, bool filters_floats);
  /// Must be called when the scene is another one.
  void forgetScene();

  bool hasEnvironment() const { return light_.has_value(); }
  const EnvironmentLight& light() const { return *light_; }
  ProxyUniforms& proxy() { return proxy_; }
  const gl::Texture& sphereMap() const { return *sphere_map_; }

  /// Makes what a frame of a scene reads, but for the sphere map, and says it in `frame`, whose camera must be set.
  ///
  /// bounds   of the scene
  /// errors   too_large; unsupported (the driver has no anisotropic filter, or does not compile a shader)
  Result<void> begin(const gl::Context& context, const Scene& scene, const BoundingSphere& bounds,
                     const FrameSettings& settings, FrameUniforms& frame);

  /// Photographs the mirror ball from the camera's direction, so that the lecture's look-up is right for every camera.
  ///
  /// errors   too_large
  Result<void> makeSphereMap(FrameUniforms& frame);

 private:
  Result<void> placeProxy(gl::Api api, const Scene& scene, const BoundingSphere& bounds, const FrameSettings& settings);
  Result<void> makeGroundShadow(gl::Api api, const Scene& scene, const BoundingSphere& bounds,
                                const glm::mat3& environment_from_world);
  Result<PrefilteredChain> prefilteredChain(gl::Api api, BlurKind blur);
  Result<void> makeFlatLight(const gl::Texture& prefiltered);

  std::optional<Environment> environment_;
  std::optional<EnvironmentLight> light_;
  std::optional<GpuPrefilter> gpu_prefilter_;
  std::optional<FlatLight> flat_light_;
  const gl::Texture* flattened_chain_ = nullptr;  ///< that it was made from
  std::optional<gl::Texture> sphere_map_;
  ProxyUniforms proxy_;
  std::optional<LightSampler> ground_sampler_;  ///< of the environment
  std::optional<GroundShadow> ground_shadow_;   ///< of the scene
  std::optional<glm::mat3> shadow_from_world_;  ///< environment_from_world that it was drawn for; none: redraw it
};

}  // namespace mirrorball
