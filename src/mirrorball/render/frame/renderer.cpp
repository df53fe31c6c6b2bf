#include "mirrorball/render/frame/renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <future>
#include <optional>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/prefilter.h"
#include "formula/projection.h"
#include "formula/surface.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/frame/background.h"
#include "mirrorball/render/light/gpu_prefilter.h"
#include "mirrorball/render/surface/back_faces.h"
#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/render/surface/relief_hits.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/render/surface/sphere_map.h"
#include "mirrorball/render/surface/surface_program.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/bodies/surrounding_media.h"
#include "mirrorball/scene/camera/framing.h"

namespace mirrorball {
namespace {

/// The camera with its picture shifted by a part of a pixel.
Camera shifted(Camera camera, glm::vec2 offset_px, glm::ivec2 size) {
  const glm::vec2 ndc = offset_px * 2.0f / glm::vec2(size);
  camera.clip_from_view = glm::translate(glm::mat4(1.0f), glm::vec3(ndc, 0.0f)) * camera.clip_from_view;
  return camera;
}

/// What is behind all that is drawn: a display's colour, or nothing.
glm::vec4 backdropOf(const FrameSettings& settings) {
  return settings.background == BackgroundKind::display_color ? glm::vec4(settings.background_color, 1.0f)
                                                              : glm::vec4(0.0f);
}

/// Whether the mean of the samples is of a display's light. One sample is kept as radiance:
/// there is nothing to average.
bool isDisplayed(const FrameSettings& settings) { return settings.resolve == Resolve::display && settings.samples > 1; }

/// How a display shows radiance, for shaders/accumulate.frag and tone_map.frag.
void setDisplay(gl::Program& program, const FrameSettings& settings) {
  program.set("as_displayed", isDisplayed(settings) ? 1.0f : 0.0f);
  program.set("exposure", settings.display.exposure());
  program.set("tone_map", static_cast<int>(settings.display.tone_map));
}

/// The middle of the box around a mesh, in its own frame.
glm::vec3 centerOf(const Mesh& mesh) {
  if (mesh.vertices.empty()) return glm::vec3(0.0f);
  glm::vec3 low = mesh.vertices.front().position;
  glm::vec3 high = low;
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  return (low + high) / 2.0f;
}

}  // namespace

struct Renderer::State {
  gl::Context context;  ///< outlives all else
  gl::Program accumulate;
  gl::Program tone_map;
  std::future<Result<Image>> brdf_table;  ///< for `surfaces`; made while the driver takes in the rest
  Scene scene = {};
  std::optional<Environment> environment = {};
  std::optional<EnvironmentLight> light = {};
  SceneBuffers buffers = {};
  BoundingSphere bounds = {};
  std::vector<glm::vec3> centers = {};           ///< of the meshes: centerOf
  std::optional<SurfacePrograms> surfaces = {};  ///< made for the first frame
  gl::VertexArray screen = {};
  Background background = {};
  ProxyUniforms proxy = {};
  std::optional<LightSampler> ground_sampler = {};   ///< of the environment, made when a frame first has a ground
  std::optional<GroundShadow> ground_shadow = {};    ///< of the scene, likewise
  std::optional<glm::mat3> shadow_environment = {};  ///< environment_from_world that it was drawn for; none: redraw it
  std::optional<GpuPrefilter> gpu_prefilter = {};    ///< made when BlurKind::gpu first asks for it
  std::optional<FlatLight> flat_light = {};          ///< made when LightLookUp::flat first asks for it
  const gl::Texture* flattened_chain = nullptr;      ///< that it was made from
  std::optional<gl::Texture> sphere_map = {};
  std::optional<BodyTree> body_tree = {};      ///< of the scene, made when it is first traced
  std::optional<gl::Texture> bodies = {};      ///< its words
  std::optional<BackFaces> back_faces = {};    ///< made when a frame first needs them
  std::optional<ReliefHits> relief_hits = {};  ///< likewise
  std::optional<gl::Framebuffer> sample = {};  ///< one sample's picture
  std::optional<gl::Framebuffer> sum = {};     ///< the mean, when there is more than one
  std::optional<gl::Framebuffer> display = {};
  FrameSettings settings = {};  ///< of the last frame
  FrameUniforms frame = {};     ///< of it
  int samples_drawn = 0;        ///< of it

  const gl::Framebuffer& result() const { return settings.samples > 1 ? *sum : *sample; }

