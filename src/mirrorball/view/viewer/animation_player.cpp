#include "mirrorball/view/viewer/animation_player.h"

#include <cmath>
#include <string>
#include <utility>

#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/scene/animation/animation_choice.h"
#include "mirrorball/scene/camera/framing.h"

namespace mirrorball {
namespace {

/// The camera as numbers say it.
CameraOptions framedBy(const Scene& scene, const BoundingSphere& bounds, const FrameSettings& frame) {
  const float aspect = static_cast<float>(frame.size.x) / static_cast<float>(frame.size.y);
  return framed(scene, bounds, frame.camera, aspect);
}

/// The next moment of the animation that is chosen, or of the first.
///
/// returns   nothing: there is none, or it has no length
std::optional<Workspace> nextMoment(const Workspace& now, const Scene& rest, double seconds) {
  const auto stance = stanceOf(now.stance);
  if (!stance || rest.rig.animations.empty()) return std::nullopt;
  AnimationChoice choice = stance->animation;
  if (choice.name.empty()) choice.name = rest.rig.animations.front().name;
  const auto chosen = chosenAnimation(rest, choice);
  if (!chosen || !(rest.rig.animations[*chosen].length_s > 0.0f)) return std::nullopt;
  const double next_s =
      std::fmod(double(choice.seconds.value_or(0.0f)) + seconds, double(rest.rig.animations[*chosen].length_s));
  return withMoment(now, choice.name, static_cast<float>(next_s));
}

}  // namespace

std::optional<Workspace> AnimationPlayer::advance(double seconds, const Workspace& now, const Scene& rest,
                                                  const Scene& shown, const FrameSettings& frame) {
  if (!now.plays) {
    const bool has_stopped = stance_ == now.stance;  // else something was undone
    auto still = has_stopped ? std::optional(stopped(now, frame, boundingSphere(shown))) : std::nullopt;
    before_.reset();
    return still;
  }
  auto next = nextMoment(now, rest, seconds);
  if (!next) return std::nullopt;
  if (!before_) {
    before_ = Before{shown, boundingSphere(shown)};
    // A camera of the model's own moves with it.
    if (frame.camera.name.empty()) next = withCamera(std::move(*next), framedBy(shown, before_->bounds, frame));
  }
  stance_ = next->stance;
  return next;
}

Workspace AnimationPlayer::stopped(Workspace now, const FrameSettings& frame, const BoundingSphere& bounds) const {
  if (!before_) return now;
  now.plays = false;
  const auto still = standingStill(frame, bounds);
  return still && frame.camera.name.empty() ? withCamera(std::move(now), still->camera) : now;
}

Result<FrameSettings> AnimationPlayer::standingStill(FrameSettings settings, const BoundingSphere& bounds) const {
  if (!before_) return settings;
  return mirrorball::standingStill(std::move(settings), before_->scene, before_->bounds, bounds);
}

AnimationStatus animationStatus(const Workspace& workspace, const Scene& rest) {
  AnimationStatus status{.plays = workspace.plays};
  for (const Animation& animation : rest.rig.animations) status.names.push_back(animation.name);
  const auto stance = stanceOf(workspace.stance);
  if (!stance || status.names.empty() || stance->animation.name.empty()) return status;
  const auto chosen = chosenAnimation(rest, stance->animation);
  if (!chosen) return status;
  status.shown = *chosen;
  status.seconds = stance->animation.seconds.value_or(0.0f);
  status.length_s = rest.rig.animations[*chosen].length_s;
  return status;
}

}  // namespace mirrorball
