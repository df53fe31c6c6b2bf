#include "mirrorball/render/surface/surface_variant.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "mirrorball/render/surface/wavelength_sets.h"

namespace mirrorball {
namespace {

using Names = std::string_view;
constexpr auto kPoint =
    std::to_array<Names>({"point_raster.glsl", "point_parallax.glsl", "point_steep.glsl", "point_occlusion.glsl",
                          "point_linear_binary.glsl", "point_cone.glsl", "point_exact.glsl"});
constexpr auto kCoordinates = std::to_array<Names>(
    {"coordinates_at_fragment.glsl", "coordinates_at_vertex.glsl", "coordinates_at_triangle.glsl"});
constexpr auto kNormal =
    std::to_array<Names>({"normal_vertex.glsl", "normal_bump.glsl", "normal_heights.glsl", "normal_slopes.glsl"});
constexpr auto kDetail =
    std::to_array<Names>({"detail_none.glsl", "detail_normal_map.glsl", "detail_object_normal_map.glsl"});
constexpr auto kFilm = std::to_array<Names>({"film_none.glsl", "film_thin.glsl"});
constexpr auto kAnisotropy = std::to_array<Names>({"anisotropy_none.glsl", "anisotropy_stretched.glsl"});
constexpr auto kSheen = std::to_array<Names>({"sheen_none.glsl", "sheen_cloth.glsl"});
constexpr auto kMaterial =
    std::to_array<Names>({"material_core.glsl", "material_unlit.glsl", "material_from_inside.glsl"});
constexpr auto kProxy = std::to_array<Names>({"proxy_none.glsl", "proxy_box.glsl", "proxy_sphere.glsl",
                                              "proxy_ground.glsl", "proxy_triangles.glsl", "proxy_captured.glsl"});
constexpr auto kArrivingLight = std::to_array<Names>(
    {"arriving_light_distant.glsl", "arriving_light_flat.glsl", "arriving_light_flat_nearest.glsl"});
constexpr auto kSuns = std::to_array<Names>({"suns_none.glsl", "suns_open.glsl", "suns_shadowed.glsl"});
constexpr auto kLookUp =
    std::to_array<Names>({"look_up_environment.glsl", "look_up_sphere_map.glsl", "look_up_stretched.glsl",
                          "look_up_strata.glsl", "look_up_lobe_row.glsl"});
constexpr auto kDispersion = std::to_array<Names>({"dispersion_channels.glsl", "dispersion_spectral.glsl"});
constexpr auto kBehind = std::to_array<Names>({"behind_light.glsl", "behind_screen.glsl"});
constexpr auto kTransmission =
    std::to_array<Names>({"transmission_none.glsl", "transmission_single.glsl", "transmission_thin.glsl",
                          "transmission_image_space.glsl", "transmission_traced.glsl"});
constexpr auto kSky =
    std::to_array<Names>({"sky_open.glsl", "sky_over_horizons.glsl", "sky_occluded.glsl", "sky_occluded_traced.glsl"});
constexpr auto kLamps = std::to_array<Names>({"lamps_none.glsl", "lamps_listed.glsl"});
constexpr auto kCoat = std::to_array<Names>({"coat_none.glsl", "coat_clear.glsl", "coat_clear_mapped.glsl"});
constexpr auto kAlpha = std::to_array<Names>({"alpha_opaque.glsl", "alpha_mask.glsl", "alpha_blend.glsl"});

constexpr std::array<SurfaceQuestion, kParts> kQuestions{{
    {"point", kPoint},
    {"coordinates", kCoordinates},
    {"normal", kNormal},
    {"detail", kDetail},
    {"film", kFilm},
    {"anisotropy", kAnisotropy},
    {"sheen", kSheen},
    {"material", kMaterial},
    {"proxy", kProxy},
    {"arriving light", kArrivingLight},
    {"suns", kSuns},
    {"look-up", kLookUp},
    {"dispersion", kDispersion},
    {"behind", kBehind},
    {"transmission", kTransmission},
    {"sky", kSky},
    {"lamps", kLamps},
    {"coat", kCoat},
    {"alpha", kAlpha},
}};

NormalPart normalPart(const Material& material, const FrameSettings& settings) {
  if (showsHeights(material, settings.relief))
    return material.height_texture >= 0 ? NormalPart::heights : NormalPart::bump;
  return material.slope_texture >= 0 ? NormalPart::slopes : NormalPart::vertex;
}

DetailPart detailPart(const Material& material) {
  if (material.normal_map.texture < 0) return DetailPart::none;
  return material.normal_space == NormalSpace::object ? DetailPart::object_normal_map : DetailPart::normal_map;
}

PointPart pointPart(const Material& material, const FrameSettings& settings) {
  if (normalPart(material, settings) != NormalPart::heights) return PointPart::raster;
  switch (settings.relief) {
    case ReliefKind::parallax:
      return PointPart::parallax;
    case ReliefKind::steep:
      return PointPart::steep;
    case ReliefKind::occlusion:
      return PointPart::occlusion;
    case ReliefKind::linear_binary:
      return PointPart::linear_binary;
    case ReliefKind::cone:
      return PointPart::cone;
    case ReliefKind::exact:
      return PointPart::exact;
    case ReliefKind::none:
    case ReliefKind::bump:
    case ReliefKind::geometry:
      break;
  }
  return PointPart::raster;
}

CoordinatesPart coordinatesPart(ReflectAt reflect_at) {
  switch (reflect_at) {
    case ReflectAt::vertex:
      return CoordinatesPart::at_vertex;
    case ReflectAt::triangle:
      return CoordinatesPart::at_triangle;
    case ReflectAt::fragment:
      break;
  }
  return CoordinatesPart::at_fragment;
}

TransmissionPart transmissionPart(const Material& material, const FrameSettings& settings) {
  if (material.transmission <= 0.0f) return TransmissionPart::none;
  if (material.thin_walled) return TransmissionPart::thin;
  switch (settings.refraction) {
    case RefractionKind::traced:
      return TransmissionPart::traced;
    case RefractionKind::image_space:
      return TransmissionPart::image_space;
    case RefractionKind::single:
    case RefractionKind::automatic:  // has been decided
      break;
  }
  return TransmissionPart::single;
}

DispersionPart dispersionPart(const Material& material, const FrameSettings& settings) {
  return isBody(material) && isSpectral(settings) ? DispersionPart::spectral : DispersionPart::channels;
}

CoatPart coatPart(const Material& material) {
  if (material.clearcoat <= 0.0f) return CoatPart::none;
  return material.clearcoat_normal_map.texture >= 0 ? CoatPart::clear_mapped : CoatPart::clear;
}

/// The copy of the screen takes a texture unit that few bodies have a picture in.
BehindPart behindPart(const Material& material, const std::vector<MapSource>& maps, const FrameSettings& settings) {
  const bool is_free =
      std::none_of(maps.begin(), maps.end(), [](const MapSource& source) { return source.unit >= kUnitsBesideScreen; });
  return seesScreen(material, settings) && is_free ? BehindPart::screen : BehindPart::light;
}

bool reflectsAtFragment(const FrameSettings& settings, const CoordinateChoice& coordinates) {
  const bool is_reflection = coordinates.look_up == Generated::reflection && settings.reflect_at == ReflectAt::fragment;
  return is_reflection && !coordinates.is_sphere_map;
}

/// Whether rays find a clean reflection: into wide lobes they are speckles until there are many, and cost as much as
/// others. A coat has its own.
bool hasFewSpeckles(const Material& material, const FrameSettings& settings) {
  constexpr int kSamplesOfRough = 16;
  constexpr float kSmooth = 0.3f;  // sky_occluded_traced.glsl has no rays from there on
  const bool is_rough = material.perceptual_roughness >= kSmooth && material.roughness_map.texture < 0;
  const bool has_smooth_coat = material.clearcoat > 0.0f && material.clearcoat_roughness < kSmooth;
  return settings.samples >= kSamplesOfRough || !is_rough || has_smooth_coat;
}

/// Whether none of the maps lies in the texture unit of the scene's triangles, that of what transmits.
bool leavesSceneUnit(const std::vector<MapSource>& maps) {
  return std::none_of(maps.begin(), maps.end(), [](const MapSource& map) { return map.unit > kUnitsBesideScreen; });
}

/// What vertices know is said of the triangles; relief in them tells of more.
SkyPart skyPart(const SurfaceVariant& variant, const Material& material, const FrameSettings& settings,
                const CoordinateChoice& coordinates) {
  if (!variant.has(Part::point, PointPart::raster)) return SkyPart::over_horizons;
  if (settings.occlusion == OcclusionKind::none) return SkyPart::open;
  const bool is_traced = settings.self_reflection && reflectsAtFragment(settings, coordinates) &&
                         (variant.has(Part::transmission, TransmissionPart::none) || leavesSceneUnit(variant.maps)) &&
                         hasFewSpeckles(material, settings);
  return is_traced ? SkyPart::occluded_traced : SkyPart::occluded;
}

LookUpPart lookUpPart(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  if (coordinates.is_sphere_map) return LookUpPart::sphere_map;
  if (stretchesLobes(material, settings, coordinates)) return LookUpPart::stretched;
  if (readsStrata(material, settings, coordinates)) return LookUpPart::strata;
  return readsLobeRow(material, settings, coordinates) ? LookUpPart::lobe_row : LookUpPart::environment;
}

/// What glTF's extensions lay on the surface.
void chooseLayers(SurfaceVariant& variant, const Material& material) {
  if (material.iridescence > 0.0f) variant.choose(Part::film, FilmPart::thin);
  if (material.anisotropy > 0.0f) variant.choose(Part::anisotropy, AnisotropyPart::stretched);
  if (material.sheen_color != glm::vec3(0.0f)) variant.choose(Part::sheen, SheenPart::cloth);
  variant.choose(Part::coat, coatPart(material));
}

}  // namespace

std::span<const SurfaceQuestion, kParts> surfaceQuestions() { return kQuestions; }

bool stretchesLobes(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  return material.anisotropy > 0.0f && reflectsAtFragment(settings, coordinates);
}

bool hasBumps(const Material& material, const FrameSettings& settings) {
  return normalPart(material, settings) != NormalPart::vertex || detailPart(material) != DetailPart::none;
}

bool readsStrata(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  return hasBumps(material, settings) && !stretchesLobes(material, settings, coordinates) &&
         reflectsAtFragment(settings, coordinates);
}

bool readsLobeRow(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  const bool has_rough_coat = material.clearcoat > 0.0f && !hasSmoothCoat(material);
  const bool is_rough = material.perceptual_roughness > 0.0f || has_rough_coat;
  return is_rough && lobesOf(settings) > 1 && !stretchesLobes(material, settings, coordinates) &&
         reflectsAtFragment(settings, coordinates);
}

bool seesScreen(const Material& material, const FrameSettings& settings) {
  return settings.behind == BehindKind::screen && material.transmission > 0.0f && !material.unlit;
}

RefractionKind refractionOf(const Scene& scene, int material, RefractionKind asked) {
  if (asked != RefractionKind::automatic) return asked;
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.material == material) triangles = std::max(triangles, mesh.indices.size() / 3);
  constexpr std::size_t kFewTriangles = 500;
  return triangles <= kFewTriangles ? RefractionKind::traced : RefractionKind::image_space;
}

