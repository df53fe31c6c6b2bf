#include "mirrorball/render/surface/surface_drawing.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/sharing_contexts.h"
#include "mirrorball/render/surface/height_map_uniform.h"
#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/render/surface/texture_units.h"
#include "mirrorball/render/surface/wavelength_sets.h"

namespace mirrorball {
namespace {

/// Tells the program how large the maps are that it filters itself.
void setExtents(gl::Program& program, const Scene& scene, const Material& material,
                const std::vector<MapSource>& sources) {
  for (std::size_t row = 0; row < sources.size(); ++row) {
    if (sources[row].layer < 0) continue;
    const MaterialMap& map = materialMaps()[row];
    const SharedPicture& image = scene.textures[std::size_t((material.*map.slot).texture)].image;
    const int last_level = levelCount(std::max(image.width(), image.height())) - 1;
    program.set(std::string(map.name) + "_extent", glm::vec3(image.width(), image.height(), last_level));
  }
}

/// As shaders/surface/lamps_listed.glsl reads them.
std::vector<glm::vec4> lampRows(const Scene& scene, const FrameSettings& settings) {
  std::vector<glm::vec4> rows;
  const auto add = [&](const formula::Lamp& lamp, float factor) {
    rows.emplace_back(lamp.position, static_cast<float>(lamp.kind));
    rows.emplace_back(lamp.direction, lamp.range);
    rows.emplace_back(lamp.color * factor, 0.0f);
    rows.emplace_back(lamp.cosine_inner, lamp.cosine_outer, 0.0f, 0.0f);
  };
  for (const PointLight& light : settings.lights) add(lampOf(light, scene.origin), 1.0f);
  for (const ModelLight& light : scene.lights) add(light, settings.light_intensity);
  return rows;
}

/// What a thread's compiler and context may take; Mesa 22.3 crashes where an allocation fails while it compiles.
constexpr std::uint64_t kOfCompiler = std::uint64_t{512} << 20;

/// A program that takes no longer is taken to be in the driver's cache.
constexpr std::chrono::milliseconds kCached(60);
/// After so many of them one after the other the rest is taken to be there too.
constexpr int kMostCached = 2;

/// How many threads may compile at a time.
int compilingThreads(std::size_t programs) {
  const std::uint64_t fitting = std::min(addressSpaceLeft(), memoryLimit()) / kOfCompiler;
  const auto most = static_cast<std::uint64_t>(std::min(std::size_t(threadLimit()), programs));
  return static_cast<int>(std::clamp<std::uint64_t>(fitting, 1, most));
}

/// The index of an instance's material.
int materialOf(const Scene& scene, int instance) {
  return scene.meshes[std::size_t(scene.instances[std::size_t(instance)].mesh)]->material;
}

/// Chooses what reads a probe's light in place of the environment's: by cube samplers, however that is read. What a
/// probe shows of other objects does not hide the environment once more.
void readProbe(SurfaceVariant& variant, const SurfaceLight& probe) {
  variant.choose(Part::proxy, probe.nearness ? ProxyPart::captured : ProxyPart::none);
  variant.choose(Part::arriving_light, ArrivingLightPart::distant);
  if (variant.has(Part::sky, SkyPart::occluded)) variant.choose(Part::sky, SkyPart::open);
}

/// Where there is no texture unit for the suns' shadows, there are no shadows.
void leaveRoom(SurfaceVariant& variant) {
  if (variant.sun_count > 0 && !TextureUnits::suffice(variant)) variant.choose(Part::suns, SunsPart::open);
}

/// Sets what is the same in all of a program's draws and in no block.
void setPrograms(SurfacePrograms::Programs& programs, const Scene& scene, const FrameUniforms& frame,
                 const FrameSettings& settings) {
  const std::vector<glm::vec4> lamps = lampRows(scene, settings);
  const SunUniforms& suns = frame.light.suns;
  const std::vector<glm::vec4> sun_rows = suns.rows();
  const formula::Media& eye_media = frame.scene.eye_media;
  for (auto& [variant, entry] : programs) {
    if (!entry.made) continue;
    gl::Program& program = entry.made->program;
    if (variant.lamp_count > 0 && std::size_t(variant.lamp_count) * 4 == lamps.size())
      program.set("lamp_rows", std::span<const glm::vec4>(lamps));
    if (variant.sun_count > 0 && std::size_t(variant.sun_count) == suns.suns.size()) {
      program.set("sun_rows", std::span<const glm::vec4>(sun_rows));
      if (variant.has(Part::suns, SunsPart::shadowed)) program.set("sun_shadow_rows", suns.shadow_rows);
    }
    if (variant.has(Part::transmission, TransmissionPart::traced)) {
      program.set("eye_media.latest", std::span(&eye_media.latest, 1));
      program.set("eye_media.earliest", std::span(&eye_media.earliest, 1));
    }
  }
}

}  // namespace

void beginSurfaceState(const SampleUniforms& sample, bool is_blended) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  if (sample.limitsPixels()) PixelMask::limit();
  gl::setBlending(is_blended);
}

