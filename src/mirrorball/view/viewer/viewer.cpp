#include "mirrorball/view/viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "mirrorball/environment/file/load.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/surface/map_levels.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/control/gesture.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/time_budget.h"

namespace mirrorball {
namespace {

// After so long without a move the whole picture is drawn.
constexpr double kRest_s = 0.15;

}  // namespace

// What is loaded, and who shows it.
struct ViewedModel {
  Scene scene;
  LevelsOfMaps levels;
};

struct ViewedLight {
  Environment environment;
  PreparedEnvironment prepared;
};

struct Viewer::State {
  /// Something with a name that is loaded beside the viewer when another name is asked for.
  template <typename Value>
  struct Loading {
    BackgroundTask<Value> task;
    std::optional<std::string> asked_for = {};  ///< last
    bool is_there = false;                      ///< something of the kind
  };

  State(const Device& device, Workspace start, glm::ivec2 size, ViewerOptions given)
      : stage(device),
        view(stage),
        history(std::move(start)),
        budget(given.frame_s),
        size_px(size),
        options(std::move(given)) {}

  const Workspace& now() const { return history.now(); }
  /// The first there is.
  const std::string& problem() const {
    for (const std::string* each : {&problems.model, &problems.light, &problems.materials, &problems.preparing})
      if (!each->empty()) return *each;
    return problems.frame;
  }
  ShownPicture shown() const;
  void apply(std::optional<Change> change);
  void load();
  Result<void> takeModel();
  Result<void> takeLight();
  Result<void> changeScene();
  Result<void> changeMaterialsOfStage(bool has_other_options);
  bool moves() const { return since_moved_s < kRest_s; }
  FrameSettings wanted() const;
  Result<std::optional<FrameSettings>> prepared(const FrameSettings& wanted);
  Result<bool> draw(const FrameSettings& frame);
  Result<bool> drawWanted();
  Result<void> keepPicture();
  bool showsMaterials() const;
  /// Tells what fails in a line of `problems`, which is empty where it does not; but a driver that is gone ends all.
  Result<void> tell(Result<void> result, std::string& problem);

