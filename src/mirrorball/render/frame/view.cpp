#include "mirrorball/render/frame/view.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/frame/frame_light.h"
#include "mirrorball/render/frame/probes.h"
#include "mirrorball/render/frame/sample_sum.h"
#include "mirrorball/render/frame/scene_drawing.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/render/surface/pixel_cells.h"
#include "mirrorball/scene/camera/framing.h"

namespace mirrorball {

/// What a view has on a device.
struct View::OnDevice {
  explicit OnDevice(const Stage& stage)
      : device(stage.device()), drawing(device.state()), light(device.state(), stage.state().light) {}

  Device device;                          ///< outlives all else
  std::optional<SampleSum> samples = {};  ///< made for the first frame
  SceneDrawing drawing;
  FrameLight light;
  Probes probes = {};
  FrameUniforms frame = {};  ///< of the last frame
};

struct View::State {
  explicit State(Stage of) : stage(std::move(of)), on(new OnDevice(stage)) {}

  /// When the stage last changed.
  using Version = std::array<std::uint64_t, 2>;
  Version version() const { return {stage.state().scene.version(), stage.state().light.version()}; }
  /// Whether the frame that is wanted has begun, of what the stage is now.
  bool isCurrent() const { return is_begun && on->device == stage.device() && begun_of == version(); }

