#include "mirrorball/render/surface/texture_units.h"

#include <algorithm>
#include <cassert>

#include "mirrorball/render/light/proxy_uniforms.h"

namespace mirrorball {
namespace {

/// The parts that include brdf_look_up.glsl.
bool readsBrdfTable(const SurfaceVariant& variant) {
  return variant.has(Part::material, MaterialPart::core) || variant.has(Part::sky, SkyPart::occluded_traced) ||
         variant.readsRows();
}

}  // namespace

std::string_view samplerOf(FrameTexture texture, const SurfaceVariant& variant) {
  const auto where = [](bool is_read, std::string_view name) { return is_read ? name : std::string_view(); };
  const bool is_cube = variant.has(Part::arriving_light, ArrivingLightPart::distant);
  switch (texture) {
    case FrameTexture::environment:
      return is_cube ? "environment" : "environment_faces";
    case FrameTexture::prefiltered:
      return is_cube ? "prefiltered" : "prefiltered_faces";
    case FrameTexture::irradiance:
      return is_cube ? "irradiance" : "irradiance_faces";
    case FrameTexture::brdf_table:
      return where(readsBrdfTable(variant), "brdf_table");
    case FrameTexture::proxy:
      if (variant.has(Part::proxy, ProxyPart::captured)) return {};
      return samplerOfProxy(static_cast<ProxyKind>(variant.answers[std::size_t(Part::proxy)]));
    case FrameTexture::nearness:
      return where(variant.has(Part::proxy, ProxyPart::captured), "captured_nearness");
    case FrameTexture::sphere_map:
      return where(variant.has(Part::look_up, LookUpPart::sphere_map), "sphere_map");
    case FrameTexture::bodies:
      return where(variant.has(Part::transmission, TransmissionPart::traced), "bodies");
    case FrameTexture::back_faces:
      return where(variant.has(Part::transmission, TransmissionPart::image_space), "back_faces");
    case FrameTexture::scene_triangles:
      return where(variant.has(Part::sky, SkyPart::occluded_traced), "scene_triangles");
    case FrameTexture::opaque_picture:
      return where(variant.has(Part::behind, BehindPart::screen), "opaque_picture");
    case FrameTexture::relief_hits:
      return where(variant.has(Part::point, PointPart::exact), "relief_hits");
    case FrameTexture::prisms:
      return where(variant.has(Part::point, PointPart::exact), "prisms");
    case FrameTexture::heights:
      return where(variant.has(Part::normal, NormalPart::heights), "heights");
    case FrameTexture::horizons:
      return where(variant.has(Part::sky, SkyPart::over_horizons), "horizons");
    case FrameTexture::slopes:
      if (variant.has(Part::normal, NormalPart::heights)) return "slopes";
      return where(variant.has(Part::normal, NormalPart::slopes), "slope_map");
    case FrameTexture::sun_shadows:
      return where(variant.has(Part::suns, SunsPart::shadowed), "sun_shadows");
  }
  assert(false && "no such texture");
  return {};
}

TextureUnits::TextureUnits(const SurfaceVariant& variant) {
  int next = 0;
  for (std::size_t i = 0; i < kFrameTextures; ++i) {
    const auto texture = static_cast<FrameTexture>(i);
    const bool is_of_all = texture <= FrameTexture::brdf_table;
    units_[i] = is_of_all || !samplerOf(texture, variant).empty() ? next++ : -1;
  }
  first_of_maps_ = count_ = next;
  for (const MapSource& map : variant.maps) count_ = std::max(count_, first_of_maps_ + map.unit + 1);
}

bool TextureUnits::suffice(const SurfaceVariant& variant) {
  return TextureUnits(variant).count_ <= gl::Texture::kUnits;
}

}  // namespace mirrorball
