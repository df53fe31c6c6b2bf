#include "mirrorball/view/viewer/traced_side.h"

#include <mutex>
#include <utility>

#include "mirrorball/codec/color/display.h"
#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"
#include "mirrorball/view/viewer/told.h"

namespace mirrorball {

struct TracedSide::Progress {
  std::mutex mutex;
  std::optional<Image8> picture;  // until it is taken
  int paths = 0;
  float noise = 0.0f;
};

struct TracedSide::Tracer {
  const int version;  // of the stage
  const ReliefKind relief;
  const SunKind sun;
  std::mutex mutex;  // a tracing that was told to stop may go on for a moment
  std::optional<PathTracer> tracer = {};
};

namespace {

Result<PathTracer> tracerOf(Scene scene, const FrameSettings& wanted, const Environment& environment,
                            const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(prepareRelief(scene, wanted.relief));
  if (wanted.sunShown() == SunKind::map) return PathTracer::make(std::move(scene), environment, progress);
  MIRRORBALL_TRY(split, withoutSuns(environment));
  return PathTracer::make(std::move(scene), withSuns(std::move(split)), progress);
}

}  // namespace

TracedSide::TracedSide(const Device& device) : on_(new OnDevice{device}) {}

void TracedSide::begin(const LitStage& stage, const FrameSettings& wanted) {
  begun_ = wanted;
  begun_version_ = stage.version();
  has_ended_ = false;
  problem_.clear();
  so_far_ = std::make_shared<Progress>();
  if (!tracer_ || tracer_->version != stage.version() || tracer_->relief != wanted.relief ||
      tracer_->sun != wanted.sunShown())
    tracer_.reset(new Tracer{stage.version(), wanted.relief, wanted.sunShown(), {}});
  tracing_.begin([tracer = tracer_, so_far = so_far_, wanted, scene = stage.stage().scene(),
                  environment = stage.stage().state().light.sharedEnvironment()](
                     const ProgressFunction& progress) -> Result<Nothing> {
    const std::lock_guard one_at_a_time(tracer->mutex);
    if (!tracer->tracer) {
      MIRRORBALL_TRY(made, tracerOf(scene, wanted, *environment, progress));
      tracer->tracer.emplace(std::move(made));
    }
    MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), wanted.camera, wanted.size));
    const auto keep = [&](TracedPicture picture) {
      Image8 bytes = displayedPicture(wanted.display, std::move(picture.radiance), backdropOf(wanted));
      const std::lock_guard lock(so_far->mutex);
      so_far->picture = std::move(bytes);
      so_far->paths = picture.samples;
      so_far->noise = picture.noise;
    };
    const TraceSettings settings = tracedFrame(wanted, {.samples = wanted.samples});
    MIRRORBALL_TRY_VOID(tracer->tracer->render(camera, settings, {.progress = progress, .picture = keep}));
    return Nothing();
  });
}

Result<bool> TracedSide::trace(const LitStage& stage, const FrameSettings& wanted) {
  if (!isAsBegun(stage, wanted)) begin(stage, wanted);
  if (const auto ended = tracing_.take()) {
    has_ended_ = true;
    if (!*ended) problem_ = ended->error().message;
  }
  std::optional<Image8> picture;
  {
    const std::lock_guard lock(so_far_->mutex);
    picture = std::exchange(so_far_->picture, std::nullopt);
    paths_ = so_far_->paths;
    noise_ = so_far_->noise;
  }
  if (!picture) return false;
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  const glm::ivec2 size(picture->width(), picture->height());
  auto resized = gl::resize(on_->picture, gl::Format::rgba8, size);
  const bool is_shown = resized.has_value();
  MIRRORBALL_TRY_VOID(tell(std::move(resized), problem_));
  if (!is_shown) return false;
  on_->picture->upload(std::move(*picture));
  ++picture_version_;
  return true;
}

void TracedSide::stop() {
  if (!tracing_.isRunning()) return;
  tracing_.cancel();
  begun_.reset();
}

bool TracedSide::isDone(const LitStage& stage, const FrameSettings& wanted) const {
  return isAsBegun(stage, wanted) && has_ended_ && !so_far_->picture;
}

const gl::Framebuffer* TracedSide::pictureOf(const LitStage& stage, const FrameSettings& wanted) const {
  return isAsBegun(stage, wanted) && paths_ > 0 && on_->picture ? &*on_->picture : nullptr;
}

}  // namespace mirrorball
