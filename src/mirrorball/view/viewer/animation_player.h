#pragma once

#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/viewer/viewer_status.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// Lets the animation of a workspace's model go on. What counts in model radii is told of the model as it stood when
/// that began: so camera and ground stay where they are, however large the model is from moment to moment.
class AnimationPlayer {
 public:
  /// The next moment, or what is left to do when the animation has stopped.
  ///
  /// seconds   since the moment that is shown
  /// rest      the model, with its animations
  /// shown     the model at the moment that is shown
  /// frame     settings of the half whose camera is moved by hands
  /// returns   what takes the place of `now`; nothing: it stays
  std::optional<Workspace> advance(double seconds, const Workspace& now, const Scene& rest, const Scene& shown,
                                   const FrameSettings& frame);

  /// The same workspace with the animation stopped, whose camera is told of the moment that is shown.
  ///
  /// frame    as advance takes it
  /// bounds   of the model at that moment
  Workspace stopped(Workspace now, const FrameSettings& frame, const BoundingSphere& bounds) const;

  bool isPlaying() const { return before_.has_value(); }

  /// Of a model that plays what hands measure by: its bounds when that began.
  BoundingSphere boundsOr(const BoundingSphere& bounds) const { return before_ ? before_->bounds : bounds; }

  /// Settings as they are to be for the moment that is shown.
  ///
  /// errors   as standingStill's
  Result<FrameSettings> standingStill(FrameSettings settings, const BoundingSphere& bounds) const;

 private:
  struct Before {
    Scene scene;
    BoundingSphere bounds;
  };
  std::optional<Before> before_;  // as the model was when the animation began to go on
  GivenTexts stance_ = {};        // that was shown last
};

/// What there is to be said of a model's animations.
AnimationStatus animationStatus(const Workspace& workspace, const Scene& rest);

}  // namespace mirrorball