  Stage stage;
  View view;
  History history;
  Gesture gesture = {};
  TimeBudget budget;
  glm::ivec2 size_px;
  ViewerOptions options;
  Loading<ViewedModel> model = {};
  Loading<ViewedLight> light = {};
  BackgroundTask<std::shared_ptr<StageWork>> preparing = {};  ///< of the stage, for another technique
  FrameSettings prepared_for = {};                            ///< last
  bool has_changed = true;                                    ///< the stage, since a frame has begun
  Scene loaded = {};                                          ///< as the file has it
  Scene optioned = {};                                        ///< that, as Workspace::materials says
  /// Whose materials the stage shows; nothing: those of the file.
  std::optional<Workspace> changed_for = {};
  std::optional<FrameSettings> begun = {};   ///< of the frame that is drawn
  std::optional<FrameSettings> failed = {};  ///< what could not be drawn; problems.frame says why
  int programs_left = 0;
  double since_moved_s = kRest_s;
  bool has_just_moved = false;  ///< since the last `advance`
  double sample_s = 0.0;
  int samples_shown = 0;
  struct {
    std::string model, light, materials, preparing, frame;
  } problems = {};
  struct OnDevice {
    Device device;  ///< outlives all else
    std::optional<gl::Framebuffer> picture = {};
  };
  std::unique_ptr<OnDevice, EndOnDevice> on{new OnDevice{stage.device()}};
};

namespace {

Result<ViewedModel> loadedModel(const std::string& name, bool inside_only, const ProgressFunction& progress) {
  MIRRORBALL_TRY(scene, loadModel(name, {.inside_only = inside_only}));
  MIRRORBALL_TRY(levels, makeMapLevels(scene, progress));
  return ViewedModel{std::move(scene), std::move(levels)};
}

Result<ViewedLight> loadedLight(const std::string& name, const std::optional<CacheFolder>& cache,
                                const ProgressFunction& progress) {
  MIRRORBALL_TRY(loaded, loadEnvironment(name, {}, progress));
  if (EnvironmentMap* map = loaded.environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(prepared, prepareEnvironment(loaded.environment, cache, progress));
  return ViewedLight{std::move(loaded.environment), std::move(prepared)};
}

}  // namespace

ShownPicture Viewer::State::shown() const {
  FrameSettings frame = frameOf(now(), editedSide(now())).value_or(FrameSettings());
  standOnGround(frame);
  const float aspect = static_cast<float>(size_px.x) / static_cast<float>(size_px.y);
  return {.camera = placedCamera(stage.scene(), stage.bounds(), frame.camera, aspect),
          .bounds = stage.bounds(),
          .size_px = size_px,
          .env_rotation_deg = frame.env_rotation_deg};
}

void Viewer::State::apply(std::optional<Change> change) {
  if (!change || change->next == now()) return;
  has_just_moved = change->goes_on;
  history.change(std::move(change->name), std::move(change->next), change->goes_on);
}

Result<void> Viewer::State::tell(Result<void> result, std::string& problem) {
  if (!result && result.error().code == ErrorCode::no_gl) return result;
  problem = result ? std::string() : std::move(result).error().message;
  return {};
}

void Viewer::State::load() {
  if (const std::string& name = now().model; std::exchange(model.asked_for, name) != name)
    model.task.begin([name, inside_only = options.inside_only](const ProgressFunction& progress) {
      return loadedModel(name, inside_only, progress);
    });
  if (const std::string& name = mapOf(now(), 0); std::exchange(light.asked_for, name) != name)
    light.task.begin(
        [name, cache = options.cache](const ProgressFunction& progress) { return loadedLight(name, cache, progress); });
}

Result<void> Viewer::State::takeModel() {
  auto ready = model.task.take();
  if (!ready) return {};
  if (!*ready) return tell(fail(std::move(*ready)), problems.model);
  const auto is_set = stage.setScene((*ready)->scene, (*ready)->levels);
  if (!is_set) return tell(is_set, problems.model);
  loaded = optioned = std::move((*ready)->scene);
  changed_for.reset();
  problems.model.clear();
  problems.materials.clear();
  budget.forget();
  model.is_there = has_changed = true;
  return {};
}

Result<void> Viewer::State::takeLight() {
  auto ready = light.task.take();
  if (!ready) return {};
  if (!*ready) return tell(fail(std::move(*ready)), problems.light);
  light.is_there = has_changed = true;
  return tell(stage.setEnvironment(std::move((*ready)->environment), (*ready)->prepared), problems.light);
}

bool Viewer::State::showsMaterials() const {
  if (!changed_for) return now().materials.empty() && now().parameters.empty();
  return changed_for->materials == now().materials && changed_for->parameters == now().parameters;
}

/// Gives a model the materials that are asked for, unless another model is asked for.
Result<void> Viewer::State::changeScene() {
  if (showsMaterials() || model.task.isRunning() || !problems.model.empty()) return {};
  const bool has_other_options = !changed_for || changed_for->materials != now().materials;
  changed_for = now();
  return tell(changeMaterialsOfStage(has_other_options), problems.materials);
}

Result<void> Viewer::State::changeMaterialsOfStage(bool has_other_options) {
  if (has_other_options) {
    MIRRORBALL_TRY(changes, materialsOf(now().materials));
    Scene changed = loaded;
    MIRRORBALL_TRY_VOID(changeMaterials(changed, changes));
    optioned = std::move(changed);
  }
  Scene changed = optioned;
  MIRRORBALL_TRY_VOID(changeParameters(changed, now()));
  has_changed = true;
  return stage.setScene(std::move(changed));
}

FrameSettings Viewer::State::wanted() const {
  FrameSettings frame = frameOf(now(), 0).value_or(FrameSettings());
  frame.proxy.load.inside_only = options.inside_only;
  frame.size = moves() ? budget.sizeFor(size_px) : size_px;
  if (moves()) frame.samples = 1;
  standOnGround(frame);
  return frame;
}

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

}  // namespace

/// Prepares the stage for what is wanted.
///
/// returns  what can be drawn meanwhile: what is wanted, the technique before, or nothing
Result<std::optional<FrameSettings>> Viewer::State::prepared(const FrameSettings& wanted) {
  if (auto ready = preparing.take()) {
    const auto taken = *ready ? stage.take(std::move(***ready)) : Result<bool>(fail(std::move(*ready)));
    MIRRORBALL_TRY_VOID(
        tell(taken ? Result<void>() : Result<void>(tl::unexpected<Error>(taken.error())), problems.preparing));
  }
  if (begun && !has_changed && seenAs(*begun, wanted) == wanted) return std::optional(wanted);
  const bool has_failed = !problems.preparing.empty() && seenAs(prepared_for, wanted) == wanted;
  if (!preparing.isRunning() && !has_failed) {
    problems.preparing.clear();
    MIRRORBALL_TRY(work, stage.workFor(wanted));
    if (!work.isNeeded()) return std::optional(wanted);
    prepared_for = wanted;
    preparing.begin([work = std::make_shared<StageWork>(std::move(work))](
                        const ProgressFunction& progress) -> Result<std::shared_ptr<StageWork>> {
      MIRRORBALL_TRY_VOID(work->run(progress));
      return work;
    });
  }
  return begun && !has_changed ? std::optional(seenAs(*begun, wanted)) : std::nullopt;
}

/// Keeps what the view has drawn, which another frame then does not take away.
Result<void> Viewer::State::keepPicture() {
  MIRRORBALL_TRY_VOID(gl::resize(on->picture, gl::Format::rgba8, begun->size));
  return view.show(on->picture->name());
}

Result<bool> Viewer::State::draw(const FrameSettings& frame) {
  if (!begun || has_changed || *begun != frame) {
    begun.reset();  // until it has begun
    MIRRORBALL_TRY_VOID(view.begin(frame));
    begun = frame;
    has_changed = false;
    programs_left = 1;
  }
  if (programs_left > 0) {
    MIRRORBALL_TRY(left, view.makeProgram());
    programs_left = left;
    if (left > 0) return false;
  }
  if (view.isDone()) return false;
  const auto start = std::chrono::steady_clock::now();
  MIRRORBALL_TRY(drawn, view.drawSample());
  glFinish();
  sample_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (drawn == 1) budget.drew(begun->size, sample_s);  // later ones may be of a few pixels
  samples_shown = drawn;
  MIRRORBALL_TRY_VOID(keepPicture());
  return true;
}

/// Draws a piece of what is wanted, or tells why not.
Result<bool> Viewer::State::drawWanted() {
  const FrameSettings frame = wanted();
  if (failed && (*failed != frame || has_changed)) failed.reset();
  if (failed) return false;
  auto drawn = [&]() -> Result<bool> {
    if (const auto given = frameOf(now(), 0); !given) return tl::unexpected<Error>(given.error());
    MIRRORBALL_TRY(can_be_drawn, prepared(frame));
    return can_be_drawn ? draw(*can_be_drawn) : Result<bool>(false);
  }();
  if (!drawn) failed = frame;
  const bool is_other = drawn && *drawn;
  MIRRORBALL_TRY_VOID(tell(drawn ? Result<void>() : fail(std::move(drawn)), problems.frame));
  return is_other;
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
  // Before there is a model nothing says how far a hand moves.
  if (!state.model.is_there) return;
  const bool was_going_on = state.gesture.isGoingOn();
  const ShownPicture shown = state.gesture.asksForPicture(event) ? state.shown() : ShownPicture();
  state.apply(state.gesture.handle(event, state.now(), shown));
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
  state.load();
  MIRRORBALL_TRY_VOID(state.takeModel());
  MIRRORBALL_TRY_VOID(state.takeLight());
  if (!state.model.is_there || !state.light.is_there) return false;
  MIRRORBALL_TRY_VOID(state.changeScene());
  return state.drawWanted();
}

bool Viewer::isWaiting() const {
  const State& state = *state_;
  const bool loads = state.model.task.isRunning() || state.light.task.isRunning() || state.preparing.isRunning();
  return loads && !(state.begun && !state.has_changed && !state.view.isDone());
}

bool Viewer::isDone() const {
  const State& state = *state_;
  if (state.has_just_moved || state.moves()) return false;
  if (state.model.task.isRunning() || state.light.task.isRunning() || state.preparing.isRunning()) return false;
  if (state.model.asked_for != state.now().model) return false;
  if (state.light.asked_for != mapOf(state.now(), 0)) return false;
  if (!state.model.is_there || !state.light.is_there) return true;
  if (!state.showsMaterials() && state.problems.model.empty()) return false;
  const FrameSettings wanted = state.wanted();
  if (state.failed == wanted) return true;
  const bool shows_other = !state.problems.preparing.empty() && state.begun;  // since what is wanted cannot be prepared
  return state.begun && (shows_other || *state.begun == wanted) && !state.has_changed && state.programs_left == 0 &&
         state.view.isDone();
}

const Workspace& Viewer::workspace() const { return state_->now(); }
History& Viewer::history() { return state_->history; }

ViewerStatus Viewer::status() const {
  const State& state = *state_;
  ViewerStatus status{.programs_left = state.programs_left,
                      .samples = state.samples_shown,
                      .wanted_samples = state.begun ? state.begun->samples : 0,
                      .size_px = state.on->picture ? glm::ivec2(state.on->picture->width(), state.on->picture->height())
                                                   : glm::ivec2(0),
                      .sample_s = state.sample_s,
                      .problem = state.problem()};
  if (state.model.task.isRunning()) {
    status.loading = *state.model.asked_for;
    status.loaded = state.model.task.share();
  } else if (state.light.task.isRunning()) {
    status.loading = *state.light.asked_for;
    status.loaded = state.light.task.share();
  } else if (state.preparing.isRunning()) {
    status.loading = "what frames need of the scene";
    status.loaded = state.preparing.share();
  }
  return status;
}

const Material* Viewer::selectedMaterial() const {
  const auto selected = state_->now().selected_material;
  return selected && *selected < state_->optioned.materials.size() ? &state_->optioned.materials[*selected] : nullptr;
}

bool Viewer::hasPicture() const { return state_->on->picture.has_value(); }

Result<void> Viewer::show(unsigned framebuffer, glm::ivec2 corner, glm::ivec2 size_px) const {
  if (!hasPicture()) return fail(ErrorCode::usage, "there is no picture yet");
  const gl::Context& context = state_->stage.device().state().context;
  MIRRORBALL_TRY_VOID(context.enter());
  const gl::Framebuffer& picture = *state_->on->picture;
  const glm::ivec2 end = corner + size_px;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  // The picture is encoded already.
  const bool encodes = context.api() == gl::Api::desktop43;
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  glBlitFramebuffer(0, 0, picture.width(), picture.height(), corner.x, corner.y, end.x, end.y, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  return {};
}

Result<void> Viewer::leave() const { return state_->stage.device().leave(); }

Result<Image8> Viewer::picture() const {
  if (!hasPicture()) return fail(ErrorCode::usage, "there is no picture yet");
  MIRRORBALL_TRY_VOID(state_->stage.device().state().context.enter());
  return state_->on->picture->readBytes();
}

}  // namespace mirrorball
