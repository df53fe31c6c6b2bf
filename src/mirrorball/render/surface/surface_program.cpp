#include "mirrorball/render/surface/surface_program.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <variant>

#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/bake/brdf/sheen_albedo.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/image/image_set.h"
#include "mirrorball/render/surface/height_map_uniform.h"
#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/render/surface/wavelength_sets.h"

namespace mirrorball {
namespace {

constexpr std::array<const char*, 4> kBlocks{"FrameBlock", "InstanceBlock", "MaterialBlock",
                                             "LightBlock"};  // by BlockPoint

/// Every parameter that the block has; what a choice only chooses a part by, it has not.
void setParameters(gl::UniformBlock& block, const Material& material) {
  for (const MaterialParameter& parameter : materialParameters()) {
    const std::string name = "material." + std::string(parameter.text.name);
    if (const auto* number = std::get_if<float Material::*>(&parameter.field)) block.set(name, material.**number);
    if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field)) block.set(name, material.**color);
  }
  block.set("material.sellmeier_b", material.sellmeier_b);
  block.set("material.sellmeier_c", material.sellmeier_c);
  block.set("material.fresnel", material.fresnel);
}

/// KHR_texture_transform: translation · rotation · scale, as the columns of a matrix and an offset.
void setMaps(gl::UniformBlock& block, const Material& material) {
  std::vector<glm::vec4> matrices;
  std::vector<glm::vec4> offsets;
  for (const MaterialMap& map : materialMaps()) {
    const TextureSlot& slot = material.*map.slot;
    const glm::mat2 matrix = uvMatrix(slot);
    matrices.emplace_back(matrix[0], matrix[1]);
    offsets.emplace_back(slot.offset, static_cast<float>(slot.uv_set), 0.0f);
  }
  block.set("map_matrix", std::span<const glm::vec4>(matrices));
  block.set("map_offset", std::span<const glm::vec4>(offsets));
}