void endSurfaceState() {
  PixelMask::end();
  gl::setBlending(false);
}

SurfaceVariant SurfaceDrawing::variantOf(const Scene& scene, int instance, const SceneBuffers& buffers,
                                         const FrameSettings& settings) const {
  const int material = materialOf(scene, instance);
  const Material& from_outside = scene.materials[std::size_t(material)];
  FrameSettings decided = settings;
  decided.refraction = refractionOf(scene, material, settings.refraction);
  if (scene.instances[std::size_t(instance)].occlusion.empty()) decided.occlusion = OcclusionKind::none;
  // What is seen through comes from the probe, which a surface with rays does not read.
  const bool reads_probes_behind = settings.behind == BehindKind::probes || uniforms_.sample.has_empty_screen;
  const bool sees_probe_behind = reads_probes_behind && from_outside.transmission > 0.0f &&
                                 !light_of_instance_.empty() && light_of_instance_[std::size_t(instance)] >= 0;
  decided.self_reflection = settings.self_reflection && uniforms_.scene.triangles != nullptr && !sees_probe_behind;
  const auto variant = [&](const Material& seen) {
    SurfaceVariant made = surfaceVariant(
        seen, buffers.mapsOf(material), decided,
        {.lamps = settings.lights.size() + scene.lights.size(), .suns = uniforms_.light.suns.suns.size()},
        coordinates_);
    if (seen.unlit) return made;
    const int light = lightRead(made, instance);
    if (light > 0) readProbe(made, lights_[std::size_t(light)]);
    const bool reads_lobes = !made.has(Part::look_up, LookUpPart::sphere_map) &&
                             !made.has(Part::look_up, LookUpPart::stretched) && made.has(Part::proxy, ProxyPart::none);
    leaveRoom(made);
    made.constants.has_wide_lobes = reads_lobes && hasWideLobes(seen, made.constants, lights_[std::size_t(light)].blur);
    return made;
  };
  if (!eyeIsInside() || !isBody(from_outside)) return variant(from_outside);
  Material seen = from_outside;
  static_cast<formula::Material&>(seen) = formula::openMaterial(seen);  // without its layers
  SurfaceVariant from_inside = variant(seen);
  from_inside.choose(Part::material, MaterialPart::from_inside);
  from_inside.constants = seenFromInside(from_inside.constants);
  return from_inside;
}

SurfaceDrawing::NeededVariants SurfaceDrawing::findVariants(const Scene& scene, const SceneBuffers& buffers,
                                                            const FrameSettings& settings) const {
  NeededVariants needed;
  std::map<SurfaceVariant, std::size_t> known;
  for (int instance = 0; instance < static_cast<int>(scene.instances.size()); ++instance) {
    const auto [found, is_new] = known.try_emplace(variantOf(scene, instance, buffers, settings), known.size());
    needed.of_instances.push_back(found->second);
    if (is_new) needed.first_instances.push_back(instance);
  }
  needed.variants.resize(known.size());
  for (const auto& [variant, index] : known) needed.variants[index] = variant;
  shareVariants(needed.variants);
  return needed;
}

