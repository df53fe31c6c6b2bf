#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/frame/scene_drawing.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/light/probe_light.h"
#include "mirrorball/render/light/probe_places.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// The probes of a scene: what is seen from the middles of its reflective objects, each without itself, as light that
/// these objects read. It is captured again only if the scene, its light or how it is drawn has changed.
class Probes {
 public:
  /// Captures what a frame needs, for which the light and the drawing have begun.
  ///
  /// environment   its version
  /// returns  valid until the next call; null: the frame has none
  /// errors   as SceneDrawing's
  /// cost     for each probe and bounce, six faces without samples and GpuPrefilter::run
  Result<const ProbeUniforms*> begin(gl::Api api, SceneDrawing& drawing, const EnvironmentLight& light,
                                     std::uint64_t environment, const FrameSettings& settings,
                                     const FrameUniforms& frame);

  /// How often a probe was captured until now.
  int captures() const { return captures_; }
  /// What its cubes take.
  std::size_t bytes() const;

 private:
  /// What all that was captured depends on.
  struct Captured {
    FrameSettings settings;
    std::uint64_t scene;  // versions
    std::uint64_t environment;
    bool operator==(const Captured&) const = default;
  };
  Result<void> makeLights(gl::Api api, const EnvironmentLight& light, const SampleUniforms& sample,
                          const FrameSettings& settings);
  Result<void> capture(std::size_t probe, SceneDrawing& drawing, const EnvironmentLight& light,
                       const FrameSettings& settings, FrameUniforms frame);
  void blend();
  void tell(const SceneDrawing& drawing, const FrameSettings& settings);

  ProbePlaces places_;
  std::optional<ProbeFilter> filter_;
  std::vector<ProbeLight> lights_;   ///< of the probes
  std::vector<ProbeLight> blended_;  ///< of the objects without one
  std::optional<gl::Framebuffer> picture_;
  std::optional<Captured> captured_;
  ProbeUniforms uniforms_;
  int captures_ = 0;
};

}  // namespace mirrorball
