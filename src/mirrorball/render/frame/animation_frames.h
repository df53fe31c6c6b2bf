#pragma once

#include <cstddef>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/model_stance.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Pictures that are spread evenly over the length of an animation, of which the last is one step before its end, so
/// that a loop closes. The camera and a ground stay where they hold the model at some 32 of those times.
class AnimationFrames {
 public:
  /// rest      the model as loadModel has it without an animation
  /// stance    which animation; its seconds count for nothing
  /// settings  of the pictures
  /// count     how many, at least 1
  /// what      the camera is to hold
  /// errors    usage (there is no such animation); bad_file (it reaches too far); as posed's
  /// cost      that of some 32 poses
  static Result<AnimationFrames> make(Scene rest, const ModelStance& stance, FrameSettings settings, std::size_t count,
                                      FramingOf what);

  /// The model at the moment of a picture, upright; its materials are the file's.
  ///
  /// errors   as posed's; bad_file (it reaches too far)
  Result<Scene> pose(std::size_t frame) const;

  /// Of the first picture: with a camera that holds all of them.
  const FrameSettings& settings() const { return settings_; }
  /// Of what that camera holds.
  const BoundingSphere& bounds() const { return bounds_; }

  /// Settings of a picture whose camera is told as settings()' is, for its pose.
  ///
  /// bounds   of the pose
  /// errors   as standingStill's
  Result<FrameSettings> standingStill(const FrameSettings& of_picture, const BoundingSphere& bounds) const;

 private:
  AnimationFrames() = default;

  Scene rest_;
  UpAxis up_ = UpAxis::y;
  std::size_t animation_ = 0;
  std::size_t count_ = 1;
  double length_s_ = 0.0;
  Scene all_;  // poses together, which the camera holds
  BoundingSphere bounds_;
  FrameSettings settings_;
};

}  // namespace mirrorball