bool someRefract(const Scene& scene, RefractionKind kind, RefractionKind asked) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (isBody(scene.materials[i]) && refractionOf(scene, static_cast<int>(i), asked) == kind) return true;
  return false;
}

SurfaceVariant surfaceVariant(const Material& material, std::vector<MapSource> maps, const FrameSettings& settings,
                              LampCounts lamps, const CoordinateChoice& coordinates) {
  SurfaceVariant variant;
  variant.maps = std::move(maps);
  if (material.alpha_mode == AlphaMode::mask) variant.choose(Part::alpha, AlphaPart::mask);
  if (material.alpha_mode == AlphaMode::blend) variant.choose(Part::alpha, AlphaPart::blend);
  variant.choose(Part::point, pointPart(material, settings));
  variant.choose(Part::normal, normalPart(material, settings));
  variant.coordinates = coordinates;
  variant.constants = shaderConstants(material, settings);
  // A prism has no corners that the surface has.
  if (!variant.has(Part::point, PointPart::exact))
    variant.choose(Part::coordinates, coordinatesPart(settings.reflect_at));
  if (material.unlit) {
    variant.choose(Part::material, MaterialPart::unlit);
    return variant;
  }
  variant.choose(Part::detail, detailPart(material));
  // A sphere map shows what is infinitely far away. Part::proxy has the settings' choices first.
  variant.choose(Part::proxy, coordinates.is_sphere_map ? ProxyKind::none : settings.proxy.kind);
  variant.choose(Part::arriving_light, settings.look_up);  // the same choices
  variant.choose(Part::look_up, lookUpPart(material, settings, coordinates));
  // So that no other program is made for what is not read.
  if (!readsLobeRow(material, settings, coordinates)) variant.constants.lobe_taps = 1;
  chooseLayers(variant, material);
  variant.choose(Part::dispersion, dispersionPart(material, settings));
  variant.choose(Part::behind, behindPart(material, variant.maps, settings));
  variant.choose(Part::transmission, transmissionPart(material, settings));
  variant.choose(Part::sky, skyPart(variant, material, settings, coordinates));
  variant.choose(Part::lamps, lamps.lamps == 0 ? LampsPart::none : LampsPart::listed);
  variant.lamp_count = static_cast<std::uint8_t>(lamps.lamps);
  variant.choose(Part::suns, lamps.suns == 0 ? SunsPart::none : SunsPart::shadowed);
  variant.sun_count = static_cast<std::uint8_t>(lamps.suns);
  return variant;
}

void shareVariants(std::span<SurfaceVariant> variants) {
  std::set<SurfaceVariant> with_index;
  for (const SurfaceVariant& variant : variants)
    if (variant.constants.has_conductor_index) with_index.insert(variant);
  if (with_index.empty()) return;
  for (SurfaceVariant& variant : variants) {
    SurfaceVariant shared = variant;
    shared.constants.has_conductor_index = true;
    if (with_index.contains(shared)) variant = std::move(shared);
  }
}

}  // namespace mirrorball
