#include "mirrorball/view/viewer/drawn_side.h"

#include <chrono>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/view/viewer/told.h"

namespace mirrorball {
namespace {

/// A technique as it is, seen as other settings say: from their camera, in their light.
FrameSettings seenAs(FrameSettings technique, const FrameSettings& seen) {
  technique.camera = seen.camera;
  technique.size = seen.size;
  technique.samples = seen.samples;
  technique.display = seen.display;
  technique.env_rotation_deg = seen.env_rotation_deg;
  return technique;
}

/// Does it, and hands it back.
auto doing(StageWork work) {
  return [work = std::make_shared<StageWork>(std::move(work))](
             const ProgressFunction& progress) -> Result<std::shared_ptr<StageWork>> {
    MIRRORBALL_TRY_VOID(work->run(progress));
    return work;
  };
}

}  // namespace

DrawnSide::DrawnSide(const Device& device, double frame_s) : on_(new OnDevice{device}), budget_(frame_s) {}

void DrawnSide::lookAt(LitStage& stage) {
  if (viewed_ == &stage.stage().state()) return;
  viewed_ = &stage.stage().state();
  view_.emplace(stage.stage());
  preparing_.cancel();
  sorting_.cancel();
  begun_.reset();
}

Result<bool> DrawnSide::draw(LitStage& stage, const FrameSettings& wanted) {
  lookAt(stage);
  if (failed_ && (*failed_ != wanted || failed_version_ != stage.version())) failed_.reset();
  if (failed_) return false;
  auto drawn = tryToDraw(stage, wanted);
  if (!drawn) {
    failed_ = wanted;
    failed_version_ = stage.version();
  }
  const bool is_other = drawn && *drawn;
  if (is_other) ++picture_version_;
  MIRRORBALL_TRY_VOID(tell(drawn ? Result<void>() : fail(std::move(drawn)), problem_));
  return is_other;
}

Result<bool> DrawnSide::tryToDraw(LitStage& stage, const FrameSettings& wanted) {
  MIRRORBALL_TRY(can_be_drawn, prepared(stage, wanted));
  return can_be_drawn ? drawPiece(stage, *can_be_drawn) : Result<bool>(false);
}

/// Prepares the stage for what is wanted.
///
/// returns  what can be drawn meanwhile: what is wanted, the technique before, or nothing
Result<std::optional<FrameSettings>> DrawnSide::prepared(LitStage& stage, const FrameSettings& wanted) {
  if (auto ready = preparing_.take()) {
    const auto taken = *ready ? stage.stage().take(std::move(***ready)) : Result<bool>(fail(std::move(*ready)));
    MIRRORBALL_TRY_VOID(
        tell(taken ? Result<void>() : Result<void>(tl::unexpected<Error>(taken.error())), problem_of_preparing_));
  }
  const bool is_begun = isAsBegun(stage);
  if (is_begun && seenAs(*begun_, wanted) == wanted) return std::optional(wanted);
  const bool has_failed = !problem_of_preparing_.empty() && seenAs(prepared_for_, wanted) == wanted;
  if (!preparing_.isRunning() && !has_failed) {
    problem_of_preparing_.clear();
    MIRRORBALL_TRY(work, stage.stage().workFor(wanted));
    if (!work.isNeeded()) return std::optional(wanted);
    prepared_for_ = wanted;
    preparing_.begin(doing(std::move(work)));
  }
  return is_begun ? std::optional(seenAs(*begun_, wanted)) : std::nullopt;
}

Result<bool> DrawnSide::drawPiece(const LitStage& stage, const FrameSettings& frame) {
  if (!isAsBegun(stage) || *begun_ != frame) {
    begun_.reset();  // until it has begun
    MIRRORBALL_TRY_VOID(view_->begin(frame));
    begun_ = frame;
    begun_version_ = stage.version();
    programs_left_ = 1;
    samples_ = 0;
  }
  if (programs_left_ > 0) {
    MIRRORBALL_TRY(left, view_->makeProgram());
    programs_left_ = left;
    if (left > 0) return false;
  }
  if (view_->isDone()) return false;
  const auto start = std::chrono::steady_clock::now();
  on_->timer.begin(on_->device.state().context);
  auto sample = view_->drawSample();
  on_->timer.end();
  MIRRORBALL_TRY(drawn, std::move(sample));
  glFinish();
  sample_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  gpu_s_ = on_->timer.seconds();
  if (drawn == 1) budget_.drew(frame.size, sample_s_);  // later ones may be of a few pixels
  samples_ = drawn;
  // Kept, since another frame takes what the view has drawn.
  MIRRORBALL_TRY_VOID(gl::resize(on_->picture, gl::Format::rgba8, frame.size));
  MIRRORBALL_TRY_VOID(view_->show(on_->picture->name()));
  return true;
}

Result<std::optional<std::optional<Picked>>> DrawnSide::pick(LitStage& stage, glm::vec2 place_px) {
  const std::optional<std::optional<Picked>> not_known;
  if (auto ready = sorting_.take()) {
    MIRRORBALL_TRY(work, std::move(*ready));
    MIRRORBALL_TRY_VOID(stage.stage().take(std::move(*work)));
  }
  if (sorting_.isRunning() || !isAsBegun(stage) || !view_->isDone()) return not_known;
  MIRRORBALL_TRY(work, stage.stage().workFor(*begun_, /*picks=*/true));
  if (work.isNeeded()) {
    sorting_.begin(doing(std::move(work)));
    return not_known;
  }
  MIRRORBALL_TRY(picked, view_->pick(place_px));
  return std::optional(std::move(picked));
}

bool DrawnSide::isDone(const LitStage& stage, const FrameSettings& wanted) const {
  if (preparing_.isRunning()) return false;
  if (failed_ == wanted && failed_version_ == stage.version()) return true;
  // What is wanted cannot be prepared: then what is shown is as it was.
  const bool shows_other = !problem_of_preparing_.empty() && begun_;
  return isAsBegun(stage) && (shows_other || *begun_ == wanted) && programs_left_ == 0 && view_->isDone();
}

bool DrawnSide::isWaiting(const LitStage& stage) const {
  return preparing_.isRunning() && !(isAsBegun(stage) && !view_->isDone());
}

}  // namespace mirrorball