  Result<void> chooseFilter();
  Result<void> makeSurfaces();
  Result<void> makeFramebuffers();
  Result<void> makePrisms();
  Result<void> placeProxy();
  Result<void> makeGroundShadow();
  Result<PrefilteredChain> prefilteredChain();
  Result<void> makeFlatLight();
  Result<void> makeSphereMap();
  bool someRefract(RefractionKind kind) const;
  Result<void> makeBodies();
  Result<void> drawBackFaces(const Camera& camera);
  Result<void> drawReliefHits(const Camera& camera);
  Result<void> drawSample(const Camera& camera);
  void drawInstance(int instance);
  std::vector<int> byDistance(const Camera& camera, bool is_blended) const;
  void drawOpaque(const Camera& camera);
  void drawBlended(const Camera& camera);
  void addSample();
  void drawPicture();
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::headless() {
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  return on(std::move(context));
}

Result<Renderer> Renderer::on(gl::Context context) {
  const gl::Api api = context.api();
  std::future<Result<Image>> brdf_table = std::async(besideOthers(), surfaceBrdfTable);
  MIRRORBALL_TRY(accumulate, gl::Program::load(api, "screen.vert", "accumulate.frag"));
  MIRRORBALL_TRY(tone_map, gl::Program::load(api, "screen.vert", "tone_map.frag"));
  return Renderer(std::unique_ptr<State>(
      new State{std::move(context), std::move(accumulate), std::move(tone_map), std::move(brdf_table)}));
}

Result<void> Renderer::setScene(Scene scene) {
  State& state = *state_;
  MIRRORBALL_TRY(buffers, SceneBuffers::make(scene, TextureUnit::of_material));
  state.scene = std::move(scene);
  state.buffers = std::move(buffers);
  state.bounds = boundingSphere(state.scene);
  state.centers.clear();
  for (const Mesh& mesh : state.scene.meshes) state.centers.push_back(centerOf(mesh));
  state.body_tree.reset();
  state.bodies.reset();
  state.proxy.forgetScene();
  state.ground_shadow.reset();
  state.shadow_environment.reset();
  if (state.surfaces) state.surfaces->forgetScene();
  return {};
}

Result<void> Renderer::setEnvironment(Environment environment, const std::optional<PrefilterCache>& cache) {
  if (EnvironmentMap* map = environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(prepared, prepareEnvironment(environment, cache));
  return setEnvironment(std::move(environment), prepared);
}

Result<void> Renderer::setEnvironment(Environment environment, const PreparedEnvironment& prepared) {
  State& state = *state_;
  MIRRORBALL_TRY(light, EnvironmentLight::make(prepared, state.context.filtersFloats()));
  state.light = std::move(light);
  state.environment = std::move(environment);
  state.gpu_prefilter.reset();
  state.flat_light.reset();
  state.ground_sampler.reset();
  state.shadow_environment.reset();
  return {};
}

std::string Renderer::driver() const { return state_->context.renderer(); }

LightCost Renderer::lightCost() const {
  const State& state = *state_;
  const EnvironmentLight& light = *state.light;
  const PrefilteredChain& chain = state.frame.prefiltered;
  const LightReads reads = lightReads(state.scene, blurOf(state.settings, light, chain), state.settings);
  LightCost cost{.reads = reads.sum()};
  const FlatLight* flat = state.frame.flat;
  if (reads.environment > 0) cost.texture_bytes += (flat ? flat->environment : light.cube()).bytes();
  if (reads.prefiltered > 0) cost.texture_bytes += (flat ? flat->prefiltered : *chain.texture).bytes();
  if (reads.irradiance > 0) cost.texture_bytes += (flat ? flat->irradiance : light.irradiance()).bytes();
  if (reads.sphere_map > 0) cost.texture_bytes += state.sphere_map->bytes();
  return cost;
}

const Scene& Renderer::scene() const { return state_->scene; }
const BoundingSphere& Renderer::bounds() const { return state_->bounds; }

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
  return framedCamera(state_->scene, state_->bounds, settings.camera, settings.size);
}

Result<void> Renderer::begin(const FrameSettings& settings) {
  MIRRORBALL_TRY(camera, cameraFor(settings));
  return begin(camera, settings);
}

Result<void> Renderer::begin(const Camera& camera, const FrameSettings& settings) {
  State& state = *state_;
  assert(state.light && "a frame needs an environment");
  MIRRORBALL_TRY_VOID(state.makeSurfaces());
  state.settings = settings;
  state.samples_drawn = 0;
  MIRRORBALL_TRY_VOID(state.makeFramebuffers());
  MIRRORBALL_TRY_VOID(state.makePrisms());
  MIRRORBALL_TRY_VOID(state.placeProxy());
  state.light->readNearest(false);
  MIRRORBALL_TRY(chain, state.prefilteredChain());
  state.frame.prefiltered = chain;
  MIRRORBALL_TRY_VOID(state.chooseFilter());
  state.frame.camera = camera;
  state.frame.environment_from_world = settings.environmentFromWorld();
  MIRRORBALL_TRY_VOID(state.makeBodies());
  MIRRORBALL_TRY_VOID(state.makeFlatLight());
  MIRRORBALL_TRY(coordinates, coordinateMatrices(state.scene, state.bounds, camera, settings));
  state.frame.coordinates = coordinates;
  if (coordinateChoice(state.scene, settings).is_sphere_map) MIRRORBALL_TRY_VOID(state.makeSphereMap());
  return {};
}

Result<int> Renderer::drawSample() {
  State& state = *state_;
  const int samples = state.settings.samples;
  if (state.samples_drawn == samples) return samples;
  const glm::vec2 offset_px = formula::sampleOffset(state.samples_drawn, samples) - 0.5f;
  MIRRORBALL_TRY_VOID(state.drawSample(shifted(state.frame.camera, offset_px, state.settings.size)));
  if (samples > 1) state.addSample();
  return ++state.samples_drawn;
}

void Renderer::show(unsigned framebuffer) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, state_->settings.size.x, state_->settings.size.y);
  // What is written is encoded already.
  const bool encodes = state_->context.api() == gl::Api::desktop43;
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  state_->drawPicture();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
}