bool SurfaceDrawing::DrawList::isFor(const DrawList& frame) const {
  return version == frame.version && coordinates == frame.coordinates && eye_is_inside == frame.eye_is_inside &&
         has_scene_triangles == frame.has_scene_triangles && light_of_instance == frame.light_of_instance &&
         sun_count == frame.sun_count && has_empty_screen == frame.has_empty_screen && captured == frame.captured &&
         last_levels == frame.last_levels && settings == frame.settings;
}

SurfaceDrawing::Draw SurfaceDrawing::drawOf(const Scene& scene, int instance,
                                            SurfacePrograms::Programs::reference entry) const {
  const SurfaceVariant& variant = entry.first;
  return Draw{.mesh = scene.instances[std::size_t(instance)].mesh,
              .material = materialOf(scene, instance),
              .variant = &variant,
              .program = &*entry.second.made,
              .light = lightRead(variant, instance)};
}

/// Where triangles and draws are few beside pixels, to draw them twice costs less than the light of what they hide.
/// Light that is searched for along rays costs more in any case.
void SurfaceDrawing::chooseDepthsFirst(const Scene& scene, glm::ivec2 size_px, std::vector<Draw>& draws) {
  std::size_t triangles = 0;
  for (const Draw& draw : draws) triangles += scene.meshes[std::size_t(draw.mesh)]->indices.size() / 3;
  constexpr std::size_t kTrianglesOfDraw = 32;  // that take as long as what a draw needs by itself
  const std::size_t pixels = static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
  const bool are_few = triangles + kTrianglesOfDraw * draws.size() < pixels;
  for (Draw& draw : draws) {
    const SurfaceVariant& variant = *draw.variant;
    const bool is_traced = variant.has(Part::sky, SkyPart::occluded_traced) ||
                           variant.has(Part::transmission, TransmissionPart::image_space) ||
                           variant.has(Part::transmission, TransmissionPart::traced);
    draw.depths_come_first = (are_few || is_traced) && variant.has(Part::point, PointPart::raster) &&
                             variant.has(Part::alpha, AlphaPart::opaque);
  }
}

/// Finds how the instances are drawn, or that it is known.
Result<void> SurfaceDrawing::findDraws(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene,
                                       const SceneBuffers& buffers, std::uint64_t version,
                                       const FrameSettings& settings) {
  constexpr std::size_t kMostLists = 4;  // a picture, its mirror image and what probes see of it
  FrameSettings deciding = settings;     // of which the camera and the display decide nothing
  deciding.camera = {};
  deciding.display = {};
  DrawList list{.settings = std::move(deciding),
                .version = version,
                .coordinates = coordinates_,
                .eye_is_inside = eyeIsInside(),
                .has_scene_triangles = uniforms_.scene.triangles != nullptr,
                .light_of_instance = light_of_instance_,
                .sun_count = uniforms_.light.suns.suns.size(),
                .has_empty_screen = uniforms_.sample.has_empty_screen};
  for (const SurfaceLight& light : lights_) {
    list.captured.push_back(light.nearness != nullptr);
    list.last_levels.push_back(light.blur.last_level);
  }
  std::erase_if(draw_lists_, [&](const DrawList& other) { return other.version != version; });
  const auto known =
      std::find_if(draw_lists_.begin(), draw_lists_.end(), [&](const DrawList& other) { return other.isFor(list); });
  drawn_ = static_cast<std::size_t>(known - draw_lists_.begin());
  if (known != draw_lists_.end()) return {};
  const NeededVariants needed = findVariants(scene, buffers, settings);
  MIRRORBALL_TRY_VOID(compileTogether(programs, target, scene, buffers, needed));
  std::vector<SurfacePrograms::Programs::pointer> entries;
  for (const SurfaceVariant& variant : needed.variants) {
    MIRRORBALL_TRY(entry, programs.submit(variant));
    entries.push_back(entry);
  }
  for (const SurfacePrograms::Programs::pointer entry : entries)
    MIRRORBALL_TRY_VOID(programs.finish(*entry, *uniforms_.light.proxy));
  for (const std::size_t variant : needed.of_instances)
    list.draws.push_back(drawOf(scene, static_cast<int>(list.draws.size()), *entries[variant]));
  chooseDepthsFirst(scene, settings.size, list.draws);
  if (draw_lists_.size() == kMostLists) draw_lists_.erase(draw_lists_.begin());
  draw_lists_.push_back(std::move(list));
  drawn_ = draw_lists_.size() - 1;
  return {};
}

