#include "mirrorball/render/frame/renderer.h"

#include <cassert>
#include <future>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/frame/frame_light.h"
#include "mirrorball/render/frame/probes.h"
#include "mirrorball/render/frame/sample_sum.h"
#include "mirrorball/render/frame/scene_drawing.h"
#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/scene/camera/framing.h"

namespace mirrorball {
namespace {

/// The camera with its picture shifted by a part of a pixel.
Camera shifted(Camera camera, glm::vec2 offset_px, glm::ivec2 size) {
  const glm::vec2 ndc = offset_px * 2.0f / glm::vec2(size);
  camera.clip_from_view = glm::translate(glm::mat4(1.0f), glm::vec3(ndc, 0.0f)) * camera.clip_from_view;
  return camera;
}

}  // namespace

struct Renderer::State {
  gl::Context context;  ///< outlives all else
  SampleSum samples;
  SceneDrawing drawing;  ///< the scene
  FrameLight light = {};
  Probes probes = {};
  FrameSettings settings = {};  ///< of the last frame
  FrameUniforms frame = {};     ///< of it
};

void Renderer::End::operator()(State* state) const {
  const gl::Deletion deletion(state->context);
  (void)state->context.leave();  // fails where the deletion leaves all as it is
  delete state;
}

Renderer::Renderer(OwnedState state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::headless() {
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  return on(std::move(context));
}

Result<Renderer> Renderer::on(gl::Context context) {
  MIRRORBALL_TRY_VOID(context.enter());
  const gl::Api api = context.api();
  std::future<Result<Image>> brdf_table = std::async(besideOthers(), surfaceBrdfTable);
  MIRRORBALL_TRY(samples, SampleSum::make(api));
  return Renderer(OwnedState(new State{std::move(context), std::move(samples), SceneDrawing(std::move(brdf_table))}));
}

Result<void> Renderer::setScene(Scene scene) {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  MIRRORBALL_TRY_VOID(state_->drawing.setScene(std::move(scene)));
  state_->light.forgetScene();
  return {};
}

Result<void> Renderer::setEnvironment(Environment environment, const std::optional<CacheFolder>& cache) {
  if (EnvironmentMap* map = environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(prepared, prepareEnvironment(environment, cache));
  return setEnvironment(std::move(environment), prepared);
}

Result<void> Renderer::setEnvironment(Environment environment, const PreparedEnvironment& prepared) {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  state_->probes.forgetLight();
  return state_->light.setEnvironment(std::move(environment), prepared, state_->context.filtersFloats());
}

std::string Renderer::driver() const { return state_->context.renderer(); }

LightCost Renderer::lightCost() const {
  const State& state = *state_;
  const EnvironmentLight& light = state.light.light();
  const PrefilteredChain& chain = state.frame.prefiltered;
  const LightReads reads = lightReads(scene(), blurOf(state.settings, light.cube(), chain), state.settings);
  LightCost cost{.reads = reads.sum()};
  const FlatLight* flat = state.frame.flat;
  if (reads.environment > 0) cost.texture_bytes += (flat ? flat->environment : light.cube()).bytes();
  if (reads.prefiltered > 0) cost.texture_bytes += (flat ? flat->prefiltered : *chain.texture).bytes();
  if (reads.irradiance > 0) cost.texture_bytes += (flat ? flat->irradiance : light.irradiance()).bytes();
  if (state.frame.probes) cost.texture_bytes += state.probes.bytes();
  if (reads.sphere_map > 0) cost.texture_bytes += state.light.sphereMap().bytes();
  return cost;
}

const Scene& Renderer::scene() const { return state_->drawing.scene(); }
const BoundingSphere& Renderer::bounds() const { return state_->drawing.bounds(); }

Result<void> Renderer::moveInstances(const std::vector<Instance>& instances) {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  state_->drawing.moveInstances(instances);
  state_->light.forgetScene();
  return {};
}

int Renderer::probeCaptures() const { return state_->probes.captures(); }

Result<Image8> Renderer::render(const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(draw(settings, progress));
  return picture();
}

Result<Image> Renderer::renderRadiance(const FrameSettings& settings, const ProgressFunction& progress) {
  FrameSettings of_radiance = settings;
  of_radiance.resolve = Resolve::radiance;
  MIRRORBALL_TRY_VOID(draw(of_radiance, progress));
  return radiance();
}

Result<void> Renderer::draw(const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY(camera, cameraFor(settings));
  return draw(camera, settings, progress);
}

Result<void> Renderer::draw(const Camera& camera, const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(begin(camera, settings));
  for (int drawn = 0; drawn < settings.samples;) {
    MIRRORBALL_TRY(now, drawSample());
    drawn = now;
    if (!progress) continue;
    // Else the driver would only take note of what is to be drawn.
    glFinish();
    if (!progress(static_cast<std::size_t>(drawn), static_cast<std::size_t>(settings.samples)))
      return fail(ErrorCode::interrupted, "interrupted; the picture was not written");
  }
  return {};
}

Result<Camera> Renderer::cameraFor(const FrameSettings& settings) const {
  return framedCamera(scene(), bounds(), settings.camera, settings.size);
}

Result<void> Renderer::begin(const FrameSettings& settings) {
  MIRRORBALL_TRY(camera, cameraFor(settings));
  return begin(camera, settings);
}

Result<void> Renderer::begin(const Camera& camera, const FrameSettings& settings) {
  State& state = *state_;
  assert(state.light.hasEnvironment() && "a frame needs an environment");
  MIRRORBALL_TRY_VOID(state.context.enter());
  state.settings = settings;
  state.frame.camera = camera;
  MIRRORBALL_TRY_VOID(state.samples.begin(settings));
  MIRRORBALL_TRY_VOID(state.light.begin(state.context, scene(), bounds(), settings, state.frame));
  state.frame.probes = nullptr;
  MIRRORBALL_TRY_VOID(state.drawing.begin(state.context, settings, state.frame));
  MIRRORBALL_TRY_VOID(state.probes.begin(state.context, state.drawing, state.light.light(), settings, state.frame));
  if (coordinateChoice(scene(), settings).is_sphere_map) MIRRORBALL_TRY_VOID(state.light.makeSphereMap(state.frame));
  return {};
}

Result<int> Renderer::drawSample() {
  State& state = *state_;
  MIRRORBALL_TRY_VOID(state.context.enter());
  const int samples = state.settings.samples;
  const int drawn = state.samples.count();
  if (drawn == samples) return samples;
  const glm::vec2 offset_px = formula::sampleOffset(drawn, samples) - 0.5f;
  FrameUniforms of_sample = state.frame;
  of_sample.camera = shifted(state.frame.camera, offset_px, state.settings.size);
  of_sample.sample = drawn;
  MIRRORBALL_TRY_VOID(state.drawing.draw(state.samples.sample(), state.light.light(), of_sample, state.settings));
  state.samples.add();
  return state.samples.count();
}

Result<void> Renderer::show(unsigned framebuffer) const {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, state_->settings.size.x, state_->settings.size.y);
  // What is written is encoded already.
  const bool encodes = state_->context.api() == gl::Api::desktop43;
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  state_->samples.show();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
  return {};
}

Result<void> Renderer::leave() const { return state_->context.leave(); }

Result<Image> Renderer::radiance() const {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  return state_->samples.radiance();
}

Result<Image8> Renderer::picture() {
  MIRRORBALL_TRY_VOID(state_->context.enter());
  return state_->samples.picture();
}

}  // namespace mirrorball