Image Renderer::radiance() const {
  assert(!isDisplayed(state_->settings));
  Image image = state_->result().readFloat();
  if (const glm::vec4 backdrop = backdropOf(state_->settings); backdrop.w > 0.0f) layOver(image, backdrop);
  return image;
}

Result<Image8> Renderer::picture() {
  State& state = *state_;
  const glm::ivec2 size = state.settings.size;
  if (!state.display || state.display->width() != size.x || state.display->height() != size.y) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba8, size.x, size.y, false));
    state.display = std::move(made);
  }
  state.display->bind();
  state.drawPicture();
  return state.display->readBytes();
}

/// Tone maps the mean of the samples that there are.
void Renderer::State::drawPicture() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  result().color().bind(TextureUnit::picture);
  tone_map.set("picture", TextureUnit::picture);
  tone_map.set("share",
               settings.samples > 1 ? static_cast<float>(settings.samples) / static_cast<float>(samples_drawn) : 1.0f);
  setDisplay(tone_map, settings);
  tone_map.set("backdrop", backdropOf(settings));
  screen.draw(3);
}

Result<void> Renderer::State::makeSurfaces() {
  if (surfaces) return {};
  MIRRORBALL_TRY(table, brdf_table.get());
  MIRRORBALL_TRY(made, SurfacePrograms::make(context.api(), table));
  surfaces = std::move(made);
  return {};
}

/// Tells the textures how they are read; the rest the shaders know.
Result<void> Renderer::State::chooseFilter() {
  const bool is_anisotropic = settings.texture_filter == TextureFilter::anisotropic;
  const float anisotropy = std::min(context.largestAnisotropy(), static_cast<float>(formula::kMostReads));
  if (is_anisotropic && anisotropy <= 1.0f)
    return fail(ErrorCode::unsupported, "the graphics driver (" + context.renderer() +
                                            ") has no anisotropic filter (EXT_texture_filter_anisotropic); choose the "
                                            "trilinear one");
  buffers.filterMaps(scene, settings.texture_filter, anisotropy);
  light->readNearest(settings.texture_filter == TextureFilter::nearest);
  return {};
}

/// Of the meshes whose relief is found exactly.
Result<void> Renderer::State::makePrisms() {
  if (settings.relief != ReliefKind::exact) return {};
  for (const Mesh& mesh : scene.meshes)
    if (showsHeightTexture(scene.materials[std::size_t(mesh.material)], settings.relief))
      MIRRORBALL_TRY_VOID(buffers.makePrisms(scene, static_cast<int>(&mesh - scene.meshes.data())));
  return {};
}

