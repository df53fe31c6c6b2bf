#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/lit_stage.h"

namespace mirrorball {

/// One half of what a viewer shows as paths of light make it (trace/path_tracer.h), refined beside its owner: a first
/// picture of one path a pixel, then twice as many paths each time.
class TracedSide {
 public:
  explicit TracedSide(const Device& device);

  /// Traces what is wanted from now on, and takes the picture so far.
  ///
  /// stage    that is ready
  /// wanted   with as many samples as there are to be paths a pixel
  /// returns  whether there is another picture than before
  /// errors   no_gl; all else is told by problem()
  Result<bool> trace(const LitStage& stage, const FrameSettings& wanted);
  /// Stops; the picture so far stays.
  void stop();

  /// Whether it has all its paths, or problem() says why not.
  bool isDone(const LitStage& stage, const FrameSettings& wanted) const;
  /// The picture so far of what is wanted; null: there is none yet.
  const gl::Framebuffer* pictureOf(const LitStage& stage, const FrameSettings& wanted) const;
  /// Counts its pictures.
  int pictureVersion() const { return picture_version_; }

  bool isRunning() const { return tracing_.isRunning(); }
  double share() const { return tracing_.share(); }
  int paths() const { return paths_; }
  int wantedPaths() const { return begun_ ? begun_->samples : 0; }
  /// TracedPicture's.
  float noise() const { return noise_; }
  const std::string& problem() const { return problem_; }

 private:
  /// What the tracing hands over.
  struct Progress;
  /// The tracer of a scene, for one picture after the other.
  struct Tracer;
  struct Nothing {};

  void begin(const LitStage& stage, const FrameSettings& wanted);
  bool isAsBegun(const LitStage& stage, const FrameSettings& wanted) const {
    return begun_ == wanted && begun_version_ == stage.version();
  }

  struct OnDevice {
    Device device;  // outlives all else
    std::optional<gl::Framebuffer> picture = {};
  };
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  std::shared_ptr<Tracer> tracer_;
  std::shared_ptr<Progress> so_far_;
  BackgroundTask<Nothing> tracing_;
  std::optional<FrameSettings> begun_;
  int begun_version_ = 0;  // of the stage
  bool has_ended_ = false;
  int paths_ = 0;
  float noise_ = 0.0f;
  int picture_version_ = 0;
  std::string problem_;
};

}  // namespace mirrorball
