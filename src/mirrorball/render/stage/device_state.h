#pragma once

#include <future>
#include <memory>
#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/render/surface/background.h"
#include "mirrorball/render/surface/depth_pass.h"
#include "mirrorball/render/surface/surface_programs.h"

namespace mirrorball {

/// What a device has.
struct Device::State {
  /// brdf_table   surfaceBrdfTable(); waited for at the first frame
  State(gl::Context its_context, std::future<Result<Image>> brdf_table)
      : context(std::move(its_context)), brdf_table_(std::move(brdf_table)) {}

  gl::Context context;  ///< outlives all else
  std::shared_ptr<ProxyConnection> proxies = std::make_shared<ProxyConnection>();
  Background background;

  /// Makes what all frames need, once.
  ///
  /// errors   too_large; unsupported (the driver does not compile a shader)
  Result<void> prepare();
  SurfacePrograms& surfaces() { return *surfaces_; }
  DepthPass& depthPass() { return *depth_pass_; }

 private:
  std::future<Result<Image>> brdf_table_;
  Result<Image> table_;  ///< what came of it
  std::optional<SurfacePrograms> surfaces_;
  std::optional<DepthPass> depth_pass_;
};

/// Deletes a state that has a `device` while that device's context is current (gl::Deletion).
struct EndOnDevice {
  template <typename State>
  void operator()(State* state) const {
    const Device device = state->device;  // which outlives what is on it
    const gl::Deletion deletion(device.state().context);
    delete state;
  }
};

}  // namespace mirrorball