/// What the environment's light comes from, with the shadow on it.
Result<void> Renderer::State::placeProxy() {
  if (proxy.isOther(settings.proxy)) shadow_environment.reset();
  MIRRORBALL_TRY_VOID(proxy.place(settings.proxy, scene));
  frame.proxy = &proxy;
  MIRRORBALL_TRY_VOID(background.make(context.api(), proxy));
  return settings.proxy.kind == ProxyKind::ground ? makeGroundShadow() : Result<void>();
}

Result<void> Renderer::State::makeGroundShadow() {
  constexpr int kLights = 96;
  constexpr int kTexels = 512;  // about as small as the sun
  const glm::mat3 environment_from_world = settings.environmentFromWorld();
  if (shadow_environment == environment_from_world) return {};
  if (!ground_sampler) {
    MIRRORBALL_TRY(sampler, LightSampler::make(*environment, {}, kTexels));
    ground_sampler = std::move(sampler);
  }
  if (!ground_shadow) {
    MIRRORBALL_TRY(made, GroundShadow::make(context.api(), scene, bounds));
    ground_shadow = std::move(made);
  }
  const GroundLights lights = groundLights(*environment, *ground_sampler, environment_from_world, kLights);
  ground_shadow->draw(scene, proxy.proxy(), lights);
  proxy.setShadow(*ground_shadow, lights.irradiance / light->unit());
  shadow_environment = environment_from_world;
  return {};
}

Result<void> Renderer::State::makeFramebuffers() {
  const glm::ivec2 size = settings.size;
  if (!sample || sample->width() != size.x || sample->height() != size.y) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba32f, size.x, size.y, true));
    sample = std::move(made);
    sum.reset();
  }
  if (settings.samples > 1 && !sum) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba32f, size.x, size.y, false));
    sum = std::move(made);
  }
  return {};
}

Result<PrefilteredChain> Renderer::State::prefilteredChain() {
  if (settings.blur != BlurKind::gpu) return PrefilteredChain{&light->prefiltered(), 1};
  if (!gpu_prefilter) {
    const gl::Texture& cube = light->cube();
    MIRRORBALL_TRY(made, GpuPrefilter::make(context.api(), cube.width(), cube.format()));
    gpu_prefilter = std::move(made);
    gpu_prefilter->run(cube);
  }
  return PrefilteredChain{&gpu_prefilter->chain(), 0};
}

Result<void> Renderer::State::makeFlatLight() {
  frame.flat = nullptr;
  if (settings.look_up == LightLookUp::cube) return {};
  if (!flat_light || flattened_chain != frame.prefiltered.texture) {
    MIRRORBALL_TRY(made, FlatLight::make(*light, *frame.prefiltered.texture));
    flat_light = std::move(made);
    flattened_chain = frame.prefiltered.texture;
  }
  frame.flat = &*flat_light;
  return {};
}

/// Photographs the mirror ball from the camera's direction, so that the lecture's look-up is right for every camera.
Result<void> Renderer::State::makeSphereMap() {
  const glm::mat3 environment_from_view =
      frame.environment_from_world * glm::transpose(glm::mat3(frame.camera.view_from_world));
  const int size = std::min(environment->naturalSize(Projection::sphere), 2048);
  Image image = sphereMapTexture(*environment, environment_from_view, size);
  for (float& light_sample : image.samples()) light_sample /= light->unit();
  const gl::Format format = light->cube().format();
  MIRRORBALL_TRY(made, gl::Texture::fromImages(format, ImageSet(std::move(image))));
  made.setSampling({.filter = gl::Sampling::Filter::linear});
  sphere_map = std::move(made);
  sphere_map->bind(TextureUnit::sphere_map);
  return {};
}

/// Whether light passes so through some body.
bool Renderer::State::someRefract(RefractionKind kind) const {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (isBody(scene.materials[i]) && refractionOf(scene, static_cast<int>(i), settings.refraction) == kind)
      return true;
  return false;
}

/// The bodies for a frame that traces them, and those that its camera is in.
Result<void> Renderer::State::makeBodies() {
  frame.bodies = nullptr;
  frame.eye_media = {};
  if (!someRefract(RefractionKind::traced)) return {};
  if (!body_tree) {
    MIRRORBALL_TRY(tree, bodyTree(scene));
    if (!tree) return {};
    MIRRORBALL_TRY(made, withName("the triangles of glass", gl::Texture::fromWords(tree->words)));
    body_tree = std::move(tree);
    bodies = std::move(made);
  }
  frame.bodies = &*bodies;
  // The rays of an orthographic camera begin far away.
  if (!frame.camera.orthographic) frame.eye_media = surroundingMedia(scene, frame.camera.position, *body_tree);
  return {};
}