  Stage stage;
  std::unique_ptr<OnDevice, EndOnDevice> on;
  std::optional<FrameSettings> wanted = {};  ///< of the last frame that was asked for
  std::optional<Camera> given_camera = {};   ///< of it; else it is the settings'
  bool is_begun = false;                     ///< that frame
  Version begun_of = {};                     ///< the stage's version then
};

View::View(const Stage& stage) : state_(std::make_unique<State>(stage)) {}
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;
View::~View() = default;

const Stage& View::stage() const { return state_->stage; }

LightCost View::lightCost() const {
  if (!state_->isCurrent()) return {};
  const OnDevice& on = *state_->on;
  const FrameSettings& settings = *state_->wanted;
  const EnvironmentLight& light = on.light.light();
  const PrefilteredChain& chain = on.frame.light.prefiltered;
  const LightReads reads = lightReads(on.drawing.scene(), blurOf(settings, light.cube(), chain), settings);
  LightCost cost{.reads = reads.sum()};
  const FlatLight* flat = on.frame.light.flat;
  if (reads.environment > 0) cost.texture_bytes += (flat ? flat->environment : light.cube()).bytes();
  if (reads.prefiltered > 0) cost.texture_bytes += (flat ? flat->prefiltered : *chain.texture).bytes();
  if (reads.irradiance > 0) cost.texture_bytes += (flat ? flat->irradiance : light.irradiance()).bytes();
  if (on.frame.probes) cost.texture_bytes += on.probes.bytes();
  if (const gl::Texture* shadows = on.frame.light.suns.shadows) cost.texture_bytes += shadows->bytes();
  if (reads.sphere_map > 0) cost.texture_bytes += on.light.sphereMap().bytes();
  return cost;
}

int View::probeCaptures() const { return state_->on->probes.captures(); }

Result<Image8> View::render(const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(draw(settings, progress));
  return picture();
}

Result<Image> View::renderRadiance(const FrameSettings& settings, const ProgressFunction& progress) {
  FrameSettings of_radiance = settings;
  of_radiance.resolve = Resolve::radiance;
  MIRRORBALL_TRY_VOID(draw(of_radiance, progress));
  return radiance();
}

namespace {

/// Draws all samples of a frame that has begun.
Result<void> drawSamples(View& view, int samples, const ProgressFunction& progress) {
  for (int drawn = 0; drawn < samples;) {
    MIRRORBALL_TRY(now, view.drawSample());
    drawn = now;
    if (!progress) continue;
    // Else the driver would only take note of what is to be drawn.
    glFinish();
    if (!progress(static_cast<std::size_t>(drawn), static_cast<std::size_t>(samples)))
      return fail(ErrorCode::interrupted, "interrupted; the picture was not written");
  }
  return {};
}

}  // namespace

Result<void> View::draw(const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(begin(settings));
  return drawSamples(*this, settings.samples, progress);
}

Result<void> View::draw(const Camera& camera, const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(begin(camera, settings));
  return drawSamples(*this, settings.samples, progress);
}

Result<void> View::begin(const FrameSettings& settings) {
  state_->wanted = settings;
  state_->given_camera.reset();
  return start();
}

Result<void> View::begin(const Camera& camera, const FrameSettings& settings) {
  state_->wanted = settings;
  state_->given_camera = camera;
  return start();
}

Result<void> View::enter() const { return state_->on->device.state().context.enter(); }

/// Begins the frame that is wanted.
Result<void> View::start() {
  State& state = *state_;
  state.is_begun = false;  // until all is there
  const Stage::State& staged = state.stage.state();
  if (!state.wanted) return fail(ErrorCode::usage, "no frame has been asked for");
  if (!staged.light.has()) return fail(ErrorCode::usage, "the stage has no environment, whose light a frame needs");
  const FrameSettings& settings = *state.wanted;
  if (state.on->device != state.stage.device()) state.on.reset(new OnDevice(state.stage));
  MIRRORBALL_TRY_VOID(enter());
  OnDevice& on = *state.on;
  const gl::Api api = on.device.state().context.api();
  MIRRORBALL_TRY(form, state.stage.state().formFor(settings));
  on.drawing.show(form);
  FrameUniforms frame;
  if (state.given_camera) {
    frame.sample.camera = *state.given_camera;
  } else {
    MIRRORBALL_TRY(camera, framedCamera(form->scene(), form->bounds(), settings.camera, settings.size, form->runs()));
    frame.sample.camera = camera;
  }
  if (!on.samples) on.samples.emplace(api);
  MIRRORBALL_TRY_VOID(on.samples->begin(settings));
  MIRRORBALL_TRY(light, on.light.begin(*form, settings, frame.sample.camera, staged.cache));
  frame.light = light;
  MIRRORBALL_TRY(scene, on.drawing.begin(settings, frame.sample, *light.proxy));
  frame.scene = scene;
  frame.sample.mask = on.samples->mask();
  MIRRORBALL_TRY(probes, on.probes.begin(api, on.drawing, on.light.light(), staged.light.version(), settings, frame));
  frame.probes = probes;
  on.frame = frame;
  state.begun_of = state.version();
  state.is_begun = true;
  return {};
}

bool View::isDone() const { return state_->isCurrent() && state_->on->samples->count() == state_->wanted->samples; }

const Camera& View::camera() const { return state_->on->frame.sample.camera; }

Result<void> View::enterDrawn() const {
  if (!state_->is_begun || state_->on->samples->count() == 0)
    return fail(ErrorCode::usage, "no sample of the frame has been drawn");
  return enter();
}

Result<int> View::makeProgram() {
  if (!state_->isCurrent()) MIRRORBALL_TRY_VOID(start());
  MIRRORBALL_TRY_VOID(enter());
  OnDevice& on = *state_->on;
  return on.drawing.makeProgram(on.samples->sample(), on.light.light(), on.frame, *state_->wanted);
}

Result<std::vector<SurfaceVariant>> View::surfaceVariants() {
  if (!state_->isCurrent()) MIRRORBALL_TRY_VOID(start());
  MIRRORBALL_TRY_VOID(enter());
  OnDevice& on = *state_->on;
  return on.drawing.variants(on.light.light(), on.frame, *state_->wanted);
}

Result<int> View::drawSample() {
  State& state = *state_;
  if (!state.isCurrent()) MIRRORBALL_TRY_VOID(start());
  MIRRORBALL_TRY_VOID(enter());
  OnDevice& on = *state.on;
  const FrameSettings& settings = *state.wanted;
  const int drawn = on.samples->count();
  if (drawn == settings.samples) return drawn;
  const glm::vec2 offset_px = 0.5f - placeOfSample(drawn, settings.samples);
  FrameUniforms of_sample = on.frame;
  of_sample.sample.camera = shiftedInPixel(on.frame.sample.camera, offset_px, settings.size);
  of_sample.sample.number = drawn;
  MIRRORBALL_TRY_VOID(on.drawing.draw(on.samples->sample(), on.light.light(), of_sample, settings));
  on.samples->add();
  return on.samples->count();
}

Result<void> View::show(unsigned framebuffer, glm::ivec2 corner) const {
  MIRRORBALL_TRY_VOID(enterDrawn());
  const glm::ivec2 size = state_->wanted->size;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(corner.x, corner.y, size.x, size.y);
  // What is written is encoded already.
  const bool encodes = state_->on->device.state().context.api() == gl::Api::desktop43;
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  state_->on->samples->show();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
  return {};
}

Result<std::optional<Picked>> View::pick(glm::vec2 place) {
  MIRRORBALL_TRY_VOID(enterDrawn());
  if (!state_->isCurrent())
    return fail(ErrorCode::usage, "the stage has changed since the frame was drawn; draw a sample first");
  OnDevice& on = *state_->on;
  const FrameSettings& settings = *state_->wanted;
  const glm::ivec2 pixel(glm::floor(place));
  if (glm::any(glm::lessThan(pixel, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, settings.size)))
    return std::optional<Picked>();
  MIRRORBALL_TRY(rays, on.drawing.staged().rays());
  const EyeRay ray = EyeRays(on.frame.sample.camera, settings.size).through(place);
  const Scene& shown = on.drawing.scene();
  std::optional<Picked> picked = pickAlong(ray, shown, rays->geometry, settings);
  if (!picked) return picked;
  picked->radiance = on.samples->lastRadiance(pixel);
  const auto mesh = static_cast<std::size_t>(shown.instances[picked->instance].mesh);
  if (shown.meshes[mesh]->indices.size() != state_->stage.scene().meshes[mesh]->indices.size())
    picked->triangle.reset();
  return picked;
}

Result<Image> View::radiance() const {
  MIRRORBALL_TRY_VOID(enterDrawn());
  return state_->on->samples->radiance();
}

Result<Image8> View::picture() {
  MIRRORBALL_TRY_VOID(enterDrawn());
  return state_->on->samples->picture();
}

Result<Image> View::displayedLight() {
  MIRRORBALL_TRY_VOID(enterDrawn());
  return state_->on->samples->displayedLight();
}

}  // namespace mirrorball