/// Tells the program how large the maps are that it filters itself.
void setExtents(gl::Program& program, const Scene& scene, const Material& material,
                const std::vector<MapSource>& sources) {
  for (std::size_t row = 0; row < sources.size(); ++row) {
    if (sources[row].layer < 0) continue;
    const MaterialMap& map = materialMaps()[row];
    const Image8& image = scene.textures[std::size_t((material.*map.slot).texture)].image;
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
  for (const PointLight& light : settings.lights) add(lampOf(light), 1.0f);
  for (const ModelLight& light : scene.lights) add(light, settings.light_intensity);
  return rows;
}

/// The index of an instance's material.
int materialOf(const Scene& scene, int instance) {
  return scene.meshes[std::size_t(scene.instances[std::size_t(instance)].mesh)].material;
}

/// Chooses what reads a probe's light in place of the environment's: by cube samplers, however that is read. What a
/// probe shows of other objects does not hide the environment once more.
void readProbe(SurfaceVariant& variant, const SurfaceLight& probe) {
  variant.choose(Part::proxy, probe.nearness ? ProxyPart::captured : ProxyPart::none);
  variant.choose(Part::arriving_light, ArrivingLightPart::distant);
  if (variant.has(Part::sky, SkyPart::occluded)) variant.choose(Part::sky, SkyPart::open);
}

/// As shaders/surface/transmission_traced.glsl reads them.
std::array<glm::vec4, formula::kMaxMedia> mediaRows(const formula::Media& media) {
  std::array<glm::vec4, formula::kMaxMedia> rows{};
  for (std::size_t i = 0; i < std::size_t(media.count); ++i) rows[i] = {media.bodies[i], media.priorities[i], 1, 0};
  return rows;
}

/// The BRDF table in the form of Surface::environment_brdf, and a channel of zeros. What is missing to 1 lights a
/// surface with all the light around it, and from rounded shares it would come out as some 2e-4 of that where it is
/// nothing: of a sun more than of a room.
Result<Image> missingAndGrazing() {
  MIRRORBALL_TRY(table, brdfTable({.axes = BrdfAxes::warped}));
  Image shares(table.width(), table.height(), 3);
  for (int y = 0; y < table.height(); ++y)
    for (int x = 0; x < table.width(); ++x) {
      const DirectionalAlbedo albedo{.scale = table.texel(x, y)[0], .bias = table.texel(x, y)[1]};
      float* share = shares.texel(x, y);
      // A mirror, row 0, has no facets that light could go to and fro between.
      share[0] = y == 0 ? 0.0f : std::max(1.0f - albedo.total(), 0.0f);
      share[1] = albedo.grazing();
    }
  return shares;
}

/// The same with the sheen's albedo in its third channel, on the same axes.
Result<Image> withCloth(const Result<Image>& table) {
  if (!table) return table;
  Image shares = *table;
  const auto place = [&](int index) { return static_cast<float>(index) / static_cast<float>(shares.width() - 1); };
  for (int y = 0; y < shares.height(); ++y)
    for (int x = 0; x < shares.width(); ++x)
      shares.texel(x, y)[2] = sheenAlbedo(place(y), cosineOfWarpedColumn(place(x), place(y)));
  return shares;
}

void copyInto(Image& target, int left, const Image& source) {
  for (int y = 0; y < source.height(); ++y)
    for (int x = 0; x < source.width(); ++x)
      std::copy_n(source.texel(x, y), source.channels(), target.texel(left + x, y));
}

/// The BRDF table and, on its right, the rows of lobes: shaders are short of textures. OpenGL ES filters no more than
/// half floats, which keep each share to 5e-4 of itself.
Result<gl::Texture> brdfTexture(const Image& table) {
  MIRRORBALL_TRY(rows, lobeRowTable());
  Image both(table.width() + rows.width(), table.height(), 4);
  copyInto(both, 0, table);
  copyInto(both, table.width(), rows);
  MIRRORBALL_TRY(texture, gl::Texture::fromImages(gl::Format::rgba16f, ImageSet(std::move(both))));
  texture.setSampling({.filter = gl::Sampling::Filter::linear});
  return texture;
}

/// Where the scene's triangles are read: what transmits has its bodies or back faces where others have them.
int sceneTrianglesUnit(const SurfaceVariant& variant) {
  return variant.has(Part::transmission, TransmissionPart::none) ? TextureUnit::scene_triangles
                                                                 : TextureUnit::scene_triangles_of_glass;
}

/// The parts that include brdf_look_up.glsl.
bool readsBrdfTable(const SurfaceVariant& variant) {
  return variant.has(Part::material, MaterialPart::core) || variant.has(Part::sky, SkyPart::occluded_traced) ||
         variant.has(Part::look_up, LookUpPart::lobe_row) || variant.has(Part::look_up, LookUpPart::strata);
}

}  // namespace

// Both are made once, since they are the same for every renderer and all their inputs stand here.
Result<Image> surfaceBrdfTable() {
  static const Result<Image> table = missingAndGrazing();
  return table;
}

Result<Image> surfaceBrdfTableWithCloth() {
  static const Result<Image> table = withCloth(surfaceBrdfTable());
  return table;
}

Result<SurfacePrograms> SurfacePrograms::make(gl::Api api, const Image& brdf_table) {
  MIRRORBALL_TRY(texture, brdfTexture(brdf_table));
  return SurfacePrograms(api, std::move(texture));
}

Result<void> SurfacePrograms::addClothToBrdfTable() {
  if (brdf_table_has_cloth_) return {};
  MIRRORBALL_TRY(table, surfaceBrdfTableWithCloth());
  MIRRORBALL_TRY(texture, brdfTexture(table));
  brdf_table_ = std::move(texture);
  brdf_table_has_cloth_ = true;
  return {};
}