Result<void> Renderer::State::drawBackFaces(const Camera& camera) {
  if (!back_faces) {
    MIRRORBALL_TRY(made, BackFaces::make(context.api()));
    back_faces = std::move(made);
  }
  return back_faces->draw(scene, buffers, camera, settings.size);
}

Result<void> Renderer::State::drawReliefHits(const Camera& camera) {
  if (!relief_hits) {
    MIRRORBALL_TRY(made, ReliefHits::make(context.api()));
    relief_hits = std::move(made);
  }
  return relief_hits->draw(scene, buffers, camera, settings.size);
}

Result<void> Renderer::State::drawSample(const Camera& camera) {
  FrameUniforms of_sample = frame;
  of_sample.camera = camera;
  of_sample.sample = samples_drawn;
  if (someRefract(RefractionKind::image_space)) {
    MIRRORBALL_TRY_VOID(drawBackFaces(camera));
    of_sample.back_faces = &*back_faces;
  }
  if (settings.relief == ReliefKind::exact && !scene.height_textures.empty()) {
    MIRRORBALL_TRY_VOID(drawReliefHits(camera));
    of_sample.relief_hits = &relief_hits->picture();
  }
  MIRRORBALL_TRY_VOID(surfaces->begin(scene, buffers, *light, of_sample, settings));
  proxy.bind();
  sample->bind();
  const bool has_color = settings.background == BackgroundKind::radiance;
  const glm::vec3 color = has_color ? settings.background_color : glm::vec3(0.0f);
  glClearColor(color.x, color.y, color.z, has_color ? 1.0f : 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_BLEND);
  // The background covers what is farthest, so it is drawn last of the opaque, and only where nothing else is.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  drawOpaque(camera);
  if (settings.background == BackgroundKind::environment || settings.background == BackgroundKind::blur)
    background.draw(*light, of_sample, camera, settings);
  drawBlended(camera);
  return {};
}

void Renderer::State::drawInstance(int instance) {
  const Material& material = materialOf(scene, std::size_t(instance));
  const bool shows_inside = frame.eye_media.count > 0 && isBody(material);
  if (material.double_sided || shows_inside)
    glDisable(GL_CULL_FACE);
  else
    glEnable(GL_CULL_FACE);
  surfaces->draw(scene, instance, buffers, settings);
}

/// The instances of opaque surfaces, the nearest first, since what is near hides what is behind it, which then need not
/// be lit; or of those that shine through, the farthest first, since they are drawn over each other.
///
/// The distance from the eye is the same whichever way it looks: neighbouring faces of a cube show the same order.
std::vector<int> Renderer::State::byDistance(const Camera& camera, bool is_blended) const {
  std::vector<std::pair<float, int>> order;
  for (int index = 0; index < static_cast<int>(scene.instances.size()); ++index) {
    if ((materialOf(scene, std::size_t(index)).alpha_mode == AlphaMode::blend) != is_blended) continue;
    const Instance& instance = scene.instances[std::size_t(index)];
    const glm::vec4 center(centers[std::size_t(instance.mesh)], 1.0f);
    const glm::vec3 from_eye = glm::vec3(instance.world_from_object * center) - camera.position;
    const float distance = camera.orthographic ? glm::dot(from_eye, camera.forward) : glm::length(from_eye);
    order.emplace_back(is_blended ? -distance : distance, index);
  }
  std::ranges::stable_sort(order, {}, &std::pair<float, int>::first);
  std::vector<int> instances;
  for (const auto& [distance, index] : order) instances.push_back(index);
  return instances;
}

void Renderer::State::drawOpaque(const Camera& camera) {
  for (const int instance : byDistance(camera, false)) drawInstance(instance);
}

void Renderer::State::drawBlended(const Camera& camera) {
  const std::vector<int> blended = byDistance(camera, true);
  if (blended.empty()) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  for (const int instance : blended) drawInstance(instance);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Renderer::State::addSample() {
  sum->bind();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  if (samples_drawn == 0) {
    glDisable(GL_BLEND);
  } else {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  }
  sample->color().bind(TextureUnit::picture);
  accumulate.set("picture", TextureUnit::picture);
  setDisplay(accumulate, settings);
  accumulate.set("share", 1.0f / static_cast<float>(settings.samples));
  screen.draw(3);
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