std::map<SurfaceVariant, int> SurfaceDrawing::missing(const SurfacePrograms& programs, const NeededVariants& needed) {
  std::map<SurfaceVariant, int> first_instances;
  for (std::size_t i = 0; i < needed.variants.size(); ++i)
    if (!programs.has(needed.variants[i])) first_instances.try_emplace(needed.variants[i], needed.first_instances[i]);
  return first_instances;
}

/// Makes the programs that there are not in several threads, for a driver that compiles when it draws. Each thread
/// makes a draw without pixels with its programs, in the state that the frame's draws will have, which then find them.
Result<void> SurfaceDrawing::compileTogether(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene,
                                             const SceneBuffers& buffers, const NeededVariants& needed) const {
  std::map<SurfaceVariant, int> first_instances = missing(programs, needed);
  std::erase_if(first_instances,
                [](const auto& each) { return each.first.has(Part::point, PointPart::exact); });  // draws prisms
  if (first_instances.size() < 2 || threadLimit() == 1 || !target.context.compilesWhenDrawing()) return {};
  Waiting waiting;
  for (const auto& [variant, instance] : first_instances) {
    MIRRORBALL_TRY_VOID(programs.prepare(variant));
    MIRRORBALL_TRY(shaders, surfaceShaders(programs.api(), variant));
    waiting.programs.push_back({variant, instance, std::move(shaders)});
  }
  // Those with the longest texts first, which take longest: so the threads end nearly together.
  std::sort(waiting.programs.begin(), waiting.programs.end(),
            [](const WaitingProgram& one, const WaitingProgram& other) {
              return one.shaders.fragment.text.size() > other.shaders.fragment.text.size();
            });
  return gl::inSharingContexts(target.context, compilingThreads(waiting.programs.size()),
                               [&] { return compileWaiting(waiting, programs, target.picture, scene, buffers); });
}

/// Compiles what is waiting, in one of several threads.
///
/// target   that the current context has or shares
Result<void> SurfaceDrawing::compileWaiting(Waiting& waiting, SurfacePrograms& programs, const gl::Framebuffer& target,
                                            const Scene& scene, const SceneBuffers& buffers) const {
  MIRRORBALL_TRY(picture, gl::Framebuffer::make(target.color().format(), 1, 1, target.depths()));
  const gl::VertexArray no_vertices;
  picture.bind();
  Result<void> result;
  for (int cached = 0; cached < kMostCached;) {
    std::unique_lock lock(waiting.mutex);
    if (waiting.taken == waiting.programs.size()) break;
    WaitingProgram& program = waiting.programs[waiting.taken++];
    lock.unlock();
    const auto start = std::chrono::steady_clock::now();
    gl::PendingProgram submitted = SurfacePrograms::compile(std::move(program.shaders));
    lock.lock();
    SurfacePrograms::Programs::reference entry = programs.add(program.variant, std::move(submitted));
    result = programs.finish(entry, *uniforms_.light.proxy);
    if (!result) break;
    const Draw draw = drawOf(scene, program.instance, entry);
    programs.bindBrdfTable();
    bindLightTextures(lights_[std::size_t(draw.light)]);
    bindTextures(draw, scene, buffers);
    draw.program->program.use();
    lock.unlock();
    beginSurfaceState(uniforms_.sample, program.variant.has(Part::alpha, AlphaPart::blend));
    no_vertices.draw(3);
    // What the driver has in its cache, it reads as fast when the frame is drawn.
    cached = std::chrono::steady_clock::now() - start > kCached ? 0 : cached + 1;
  }
  endSurfaceState();
  glFinish();
  return result;
}