/// Says which unit and which binding point each sampler and block reads; they are the same in all programs.
void SurfacePrograms::connect(gl::Program& program, const SurfaceVariant& variant, ProxyUniforms& proxy) {
  if (!variant.has(Part::proxy, ProxyPart::captured))
    proxy.connect(program, static_cast<ProxyKind>(variant.answers[std::size_t(Part::proxy)]));
  if (readsBrdfTable(variant)) program.set("brdf_table", TextureUnit::brdf_table);
  const std::string form = variant.has(Part::arriving_light, ArrivingLightPart::distant) ? "" : "_faces";
  program.set("environment" + form, TextureUnit::environment);
  program.set("prefiltered" + form, TextureUnit::prefiltered);
  program.set("irradiance" + form, TextureUnit::irradiance);
  if (variant.has(Part::proxy, ProxyPart::captured)) program.set("captured_nearness", TextureUnit::nearness);
  if (variant.has(Part::transmission, TransmissionPart::traced)) program.set("bodies", TextureUnit::bodies);
  if (variant.has(Part::behind, BehindPart::screen)) program.set("opaque_picture", TextureUnit::opaque_picture);
  if (variant.has(Part::transmission, TransmissionPart::image_space))
    program.set("back_faces", TextureUnit::back_faces);
  if (variant.has(Part::normal, NormalPart::heights)) {
    program.set("heights", TextureUnit::heights);
    program.set("slopes", TextureUnit::slopes);
  }
  if (variant.has(Part::sky, SkyPart::occluded_traced)) program.set("scene_triangles", sceneTrianglesUnit(variant));
  if (variant.has(Part::sky, SkyPart::over_horizons)) program.set("horizons", TextureUnit::horizons);
  if (variant.has(Part::normal, NormalPart::slopes)) program.set("slope_map", TextureUnit::slopes);
  if (variant.has(Part::point, PointPart::exact)) {
    program.set("prisms", TextureUnit::prisms);
    program.set("relief_hits", TextureUnit::relief_hits);
  }
  const bool is_sphere_map = variant.has(Part::look_up, LookUpPart::sphere_map);
  if (is_sphere_map) program.set("sphere_map", TextureUnit::sphere_map);
  for (std::size_t row = 0; row < variant.maps.size(); ++row)
    if (const int unit = variant.maps[row].unit; unit >= 0)
      program.set(samplerName(variant.maps, row), TextureUnit::first_of_material + unit);
  for (unsigned point = 0; point < block_points; ++point) {
    const auto layout = program.connect(kBlocks[point], point);
    if (layout && !layouts_[point]) layouts_[point] = std::make_shared<gl::BlockLayout>(*layout);
  }
}

SurfaceVariant SurfacePrograms::variantOf(const Scene& scene, int instance, const SceneBuffers& buffers,
                                          const FrameSettings& settings) const {
  const int material = materialOf(scene, instance);
  const Material& from_outside = scene.materials[std::size_t(material)];
  FrameSettings decided = settings;
  decided.refraction = refractionOf(scene, material, settings.refraction);
  if (scene.instances[std::size_t(instance)].occlusion.empty()) decided.occlusion = OcclusionKind::none;
  // What is seen through comes from the probe, which a surface with rays does not read.
  const bool sees_probe_behind = settings.behind == BehindKind::probes && from_outside.transmission > 0.0f &&
                                 !light_of_instance_.empty() && light_of_instance_[std::size_t(instance)] >= 0;
  decided.self_reflection = settings.self_reflection && scene_triangles_ != nullptr && !sees_probe_behind;
  const auto variant = [&](const Material& seen) {
    SurfaceVariant made = surfaceVariant(seen, buffers.mapsOf(material), decided,
                                         settings.lights.size() + scene.lights.size(), coordinates_);
    if (const int light = lightRead(made, instance); light > 0 && !seen.unlit)
      readProbe(made, lights_[std::size_t(light)]);
    return made;
  };
  if (!eye_is_inside_ || !isBody(from_outside)) return variant(from_outside);
  Material seen = from_outside;
  static_cast<formula::Material&>(seen) = formula::openMaterial(seen);  // without its layers
  SurfaceVariant from_inside = variant(seen);
  from_inside.choose(Part::material, MaterialPart::from_inside);
  return from_inside;
}

Result<SurfacePrograms::Programs::iterator> SurfacePrograms::programFor(const SurfaceVariant& variant,
                                                                        ProxyUniforms& proxy) {
  auto found = programs_.find(variant);
  if (found == programs_.end()) {
    MIRRORBALL_TRY(shaders, surfaceShaders(api_, variant));
    MIRRORBALL_TRY(program, gl::Program::build(shaders.vertex, shaders.fragment, "surface.vert with surface.frag"));
    connect(program, variant, proxy);
    found = programs_.emplace(variant, std::move(program)).first;
  }
  return found;
}

bool SurfacePrograms::DrawList::isFor(const DrawList& frame) const {
  return coordinates == frame.coordinates && eye_is_inside == frame.eye_is_inside &&
         has_scene_triangles == frame.has_scene_triangles && light_of_instance == frame.light_of_instance &&
         captured == frame.captured && settings == frame.settings;
}

