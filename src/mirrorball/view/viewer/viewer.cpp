#include "mirrorball/view/viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/viewer/told.h"
#include "mirrorball/view/viewer/viewer_state.h"

namespace mirrorball {
namespace {

// After so long without a move the whole picture is drawn.
constexpr double kRest_s = 0.15;

}  // namespace

Viewer::State::State(const Device& on, Workspace start, glm::ivec2 size, ViewerOptions given)
    : device(on),
      options(std::move(given)),
      history(std::move(start)),
      size_px(size),
      since_moved_s(kRest_s),
      stages{std::make_unique<LitStage>(on), std::make_unique<LitStage>(on)},
      drawn{DrawnSide(on, options.frame_s), DrawnSide(on, options.frame_s)},
      traced{TracedSide(on), TracedSide(on)},
      compared(on),
      map(on),
      thumbnails(on) {}

bool Viewer::State::moves() const { return since_moved_s < kRest_s; }

FrameSettings Viewer::State::movedFrame() const {
  FrameSettings frame = frameOf(now(), editedSide(now())).value_or(FrameSettings());
  frame.size = size_px;
  standInView(frame, editedSide(now()));
  return frame;
}

void Viewer::State::standInView(FrameSettings& frame, std::size_t side) const {
  standOnGround(frame);
  holdShadow(frame, stageOf(side).strongSun());
  frame.camera.ground_light_turns = true;
}

ShownPicture Viewer::State::shown() const {
  const FrameSettings frame = movedFrame();
  const float aspect = static_cast<float>(size_px.x) / static_cast<float>(size_px.y);
  const Stage& stage = stages[0]->stage();
  return {.camera = placedCamera(stage.scene(), stage.bounds(), frame.camera, aspect),
          .bounds = player.boundsOr(stage.bounds()),
          .size_px = size_px,
          .env_rotation_deg = frame.env_rotation_deg,
          .ball = shownBall()};
}

void Viewer::State::apply(std::optional<Change> change) {
  if (!change || change->next == now()) return;
  has_just_moved = change->goes_on;
  history.change(std::move(change->name), std::move(change->next), change->goes_on);
}

void Viewer::State::play(double seconds) {
  if (!now().plays && !player.isPlaying()) return;
  since_moment_s = player.isPlaying() ? since_moment_s + std::max(seconds, 0.0) : 0.0;
  if (now().plays && !isMomentSeen()) return;
  const Scene& shown = stages[0]->stage().scene();
  auto next = player.advance(std::exchange(since_moment_s, 0.0), now(), model.rest(), shown, movedFrame());
  if (!next) return;
  has_just_moved = player.isPlaying();
  history.goOn(std::move(*next));
}

/// Selects the material of what a click has met, once that is known.
Result<void> Viewer::State::takeClick() {
  if (!clicked_px || moves()) return {};
  const std::size_t side = seenSides().front();
  LitStage& stage = stageOf(side);
  const auto frame = wanted(side);
  if (frame && stage.isReady() && !drawn[side].isDone(stage, frame->drawn)) {
    // Of a half that is traced the renderer may have drawn but a part.
    MIRRORBALL_TRY_VOID(draw(side));
    return {};
  }
  auto picked = drawn[side].pick(stage, *clicked_px);
  if (picked && !*picked && drawn[side].isPicking()) return {};
  clicked_px.reset();
  if (picked && !*picked) return {};  // nothing can be drawn that was clicked on
  if (!picked) return tell(fail(std::move(picked)), problem_of_picking);
  problem_of_picking.clear();
  Workspace next = now();
  next.selected_material.reset();
  if (const std::optional<Picked>& met = **picked) next.selected_material = met->material;
  history.change("Select a material", std::move(next));
  return {};
}

Result<void> Viewer::State::follow() {
  if (model.follow(now(), options.inside_only))
    for (DrawnSide& side : drawn) side.forgetTimes();
  const bool has_other_map = isComparing() && mapOf(now(), 1) != mapOf(now(), 0);
  const auto lit = [&](std::size_t side) {
    LitStage& stage = *stages[side];
    return stage.follow(model, restingMap(side, stage.loading().asked()), options.cache);
  };
  MIRRORBALL_TRY_VOID(lit(0));
  return has_other_map ? lit(1) : Result<void>();
}

AskedMap Viewer::State::restingMap(std::size_t side, const AskedMap& asked) const {
  AskedMap source = askedMap(now(), side);
  const bool may_move = source.name == asked.name && source.photo && asked.photo;
  return may_move && since_photos_changed_s < kRest_s ? asked : source;
}

void Viewer::State::watchPhotos(double seconds) {
  since_photos_changed_s = photos_before == now().photos ? since_photos_changed_s + std::max(seconds, 0.0) : 0.0;
  photos_before = now().photos;
}

void Viewer::State::askDisk(double seconds) {
  constexpr double kPause_s = 1.0;
  since_asked_disk_s += std::max(seconds, 0.0);
  if (since_asked_disk_s < kPause_s) return;
  since_asked_disk_s = 0.0;
  model.askDisk();
  for (const auto& stage : stages) stage->askDisk();
  map.askDisk();
  thumbnails.askDisk();
}

LitStage& Viewer::State::stageOf(std::size_t side) const {
  const bool has_own_map = side == 1 && isComparing() && mapOf(now(), 1) != mapOf(now(), 0);
  return *stages[has_own_map ? 1 : 0];
}

bool Viewer::State::isUpToDate() const {
  if (!model.isUpToDate(now())) return false;
  const std::vector<std::size_t> sides = wantedSides();
  return std::all_of(sides.begin(), sides.end(),
                     [&](std::size_t side) { return stageOf(side).isUpToDate(model, askedMap(now(), side)); });
}

Viewer::Viewer(const Device& device, Workspace start, glm::ivec2 size_px, ViewerOptions options)
    : state_(std::make_unique<State>(device, std::move(start), glm::max(size_px, glm::ivec2(1)), std::move(options))) {}
Viewer::Viewer(Viewer&&) noexcept = default;
Viewer& Viewer::operator=(Viewer&&) noexcept = default;
Viewer::~Viewer() = default;

void Viewer::handle(const Event& event) {
  State& state = *state_;
  if (const auto* resized = std::get_if<Resized>(&event)) {
    state.size_px = glm::max(resized->size_px, glm::ivec2(1));
    return;
  }
  if (const auto* pressed = std::get_if<KeyPressed>(&event))
    if (const ViewerCommand* command = commandOfKey(chordOf(*pressed))) return command->perform(state.history);
  if (const auto* moved = std::get_if<PointerMoved>(&event)) state.pointer_px = moved->place_px;
  // Before there is a model nothing says how far a hand moves.
  if (!state.model.isThere() && !state.now().shows_map) return;
  const bool was_going_on = state.gesture.isGoingOn();
  const ShownPicture shown = state.gesture.asksForPicture(event, state.now()) ? state.shown() : ShownPicture();
  state.apply(state.gesture.handle(event, state.now(), shown));
  if (const auto clicked_px = state.gesture.takeClick()) state.clicked_px = clicked_px;
  if (was_going_on && !state.gesture.isGoingOn()) state.history.endGesture();
}

Result<bool> Viewer::advance(double seconds) {
  State& state = *state_;
  constexpr double kMostFlown_s = 0.1;  // a host may have slept
  if (state.gesture.isFlying())
    state.apply(state.gesture.advance(std::min(seconds, kMostFlown_s), state.now(), state.shown()));
  const bool moved = state.moves();
  state.since_moved_s = std::exchange(state.has_just_moved, false) ? 0.0 : state.since_moved_s + std::max(seconds, 0.0);
  if (moved && !state.moves() && !state.gesture.isGoingOn()) state.history.endGesture();
  if (!state.now().shows_map) state.play(seconds);
  state.askDisk(seconds);
  state.watchPhotos(seconds);
  MIRRORBALL_TRY(is_other_thumbnail, state.thumbnails.follow(state.now()));
  state.takeSaved(seconds);
  if (state.needsMap())
    state.map.follow(state.restingMap(state.sideOfMap(), state.map.loading().asked()), state.options.cache);
  const auto drawn = state.now().shows_map ? state.advanceMap() : state.advanceModel();
  return is_other_thumbnail && drawn ? Result<bool>(true) : drawn;
}

/// What was written is told for as long as a glance needs.
void Viewer::State::takeSaved(double seconds) {
  constexpr double kTold_s = 10.0;
  since_saved_s += std::max(seconds, 0.0);
  if (since_saved_s > kTold_s) saved_last.clear();
  auto saved = saving.take();
  if (!saved) return;
  saved_last = *saved ? "wrote " + **saved : saved->error().message;
  since_saved_s = 0.0;
}

Result<bool> Viewer::State::advanceModel() {
  MIRRORBALL_TRY_VOID(follow());
  MIRRORBALL_TRY_VOID(takeClick());
  MIRRORBALL_TRY_VOID(advanceInspection());
  return advanceSides();
}

bool Viewer::isDone() const {
  const State& state = *state_;
  if (state.has_just_moved || state.moves() || !state.thumbnails.isDone(state.now())) return false;
  if (state.now().shows_map) return state.isMapDone();
  if (state.player.isPlaying()) return false;
  if (state.clicked_px || !state.isUpToDate() || !state.isInspectorDone()) return false;
  const std::vector<std::size_t> sides = state.wantedSides();
  if (!std::all_of(sides.begin(), sides.end(), [&](std::size_t side) { return state.isSideDone(side); })) return false;
  return !state.canCompare() || state.compared.isDone(state.comparedVersion());
}

bool Viewer::isWaiting() const {
  const State& state = *state_;
  ViewerStatus status;
  state.tellLoading(status);
  const bool goes_on_beside = !status.loading.empty() || !state.thumbnails.isDone(state.now());
  if (state.now().shows_map) return goes_on_beside;
  const std::vector<std::size_t> sides = state.wantedSides();
  return goes_on_beside &&
         std::none_of(sides.begin(), sides.end(), [&](std::size_t side) { return state.canGoOn(side); });
}

const Workspace& Viewer::workspace() const { return state_->now(); }

Workspace Viewer::stillWorkspace() const {
  const State& state = *state_;
  return state.player.stopped(state.now(), state.movedFrame(), state.stages[0]->stage().bounds());
}

Workspace Viewer::renderedWorkspace() const {
  Workspace still = stillWorkspace();
  const CameraOptions camera = state_->movedFrame().camera;
  const bool is_placed = camera.orthographic_height ? *camera.orthographic_height > 0.0f : camera.distance.has_value();
  const bool is_framed = camera.name.empty() && !is_placed;
  return is_framed && camera.ground_light.y > 0.0f ? withCamera(std::move(still), state_->shown().camera) : still;
}

History& Viewer::history() { return state_->history; }

ViewerStatus Viewer::status() const {
  const State& state = *state_;
  ViewerStatus status{.animation = animationStatus(state.now(), state.model.rest()),
                      .remark = state.remark(),
                      .problem = state.problem()};
  for (const std::size_t side : state.isComparing() ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{0})
    status.sides.push_back(state.statusOf(side));
  if (state.isComparing()) status.errors = state.compared.errors();
  state.tellLoading(status);
  if (state.saving.isRunning()) status.saving = state.saving_path;
  status.saved = state.saving.share();
  status.saved_last = state.saved_last;
  return status;
}

const Material* Viewer::selectedMaterial() const {
  const auto selected = state_->now().selected_material;
  const Scene& scene = state_->model.withoutParameters();
  return selected && *selected < scene.materials.size() ? &scene.materials[*selected] : nullptr;
}

std::vector<MapThumbnail> Viewer::thumbnails() const { return state_->thumbnails.of(state_->now()); }

UnderPointer Viewer::underPointer() const { return state_->underPointer(); }

bool Viewer::hasPicture() const {
  if (state_->now().shows_map) return state_->map.picture() != nullptr;
  return state_->pictureOf(state_->seenSides().front()) != nullptr;
}

Result<void> Viewer::show(unsigned framebuffer, glm::ivec2 corner, glm::ivec2 size_px) const {
  MIRRORBALL_TRY_VOID(state_->device.state().context.enter());
  const FramebufferPart part{framebuffer, corner, size_px};
  if (hasPicture())
    state_->show(part);
  else
    showNothing(part);
  return {};
}

Result<void> Viewer::leave() const { return state_->device.leave(); }

void Viewer::savePicture(PictureRequest request) {
  State& state = *state_;
  state.saving_path = request.path;
  state.saved_last.clear();
  state.saving.begin([request = std::move(request), workspace = stillWorkspace(),
                      inside_only = state.options.inside_only,
                      cache = state.options.cache](const ProgressFunction& progress) {
    return makePicture(workspace, request, inside_only, cache, progress);
  });
}

void Viewer::cancelSaving() { state_->saving.cancel(); }

Result<Image8> Viewer::picture() const {
  if (!hasPicture()) return fail(ErrorCode::usage, "there is no picture yet");
  const gl::Context& context = state_->device.state().context;
  MIRRORBALL_TRY_VOID(context.enter());
  if (state_->now().shows_map) return state_->map.picture()->readBytes();
  if (!state_->isComparing()) return state_->pictureOf(0)->readBytes();
  const glm::ivec2 size_px = state_->size_px;
  MIRRORBALL_TRY(whole, gl::Framebuffer::make(gl::Format::rgba8, size_px.x, size_px.y));
  state_->show({whole.name(), {0, 0}, size_px});
  return whole.readBytes();
}

}  // namespace mirrorball
