#include "mirrorball/render/surface/surface_programs.h"

#include <string>
#include <utility>

#include "mirrorball/render/surface/brdf_texture.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {
namespace {

constexpr std::array<const char*, 4> kBlocks{"FrameBlock", "InstanceBlock", "MaterialBlock",
                                             "LightBlock"};  // by BlockPoint

}  // namespace

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

/// Says which unit and which binding point each sampler and block reads.
void SurfacePrograms::connect(Program& made, const SurfaceVariant& variant, ProxyUniforms& proxy) {
  gl::Program& program = made.program;
  for (std::size_t i = 0; i < kFrameTextures; ++i) {
    const auto texture = static_cast<FrameTexture>(i);
    if (const auto name = samplerOf(texture, variant); !name.empty()) program.set(name, made.units.of(texture));
  }
  for (std::size_t row = 0; row < variant.maps.size(); ++row)
    if (const int unit = variant.maps[row].unit; unit >= 0)
      program.set(samplerName(variant.maps, row), made.units.firstOfMaps() + unit);
  if (!variant.has(Part::proxy, ProxyPart::captured) && !variant.has(Part::proxy, ProxyPart::none))
    proxy.connection().connectBlock(program);
  for (unsigned point = 0; point < block_points; ++point) {
    const auto layout = program.connect(kBlocks[point], point);
    if (layout && !layouts_[point]) layouts_[point] = std::make_shared<gl::BlockLayout>(*layout);
  }
}

Result<SurfacePrograms::Programs::pointer> SurfacePrograms::submit(const SurfaceVariant& variant) {
  if (const auto found = programs_.find(variant); found != programs_.end()) return &*found;
  MIRRORBALL_TRY(shaders, surfaceShaders(api_, variant));
  return &add(variant, compile(std::move(shaders)));
}

gl::PendingProgram SurfacePrograms::compile(SurfaceShaders shaders) {
  return gl::PendingProgram(std::move(shaders.vertex), std::move(shaders.fragment), "surface.vert with surface.frag");
}

SurfacePrograms::Programs::reference SurfacePrograms::add(const SurfaceVariant& variant, gl::PendingProgram submitted) {
  return *programs_.emplace(variant, Entry{.submitted = std::move(submitted)}).first;
}

Result<void> SurfacePrograms::prepare(const SurfaceVariant& variant) {
  if (variant.has(Part::sheen, SheenPart::cloth)) return addClothToBrdfTable();
  return {};
}

Result<void> SurfacePrograms::finish(Programs::reference entry, ProxyUniforms& proxy) {
  const SurfaceVariant& variant = entry.first;
  Entry& program = entry.second;
  if (program.made) return {};
  MIRRORBALL_TRY_VOID(prepare(variant));
  auto made = program.submitted->finish();
  if (!made) {
    programs_.erase(variant);
    return fail(std::move(made));
  }
  program.submitted.reset();
  program.made.emplace(Program{std::move(*made), TextureUnits(variant)});
  connect(*program.made, variant, proxy);
  return {};
}

void SurfacePrograms::bindBrdfTable() const { brdf_table_.bind(static_cast<int>(FrameTexture::brdf_table)); }

}  // namespace mirrorball