Result<SurfacePrograms::Draw> SurfacePrograms::drawOf(const Scene& scene, int instance, const SceneBuffers& buffers,
                                                      ProxyUniforms& proxy, const FrameSettings& settings) {
  MIRRORBALL_TRY(program, programFor(variantOf(scene, instance, buffers, settings), proxy));
  const SurfaceVariant& variant = program->first;
  if (variant.has(Part::sheen, SheenPart::cloth)) MIRRORBALL_TRY_VOID(addClothToBrdfTable());
  const bool is_traced = variant.has(Part::sky, SkyPart::occluded_traced) ||
                         variant.has(Part::transmission, TransmissionPart::image_space) ||
                         variant.has(Part::transmission, TransmissionPart::traced);
  return Draw{.mesh = scene.instances[std::size_t(instance)].mesh,
              .material = materialOf(scene, instance),
              .variant = &variant,
              .program = &program->second,
              .light = lightRead(variant, instance),
              .is_costly = is_traced && variant.has(Part::point, PointPart::raster) &&
                           variant.has(Part::alpha, AlphaPart::opaque)};
}

/// Finds how the instances are drawn, or that it is known.
Result<void> SurfacePrograms::findDraws(const Scene& scene, const SceneBuffers& buffers, ProxyUniforms& proxy,
                                        const FrameSettings& settings) {
  constexpr std::size_t kMostLists = 4;  // a picture, its mirror image and what probes see of it
  DrawList list{.settings = settings,
                .coordinates = coordinates_,
                .eye_is_inside = eye_is_inside_,
                .has_scene_triangles = scene_triangles_ != nullptr,
                .light_of_instance = light_of_instance_};
  for (const SurfaceLight& light : lights_) list.captured.push_back(light.nearness != nullptr);
  const auto known =
      std::find_if(draw_lists_.begin(), draw_lists_.end(), [&](const DrawList& other) { return other.isFor(list); });
  drawn_ = static_cast<std::size_t>(known - draw_lists_.begin());
  if (known != draw_lists_.end()) return {};
  for (int instance = 0; instance < static_cast<int>(scene.instances.size()); ++instance) {
    MIRRORBALL_TRY(draw, drawOf(scene, instance, buffers, proxy, settings));
    list.draws.push_back(draw);
  }
  if (draw_lists_.size() == kMostLists) draw_lists_.erase(draw_lists_.begin());
  draw_lists_.push_back(std::move(list));
  drawn_ = draw_lists_.size() - 1;
  return {};
}

/// Sets what is the same in all of a program's draws and in no block.
void SurfacePrograms::setPrograms(const Scene& scene, const FrameUniforms& frame, const FrameSettings& settings) {
  const std::vector<glm::vec4> lamps = lampRows(scene, settings);
  const auto eye_media = mediaRows(frame.eye_media);
  for (auto& [variant, program] : programs_) {
    if (variant.lamp_count > 0 && std::size_t(variant.lamp_count) * 4 == lamps.size())
      program.set("lamp_rows", std::span<const glm::vec4>(lamps));
    if (variant.has(Part::transmission, TransmissionPart::traced))
      program.set("eye_media", std::span<const glm::vec4>(eye_media));
  }
}

void SurfacePrograms::setFrame(const FrameUniforms& frame, const FrameSettings& settings) {
  if (!frame_) frame_.emplace(layouts_[frame_point]);
  gl::UniformBlock& block = *frame_;
  const glm::mat4 clip_from_world = frame.camera.clip_from_view * frame.camera.view_from_world;
  block.set("clip_from_world", clip_from_world);
  block.set("world_from_clip", glm::inverse(clip_from_world));
  block.set("look_up_matrix", frame.coordinates.look_up);
  block.set("picture_matrix", frame.coordinates.picture);
  if (frame.back_faces) {
    block.set("back_faces_from_world", frame.back_faces->texelsFromWorld());
    block.set("eye_from_back_faces", frame.back_faces->eyeFromTexels());
  }
  block.set("eye_from_world", glm::mat3(frame.camera.view_from_world));
  block.set("camera_position", frame.camera.position);
  block.set("orthographic", frame.camera.orthographic ? 1.0f : 0.0f);
  block.set("camera_forward", frame.camera.forward);
  block.set("screen_unit", frame.screen_unit);
  // One that holds nothing is a point where no ray comes: shaders are not promised infinity.
  constexpr float kNowhere = 1e30f;
  block.set("shown_low", frame.shown.isEmpty() ? glm::vec3(kNowhere) : frame.shown.low);
  block.set("shown_high", frame.shown.isEmpty() ? glm::vec3(kNowhere) : frame.shown.high);
  block.set("samples_per_pixel", static_cast<float>(settings.samples));
  block.set("sample_phase", (static_cast<float>(frame.sample) + 0.5f) / static_cast<float>(settings.samples));
  block.set("texture_filter", static_cast<int>(settings.texture_filter));
  block.set("lobe_taps", lobesOf(settings));
  block.set("inner_bounces", settings.inner_bounces);
  block.set("only_wavelength", settings.wavelength_nm / 1000.0f);
  block.set("wavelength_count", lightKindsOf(settings));
  if (isSpectral(settings))
    block.set("wavelengths", std::span<const glm::vec4>(wavelengthSets(settings, frame.sample)));
}

