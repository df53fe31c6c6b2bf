#pragma once

#include <memory>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/timer.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/lit_stage.h"
#include "mirrorball/view/viewer/time_budget.h"

namespace mirrorball {

/// One half of what a viewer shows, drawn piece by piece. What its technique needs of the scene is found beside its
/// owner; until that is there, the technique before shows what is asked for, or the picture before stays.
class DrawnSide {
 public:
  /// frame_s   that a picture may take while something moves [s]
  DrawnSide(const Device& device, double frame_s);

  /// Does the next piece: makes a program, or draws a sample.
  ///
  /// stage    that is ready; it outlives its last draw
  /// returns  whether there is another picture than before
  /// errors   no_gl; all else is told by problem()
  Result<bool> draw(LitStage& stage, const FrameSettings& wanted);

  /// What the last picture shows at a place of it, from its top left corner [pixels]. The triangles are sorted beside
  /// its owner.
  ///
  /// returns  nothing: it is not known yet; an empty one: the background
  /// errors   as View::pick's and StageWork's
  Result<std::optional<std::optional<Picked>>> pick(LitStage& stage, glm::vec2 place_px);

  /// Whether it draws what is wanted, or has.
  bool hasBegun(const LitStage& stage, const FrameSettings& wanted) const {
    return isAsBegun(stage) && *begun_ == wanted;
  }
  /// Whether it shows all of what is wanted, or problem() says why not.
  bool isDone(const LitStage& stage, const FrameSettings& wanted) const;
  /// Whether nothing can be drawn until what is found beside it is there.
  bool isWaiting(const LitStage& stage) const;
  bool isPicking() const { return sorting_.isRunning(); }

  /// How large a picture may be while something moves.
  glm::ivec2 movingSize(glm::ivec2 window_px) const { return budget_.sizeFor(window_px); }
  /// Another scene takes another time.
  void forgetTimes() { budget_.forget(); }

  /// The last one, as a display shows it; null: there is none.
  const gl::Framebuffer* picture() const { return on_->picture ? &*on_->picture : nullptr; }
  /// Counts its pictures.
  int pictureVersion() const { return picture_version_; }

  const auto& preparing() const { return preparing_; }
  const std::string& problem() const { return problem_of_preparing_.empty() ? problem_ : problem_of_preparing_; }
  int programsLeft() const { return programs_left_; }
  int samples() const { return samples_; }
  int wantedSamples() const { return begun_ ? begun_->samples : 0; }
  double sampleSeconds() const { return sample_s_; }
  /// Of it, by the GPU's clock; nothing: that is not known.
  std::optional<double> gpuSeconds() const { return gpu_s_; }
  LightCost lightCost() const { return view_ ? view_->lightCost() : LightCost(); }
  /// That has drawn the last picture; null: none has.
  View* view() { return view_ ? &*view_ : nullptr; }

 private:
  void lookAt(LitStage& stage);
  Result<std::optional<FrameSettings>> prepared(LitStage& stage, const FrameSettings& wanted);
  Result<bool> drawPiece(const LitStage& stage, const FrameSettings& frame);
  Result<bool> tryToDraw(LitStage& stage, const FrameSettings& wanted);
  bool isAsBegun(const LitStage& stage) const { return begun_ && begun_version_ == stage.version(); }

  struct OnDevice {
    Device device;  // outlives all else
    std::optional<gl::Framebuffer> picture = {};
    gl::Timer timer = {};
  };
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  TimeBudget budget_;
  std::optional<View> view_;
  const Stage::State* viewed_ = nullptr;  // by `view_`
  using Working = BackgroundTask<std::shared_ptr<StageWork>>;
  Working preparing_;                    // of the stage, for another technique
  Working sorting_;                      // of its triangles, to pick among
  FrameSettings prepared_for_;           // last
  std::optional<FrameSettings> begun_;   // the frame that is drawn
  int begun_version_ = 0;                // of its stage
  std::optional<FrameSettings> failed_;  // what could not be drawn; problem_ says why
  int failed_version_ = 0;               // of its stage
  int programs_left_ = 0;
  double sample_s_ = 0.0;
  std::optional<double> gpu_s_;
  int samples_ = 0;
  int picture_version_ = 0;
  std::string problem_;
  std::string problem_of_preparing_;
};

}  // namespace mirrorball