void SurfaceDrawing::setFrame(const SurfacePrograms& programs, const FrameUniforms& frame,
                              const FrameSettings& settings) {
  if (!frame_) frame_.emplace(programs.layout(SurfacePrograms::frame_point));
  gl::UniformBlock& block = *frame_;
  const glm::mat4 clip_from_world = frame.sample.camera.clip_from_view * frame.sample.camera.view_from_world;
  block.set("clip_from_world", clip_from_world);
  block.set("world_from_clip", glm::inverse(clip_from_world));
  block.set("look_up_matrix", frame.scene.coordinates.look_up);
  block.set("picture_matrix", frame.scene.coordinates.picture);
  if (frame.screen.back_faces) {
    block.set("back_faces_from_world", frame.screen.back_faces->texelsFromWorld());
    block.set("eye_from_back_faces", frame.screen.back_faces->eyeFromTexels());
  }
  block.set("eye_from_world", glm::mat3(frame.sample.camera.view_from_world));
  block.set("camera_position", frame.sample.camera.position);
  block.set("orthographic", frame.sample.camera.orthographic ? 1.0f : 0.0f);
  block.set("camera_forward", frame.sample.camera.forward);
  block.set("screen_unit", frame.screen.unit);
  // One that holds nothing is a point where no ray comes: shaders are not promised infinity.
  constexpr float kNowhere = 1e30f;
  block.set("shown_low", frame.screen.shown.isEmpty() ? glm::vec3(kNowhere) : frame.screen.shown.low);
  block.set("shown_high", frame.screen.shown.isEmpty() ? glm::vec3(kNowhere) : frame.screen.shown.high);
  if (cells_.size() != static_cast<std::size_t>(settings.samples)) cells_ = pixelCells(settings.samples);
  const PixelCell& cell = cells_[static_cast<std::size_t>(frame.sample.number)];
  block.set("pixel_cell", glm::vec4(cell.middle - placeOfSample(frame.sample.number, settings.samples), cell.size));
  block.set("samples_per_pixel", static_cast<float>(settings.samples));
  block.set("sample_phase", (static_cast<float>(frame.sample.number) + 0.5f) / static_cast<float>(settings.samples));
  block.set("inner_bounces", settings.inner_bounces);
  block.set("only_wavelength", settings.wavelength_nm / 1000.0f);
  block.set("wavelength_count", lightKindsOf(settings));
  if (isSpectral(settings))
    block.set("wavelengths", std::span<const glm::vec4>(wavelengthSets(settings, frame.sample.number)));
}

void SurfaceDrawing::setLights(const EnvironmentLight& light, const FrameUniforms& frame,
                               const FrameSettings& settings) {
  const FlatLight* flat = frame.light.flat;
  const bool reads_nearest = !flat && settings.texture_filter == TextureFilter::nearest;
  lights_ = {{.environment = flat ? &flat->environment : &light.cube(),
              .environment_sampler = reads_nearest ? &light.nearestSampler() : nullptr,
              .prefiltered = flat ? &flat->prefiltered : frame.light.prefiltered.texture,
              .irradiance = flat ? &flat->irradiance : &light.irradiance(),
              .blur = blurOf(settings, light.cube(), frame.light.prefiltered),
              .intensity = settings.env_intensity * light.unit(),
              .environment_from_world = frame.light.environment_from_world}};
  light_of_instance_.clear();
  if (!frame.probes) return;
  lights_.insert(lights_.end(), frame.probes->lights.begin(), frame.probes->lights.end());
  light_of_instance_ = frame.probes->light_of_instance;
}

int SurfaceDrawing::lightRead(const SurfaceVariant& variant, int instance) const {
  // Rays meet the other objects themselves.
  if (light_of_instance_.empty() || variant.has(Part::sky, SkyPart::occluded_traced)) return 0;
  return light_of_instance_[std::size_t(instance)] + 1;
}

void SurfaceDrawing::bindLight(int light) {
  if (bound_light_ == light) return;
  bound_light_ = light;
  while (light_blocks_.size() < lights_.size()) light_blocks_.emplace_back(light_layout_);
  const SurfaceLight& read = lights_[std::size_t(light)];
  gl::UniformBlock& block = light_blocks_[std::size_t(light)];
  block.set("environment_from_world", read.environment_from_world);
  block.set("captured_from", read.captured_from);
  block.set("nearness_unit", read.nearness_unit);
  block.set("environment_intensity", read.intensity);
  block.set("first_level", read.blur.first_level);
  block.set("last_level", read.blur.last_level);
  block.set("texels_per_radian", read.blur.texels_per_radian);
  block.bind(SurfacePrograms::light_point);
  bindLightTextures(read);
}