void SurfacePrograms::setLights(const EnvironmentLight& light, const FrameUniforms& frame,
                                const FrameSettings& settings) {
  const FlatLight* flat = frame.flat;
  lights_ = {{.environment = flat ? &flat->environment : &light.cube(),
              .prefiltered = flat ? &flat->prefiltered : frame.prefiltered.texture,
              .irradiance = flat ? &flat->irradiance : &light.irradiance(),
              .blur = blurOf(settings, light.cube(), frame.prefiltered),
              .intensity = settings.env_intensity * light.unit(),
              .environment_from_world = frame.environment_from_world}};
  light_of_instance_.clear();
  if (!frame.probes) return;
  lights_.insert(lights_.end(), frame.probes->lights.begin(), frame.probes->lights.end());
  light_of_instance_ = frame.probes->light_of_instance;
}

int SurfacePrograms::lightRead(const SurfaceVariant& variant, int instance) const {
  // Rays meet the other objects themselves.
  if (light_of_instance_.empty() || variant.has(Part::sky, SkyPart::occluded_traced)) return 0;
  return light_of_instance_[std::size_t(instance)] + 1;
}

void SurfacePrograms::bindLight(int light) {
  if (bound_light_ == light) return;
  bound_light_ = light;
  while (light_blocks_.size() < lights_.size()) light_blocks_.emplace_back(layouts_[light_point]);
  const SurfaceLight& read = lights_[std::size_t(light)];
  gl::UniformBlock& block = light_blocks_[std::size_t(light)];
  block.set("environment_from_world", read.environment_from_world);
  block.set("captured_from", read.captured_from);
  block.set("nearness_unit", read.nearness_unit);
  block.set("environment_intensity", read.intensity);
  block.set("blur_kind", read.blur.kind);
  block.set("first_level", read.blur.first_level);
  block.set("last_level", read.blur.last_level);
  block.set("texels_per_radian", read.blur.texels_per_radian);
  block.bind(light_point);
  read.environment->bind(TextureUnit::environment);
  read.prefiltered->bind(TextureUnit::prefiltered);
  read.irradiance->bind(TextureUnit::irradiance);
}

/// Of all instances and materials, once a scene; where some program reads them.
void SurfacePrograms::makeBlocks(const Scene& scene) {
  if (!instances_ && layouts_[instance_point]) {
    instances_.emplace(layouts_[instance_point], scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const glm::mat4& world_from_object = scene.instances[i].world_from_object;
      gl::UniformBlock& block = instances_->at(i);
      block.set("world_from_object", world_from_object);
      block.set("normal_matrix", glm::transpose(glm::inverse(glm::mat3(world_from_object))));
      block.set("instance", static_cast<int>(i));
      block.set("knows_backs", knowsBacks(scene, i) ? 1 : 0);
    }
  }
  if (!materials_ && layouts_[material_point]) {
    materials_.emplace(layouts_[material_point], scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      setParameters(materials_->at(i), scene.materials[i]);
      setMaps(*materials_, scene.materials[i]);
    }
  }
}

