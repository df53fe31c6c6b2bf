#include "mirrorball/render/frame/animation_frames.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

/// Times that a camera is to hold: of as many pictures, or of some that are spread evenly.
std::vector<double> timesToFrame(double length_s, std::size_t pictures) {
  constexpr std::size_t kMostTimes = 32;
  const std::size_t count = std::min(pictures, kMostTimes);
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(length_s * double(i) / double(count));
  return times;
}

}  // namespace

Result<AnimationFrames> AnimationFrames::make(Scene rest, const ModelStance& stance, FrameSettings settings,
                                              std::size_t count, FramingOf what) {
  AnimationFrames frames;
  MIRRORBALL_TRY(animation, chosenAnimation(rest, stance.animation));
  frames.up_ = stance.up;
  frames.animation_ = animation;
  frames.count_ = count;
  frames.length_s_ = double(rest.rig.animations[animation].length_s);
  MIRRORBALL_TRY(all, posesTogether(rest, animation, timesToFrame(frames.length_s_, count)));
  MIRRORBALL_TRY_VOID(checkExtent(all));
  standUpright(all, stance.up);
  frames.rest_ = std::move(rest);
  frames.all_ = std::move(all);
  frames.bounds_ = boundingSphere(frames.all_);
  const float aspect = static_cast<float>(settings.size.x) / static_cast<float>(settings.size.y);
  settings.camera = framed(frames.all_, frames.bounds_, settings.camera, aspect, what);
  frames.settings_ = std::move(settings);
  return frames;
}

Result<Scene> AnimationFrames::pose(std::size_t frame) const {
  MIRRORBALL_TRY(pose, posed(rest_, animation_, length_s_ * double(frame) / double(count_)));
  MIRRORBALL_TRY_VOID(checkExtent(pose));
  standUpright(pose, up_);
  return pose;
}

Result<FrameSettings> AnimationFrames::standingStill(const FrameSettings& of_picture,
                                                     const BoundingSphere& bounds) const {
  return mirrorball::standingStill(of_picture, all_, bounds_, bounds);
}

}  // namespace mirrorball