void SurfaceDrawing::bindLightTextures(const SurfaceLight& light) const {
  light.environment->bind(static_cast<int>(FrameTexture::environment), light.environment_sampler);
  light.prefiltered->bind(static_cast<int>(FrameTexture::prefiltered));
  light.irradiance->bind(static_cast<int>(FrameTexture::irradiance));
}

/// What decides how instances are drawn.
void SurfaceDrawing::noteFrame(const Scene& scene, const EnvironmentLight& light, const FrameUniforms& frame,
                               const FrameSettings& settings) {
  uniforms_ = frame;
  coordinates_ = coordinateChoice(scene, settings);
  setLights(light, frame, settings);
}

void SurfaceDrawing::setBlocks(SurfacePrograms& programs, const Scene& scene, SceneBuffers& buffers,
                               const FrameUniforms& frame, const FrameSettings& settings) {
  if (!screen_) screen_.emplace();
  buffers.blocks().make(scene, programs.layout(SurfacePrograms::instance_point),
                        programs.layout(SurfacePrograms::material_point));
  light_layout_ = programs.layout(SurfacePrograms::light_point);
  setPrograms(programs.programs(), scene, frame, settings);
  setFrame(programs, frame, settings);
  bound_light_ = -1;
  programs.bindBrdfTable();
}

Result<void> SurfaceDrawing::begin(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene,
                                   SceneBuffers& buffers, std::uint64_t version, const EnvironmentLight& light,
                                   const FrameUniforms& frame, const FrameSettings& settings) {
  if (scene.instances.empty()) return {};
  noteFrame(scene, light, frame, settings);
  MIRRORBALL_TRY_VOID(findDraws(programs, target, scene, buffers, version, settings));
  setBlocks(programs, scene, buffers, frame, settings);
  return {};
}

std::vector<SurfaceVariant> SurfaceDrawing::variants(const Scene& scene, const SceneBuffers& buffers,
                                                     const EnvironmentLight& light, const FrameUniforms& frame,
                                                     const FrameSettings& settings) {
  noteFrame(scene, light, frame, settings);
  const NeededVariants needed = findVariants(scene, buffers, settings);
  std::vector<SurfaceVariant> variants;
  for (const std::size_t variant : needed.of_instances) variants.push_back(needed.variants[variant]);
  return variants;
}

Result<std::optional<SurfaceDrawing::MadeProgram>> SurfaceDrawing::makeProgram(
    SurfacePrograms& programs, const Scene& scene, SceneBuffers& buffers, const EnvironmentLight& light,
    const FrameUniforms& frame, const FrameSettings& settings) {
  noteFrame(scene, light, frame, settings);
  const std::map<SurfaceVariant, int> waiting = missing(programs, findVariants(scene, buffers, settings));
  if (waiting.empty()) return std::optional<MadeProgram>();
  // A driver that compiles beside us takes them all at once; one that compiles while we wait is given one.
  constexpr std::chrono::milliseconds kAtOnce(5);
  const auto start = std::chrono::steady_clock::now();
  std::map<SurfacePrograms::Programs::pointer, int> submitted;
  for (const auto& [variant, instance] : waiting) {
    MIRRORBALL_TRY(entry, programs.submit(variant));
    submitted.emplace(entry, instance);
    if (std::chrono::steady_clock::now() - start > kAtOnce) break;
  }
  auto next = std::find_if(submitted.begin(), submitted.end(),
                           [](const auto& each) { return each.first->second.submitted->isReady(); });
  if (next == submitted.end()) next = submitted.begin();
  const auto [entry, instance] = *next;
  MIRRORBALL_TRY_VOID(programs.finish(*entry, *frame.light.proxy));
  made_ = drawOf(scene, instance, *entry);
  made_for_ = instance;
  setBlocks(programs, scene, buffers, frame, settings);
  return std::optional(MadeProgram{instance, static_cast<int>(waiting.size()) - 1});
}