Result<void> SurfacePrograms::begin(const Scene& scene, const SceneBuffers& buffers, const EnvironmentLight& light,
                                    const FrameUniforms& frame, const FrameSettings& settings) {
  if (scene.instances.empty()) return {};
  coordinates_ = coordinateChoice(scene, settings);
  eye_is_inside_ = frame.eye_media.count > 0;
  setLights(light, frame, settings);
  scene_triangles_ = frame.scene_triangles;
  unseen_by_itself_ = frame.unseen_by_itself;
  MIRRORBALL_TRY_VOID(findDraws(scene, buffers, *frame.proxy, settings));
  makeBlocks(scene);
  setPrograms(scene, frame, settings);
  setFrame(frame, settings);
  bound_light_ = -1;
  brdf_table_.bind(TextureUnit::brdf_table);
  sphere_map_ = frame.sphere_map;
  proxy_ = frame.proxy;
  bodies_ = frame.bodies;
  back_faces_ = frame.back_faces;
  relief_hits_ = frame.relief_hits;
  opaque_picture_ = frame.opaque_picture;
  return {};
}

void SurfacePrograms::forgetScene() {
  draw_lists_.clear();
  instances_.reset();
  materials_.reset();
}

/// Those of a frame whose units others take, too.
void SurfacePrograms::bindFrameTextures(const SurfaceVariant& variant, const SurfaceLight& light) {
  if (variant.has(Part::look_up, LookUpPart::sphere_map))
    sphere_map_->bind(TextureUnit::sphere_map);
  else if (variant.has(Part::proxy, ProxyPart::captured))
    light.nearness->bind(TextureUnit::nearness);
  else if (!variant.has(Part::proxy, ProxyPart::none))
    proxy_->bind();
  if (bodies_ && variant.has(Part::transmission, TransmissionPart::traced)) bodies_->bind(TextureUnit::bodies);
  if (variant.has(Part::sky, SkyPart::occluded_traced)) scene_triangles_->bind(sceneTrianglesUnit(variant));
  if (back_faces_ && variant.has(Part::transmission, TransmissionPart::image_space))
    back_faces_->picture().bind(TextureUnit::back_faces);
  if (opaque_picture_ && variant.has(Part::behind, BehindPart::screen))
    opaque_picture_->bind(TextureUnit::opaque_picture);
}

void SurfacePrograms::draw(const Scene& scene, int instance, SceneBuffers& buffers, const FrameSettings& settings) {
  const Draw& draw = draws()[std::size_t(instance)];
  const int material = draw.material;
  const SurfaceVariant& variant = *draw.variant;
  gl::Program& program = *draw.program;
  const bool shows_heights = variant.has(Part::normal, NormalPart::heights);
  buffers.bindMaps(scene, material, TextureUnit::first_of_material, shows_heights);
  setExtents(program, scene, scene.materials[std::size_t(material)], buffers.mapsOf(material));
  if (const auto* heights = shows_heights ? buffers.heightsOf(scene, material) : nullptr) {
    const int texture = scene.materials[std::size_t(material)].height_texture;
    program.set("height_map", heightMapUniform(scene.height_textures[std::size_t(texture)]));
    program.set("height_form", glm::vec2(heights->slope_unit, settings.relief_steps));
  }
  if (variant.has(Part::normal, NormalPart::slopes)) program.set("slope_unit", buffers.slopesOf(scene, material)->unit);
  if (variant.has(Part::sky, SkyPart::occluded_traced))
    program.set("unseen_by_itself", unseen_by_itself_[std::size_t(instance)]);
  frame_->bind(frame_point);
  bindLight(draw.light);
  bindFrameTextures(variant, lights_[std::size_t(draw.light)]);
  if (instances_) instances_->bind(instance_point, std::size_t(instance));
  if (materials_) materials_->bind(material_point, std::size_t(material));
  program.use();
  if (variant.has(Part::transmission, TransmissionPart::image_space)) buffers.readIorAround(scene, instance);
  if (variant.has(Part::sky, SkyPart::occluded) || variant.has(Part::sky, SkyPart::occluded_traced))
    return buffers.drawMeshWithOcclusion(scene, instance);
  if (!variant.has(Part::point, PointPart::exact)) return buffers.drawMesh(draw.mesh);
  glDisable(GL_CULL_FACE);
  buffers.bindPrisms(draw.mesh, TextureUnit::prisms);
  relief_hits_->bind(TextureUnit::relief_hits);  // a unit of other materials' maps
  screen_.draw(3);
}

}  // namespace mirrorball
