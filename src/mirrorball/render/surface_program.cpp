#include "mirrorball/render/surface_program.h"

#include <array>
#include <cmath>

#include "mirrorball/bake/brdf_table.h"

namespace mirrorball {
namespace {

/// A texture slot, and what shaders/surface.frag calls it.
struct Slot {
  const char* name;
  const char* define;
  TextureSlot Material::*slot;
};
constexpr std::array<Slot, 5> kSlots{{
    {"base_color", "BASE_COLOR_TEXTURE", &Material::base_color_texture},
    {"metallic_roughness", "METALLIC_ROUGHNESS_TEXTURE", &Material::metallic_roughness_texture},
    {"normal", "NORMAL_TEXTURE", &Material::normal_texture},
    {"occlusion", "OCCLUSION_TEXTURE", &Material::occlusion_texture},
    {"emission", "EMISSION_TEXTURE", &Material::emission_texture},
}};

std::vector<std::string> definesFor(const Material& material, const FrameSettings& settings) {
  std::vector<std::string> defines;
  for (const Slot& slot : kSlots)
    if ((material.*slot.slot).texture >= 0) defines.emplace_back(slot.define);
  if (material.bump == BumpHeight::orange) defines.emplace_back("BUMP");
  if (material.transmission > 0.0f) defines.emplace_back("TRANSMISSION");
  if (material.alpha_mode == AlphaMode::mask) defines.emplace_back("ALPHA_MASK");
  if (material.alpha_mode == AlphaMode::blend) defines.emplace_back("ALPHA_BLEND");
  if (settings.mapping == Mapping::normal) defines.emplace_back("NORMAL_MAPPING");
  if (settings.mapping == Mapping::sphere) defines.emplace_back("SPHERE_MAPPING");
  if (settings.reflect_at == ReflectAt::vertex) defines.emplace_back("REFLECT_AT_VERTEX");
  if (!settings.lights.empty()) defines.push_back("LIGHTS " + std::to_string(settings.lights.size()));
  return defines;
}

/// KHR_texture_transform: translation · rotation · scale, as the columns of a matrix and an offset.
void setSlot(gl::Program& program, const Slot& slot, const TextureSlot& texture, const SceneBuffers& buffers,
             int unit) {
  const std::string name = slot.name;
  const float sine = std::sin(texture.rotation_rad);
  const float cosine = std::cos(texture.rotation_rad);
  buffers.texture(texture.texture).bind(unit);
  program.set(name + "_texture", unit);
  program.set(name + "_uv_matrix", glm::vec4(cosine * texture.scale.x, -sine * texture.scale.x, sine * texture.scale.y,
                                             cosine * texture.scale.y));
  program.set(name + "_uv_offset", glm::vec3(texture.offset, static_cast<float>(texture.uv_set)));
}

void setMaterial(gl::Program& program, const Material& material, const SceneBuffers& buffers) {
  program.set("base_color", glm::vec4(material.base_color, material.opacity));
  program.set("metallic", material.metallic);
  program.set("perceptual_roughness", material.perceptual_roughness);
  program.set("specular", material.specular);
  program.set("ior", material.ior);
  program.set("dispersion", material.dispersion);
  program.set("transmission", material.transmission);
  program.set("conductor_n", material.conductor_n);
  program.set("conductor_k", material.conductor_k);
  program.set("emission", material.emission);
  program.set("fresnel", static_cast<int>(material.fresnel));
  program.set("fresnel_empirical", glm::vec3(material.fresnel_offset, material.fresnel_scale, material.fresnel_power));
  program.set("bump_height", material.bump_height);
  program.set("bump_frequency", material.bump_frequency);
  program.set("alpha_cutoff", material.alpha_cutoff);
  program.set("normal_scale", material.normal_scale);
  program.set("occlusion_strength", material.occlusion_strength);
  int unit = TextureUnit::first_of_material;
  for (const Slot& slot : kSlots)
    if (const TextureSlot& texture = material.*slot.slot; texture.texture >= 0)
      setSlot(program, slot, texture, buffers, unit++);
}

/// Blur::kind in formula/blur.glsl: both chains are looked up alike.
int blurKindOfFormula(BlurKind blur) {
  switch (blur) {
    case BlurKind::mip:
      return 1;
    case BlurKind::cone:
      return 2;
    default:
      return 0;
  }
}

void setFrame(gl::Program& program, const EnvironmentLight& light, const FrameUniforms& frame,
              const FrameSettings& settings) {
  program.set("clip_from_world", frame.camera.clip_from_view * frame.camera.view_from_world);
  program.set("camera_position", frame.camera.position);
  program.set("camera_forward", frame.camera.forward);
  program.set("orthographic", frame.camera.orthographic ? 1.0f : 0.0f);
  light.cube().bind(TextureUnit::environment);
  program.set("environment", TextureUnit::environment);
  program.set("environment_from_world", frame.environment_from_world);
  program.set("environment_intensity", settings.env_intensity);
  const PrefilteredChain& chain = frame.prefiltered;
  chain.texture->bind(TextureUnit::prefiltered);
  program.set("prefiltered", TextureUnit::prefiltered);
  light.irradiance().bind(TextureUnit::irradiance);
  program.set("irradiance", TextureUnit::irradiance);
  program.set("blur_kind", blurKindOfFormula(settings.blur));
  program.set("first_level", static_cast<float>(chain.first_level));
  program.set("last_level", static_cast<float>(chain.lastLevel()));
  program.set("coarser", std::log2(static_cast<float>(light.cube().width()) / static_cast<float>(chain.size())));
  program.set("texels_per_radian", light.texelsPerRadian());
  program.set("samples_per_pixel", static_cast<float>(settings.samples));
  program.set("sphere_map", TextureUnit::sphere_map);
  program.set("texture_matrix", frame.texture_matrix);
}

void setLights(gl::Program& program, const std::vector<PointLight>& lights) {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;
  for (const PointLight& light : lights) {
    positions.push_back(light.position);
    colors.push_back(light.color);
  }
  if (lights.empty()) return;
  program.set("light_position", std::span<const glm::vec3>(positions));
  program.set("light_color", std::span<const glm::vec3>(colors));
}

}  // namespace

Result<Image> surfaceBrdfTable() {
  // Made once, since it is the same for every renderer and all its inputs stand here. Textures have one, three or four channels.
  static const Result<Image> table = brdfTable({.channels = 3, .axes = BrdfAxes::warped});
  return table;
}

Result<SurfacePrograms> SurfacePrograms::make(gl::Api api, const Image& brdf_table) {
  // OpenGL ES filters no more than half floats, which keep a share to 2.5e-4.
  MIRRORBALL_TRY(texture, gl::Texture::fromImages(gl::Format::rgba16f, ImageSet(brdf_table)));
  texture.setSampling({.filter = gl::Sampling::Filter::linear});
  return SurfacePrograms(api, std::move(texture));
}

Result<gl::Program*> SurfacePrograms::programFor(const std::vector<std::string>& defines) {
  auto found = programs_.find(defines);
  if (found == programs_.end()) {
    const std::vector<std::string_view> views(defines.begin(), defines.end());
    MIRRORBALL_TRY(program, gl::Program::load(api_, "mesh.vert", "surface.frag", views));
    found = programs_.emplace(defines, std::move(program)).first;
  }
  return &found->second;
}

Result<gl::Program*> SurfacePrograms::prepare(const Material& material, const SceneBuffers& buffers,
                                              const EnvironmentLight& light, const FrameUniforms& frame,
                                              const FrameSettings& settings) {
  MIRRORBALL_TRY(program, programFor(definesFor(material, settings)));
  program->use();
  setFrame(*program, light, frame, settings);
  brdf_table_.bind(TextureUnit::brdf_table);
  program->set("brdf_table", TextureUnit::brdf_table);
  setMaterial(*program, material, buffers);
  setLights(*program, settings.lights);
  return program;
}

}  // namespace mirrorball