void SurfaceDrawing::tryOut(const Scene& scene, SceneBuffers& buffers, const FrameSettings& settings) {
  draw(*made_, scene, made_for_, buffers, settings);
}

/// Those of a frame that a program reads beside what all do.
void SurfaceDrawing::bindFrameTextures(const TextureUnits& units, const SurfaceLight& light) const {
  const auto bind = [&](FrameTexture texture, const gl::Texture* bound) {
    if (bound && units.reads(texture)) bound->bind(units.of(texture));
  };
  const ScreenUniforms& screen = uniforms_.screen;
  bind(FrameTexture::sphere_map, uniforms_.light.sphere_map);
  bind(FrameTexture::nearness, light.nearness);
  bind(FrameTexture::bodies, uniforms_.scene.bodies);
  bind(FrameTexture::scene_triangles, uniforms_.scene.triangles);
  bind(FrameTexture::back_faces, screen.back_faces ? &screen.back_faces->picture() : nullptr);
  bind(FrameTexture::opaque_picture, screen.opaque_picture);
  bind(FrameTexture::relief_hits, screen.relief_hits);
  bind(FrameTexture::sun_shadows, uniforms_.light.suns.shadows);
}

/// All that a draw reads, but for the light's, which many draws share.
void SurfaceDrawing::bindTextures(const Draw& draw, const Scene& scene, const SceneBuffers& buffers) const {
  const SurfaceVariant& variant = *draw.variant;
  const TextureUnits& units = draw.program->units;
  buffers.bindMaps(scene, draw.material, units);
  bindFrameTextures(units, lights_[std::size_t(draw.light)]);
  if (!variant.has(Part::proxy, ProxyPart::none) && !variant.has(Part::proxy, ProxyPart::captured))
    uniforms_.light.proxy->bind(units.of(FrameTexture::proxy));
}

void SurfaceDrawing::draw(const Scene& scene, int instance, SceneBuffers& buffers, const FrameSettings& settings) {
  draw(draws()[std::size_t(instance)], scene, instance, buffers, settings);
}

void SurfaceDrawing::draw(const Draw& draw, const Scene& scene, int instance, SceneBuffers& buffers,
                          const FrameSettings& settings) {
  const int material = draw.material;
  const SurfaceVariant& variant = *draw.variant;
  gl::Program& program = draw.program->program;
  const TextureUnits& units = draw.program->units;
  const bool shows_heights = variant.has(Part::normal, NormalPart::heights);
  bindTextures(draw, scene, buffers);
  if (buffers.hasLayers(material))
    setExtents(program, scene, scene.materials[std::size_t(material)], buffers.mapsOf(material));
  if (const auto* heights = shows_heights ? buffers.heightsOf(scene, material) : nullptr) {
    const int texture = scene.materials[std::size_t(material)].height_texture;
    program.set("height_map", heightMapUniform(scene.height_textures[std::size_t(texture)]));
    program.set("height_form", glm::vec2(heights->slope_unit, settings.relief_steps));
  }
  if (variant.has(Part::normal, NormalPart::slopes)) program.set("slope_unit", buffers.slopesOf(scene, material)->unit);
  if (variant.has(Part::sky, SkyPart::occluded_traced))
    program.set("unseen_by_itself", uniforms_.scene.unseen_by_itself[std::size_t(instance)]);
  frame_->bind(SurfacePrograms::frame_point);
  bindLight(draw.light);
  buffers.blocks().bind(instance, SurfacePrograms::instance_point, material, SurfacePrograms::material_point);
  program.use();
  if (variant.has(Part::transmission, TransmissionPart::image_space)) buffers.readIorAround(scene, instance);
  if (variant.has(Part::sky, SkyPart::occluded) || variant.has(Part::sky, SkyPart::occluded_traced))
    return buffers.drawMeshWithOcclusion(scene, instance);
  if (!variant.has(Part::point, PointPart::exact)) return buffers.drawMesh(draw.mesh);
  glDisable(GL_CULL_FACE);
  buffers.bindPrisms(draw.mesh, units.of(FrameTexture::prisms));
  screen_->draw(3);
}

}  // namespace mirrorball
