#include "mirrorball/render/surface/surface_programs.h"

#include <string>

#include "mirrorball/render/surface/brdf_texture.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
namespace {

constexpr std::array<const char*, 4> kBlocks{"FrameBlock", "InstanceBlock", "MaterialBlock",
                                             "LightBlock"};  // by BlockPoint

/// The parts that include brdf_look_up.glsl.
bool readsBrdfTable(const SurfaceVariant& variant) {
  return variant.has(Part::material, MaterialPart::core) || variant.has(Part::sky, SkyPart::occluded_traced) ||
         variant.has(Part::look_up, LookUpPart::lobe_row) || variant.has(Part::look_up, LookUpPart::strata);
}

}  // namespace

int sceneTrianglesUnit(const SurfaceVariant& variant) {
  return variant.has(Part::transmission, TransmissionPart::none) ? TextureUnit::scene_triangles
                                                                 : TextureUnit::scene_triangles_of_glass;
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
    proxy.connection().connect(program, static_cast<ProxyKind>(variant.answers[std::size_t(Part::proxy)]));
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

Result<SurfacePrograms::Programs::pointer> SurfacePrograms::programFor(const SurfaceVariant& variant,
                                                                       ProxyUniforms& proxy) {
  auto found = programs_.find(variant);
  if (found == programs_.end()) {
    MIRRORBALL_TRY(shaders, surfaceShaders(api_, variant));
    MIRRORBALL_TRY(program, gl::Program::build(shaders.vertex, shaders.fragment, "surface.vert with surface.frag"));
    if (variant.has(Part::sheen, SheenPart::cloth)) MIRRORBALL_TRY_VOID(addClothToBrdfTable());
    connect(program, variant, proxy);
    found = programs_.emplace(variant, std::move(program)).first;
  }
  return &*found;
}

void SurfacePrograms::bindBrdfTable() const { brdf_table_.bind(TextureUnit::brdf_table); }

}  // namespace mirrorball
