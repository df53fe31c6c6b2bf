#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/map_sources.h"
#include "mirrorball/render/surface/shader_constants.h"
#include "mirrorball/render/surface/texture_coordinates.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A question that a surface's shader answers, and the parts (files of shaders/surface/) that it can be answered with.
/// A technique is one more answer; how one is added is told in docs/architecture.md.
struct SurfaceQuestion {
  std::string_view name;  ///< as shaders/surface/surface.frag asks it
  std::span<const std::string_view> answers;
};

/// The questions, in the order of their numbers.
enum class Part {
  point,
  coordinates,
  normal,
  detail,
  film,
  anisotropy,
  sheen,
  material,
  proxy,
  arriving_light,
  suns,
  look_up,
  dispersion,
  behind,
  transmission,
  sky,
  lamps,
  coat,
  alpha
};
constexpr std::size_t kParts = 19;
std::span<const SurfaceQuestion, kParts> surfaceQuestions();

// The answers, in the order of the table.
enum class PointPart : std::uint8_t { raster, parallax, steep, occlusion, linear_binary, cone, exact };
enum class CoordinatesPart : std::uint8_t { at_fragment, at_vertex, at_triangle };
enum class NormalPart : std::uint8_t { vertex, bump, heights, slopes };
enum class DetailPart : std::uint8_t { none, normal_map, object_normal_map };
enum class FilmPart : std::uint8_t { none, thin };
enum class AnisotropyPart : std::uint8_t { none, stretched };
enum class SheenPart : std::uint8_t { none, cloth };
enum class MaterialPart : std::uint8_t { core, unlit, from_inside };
/// ProxyKind's, and what a probe has captured.
enum class ProxyPart : std::uint8_t { none, box, sphere, ground, mesh, captured };
enum class ArrivingLightPart : std::uint8_t { distant, flat, flat_nearest };
enum class SunsPart : std::uint8_t { none, open, shadowed };
enum class LookUpPart : std::uint8_t { environment, sphere_map, stretched, strata, lobe_row };
enum class DispersionPart : std::uint8_t { channels, spectral };
enum class BehindPart : std::uint8_t { light, screen };
enum class TransmissionPart : std::uint8_t { none, single, thin, image_space, traced };
enum class SkyPart : std::uint8_t { open, over_horizons, occluded, occluded_traced };
enum class LampsPart : std::uint8_t { none, listed };
enum class CoatPart : std::uint8_t { none, clear, clear_mapped };
enum class AlphaPart : std::uint8_t { opaque, mask, blend };

/// Which shader draws a surface: an answer for each question, and where its material's maps are.
struct SurfaceVariant {
  std::array<std::uint8_t, kParts> answers{};
  std::vector<MapSource> maps = std::vector<MapSource>(materialMaps().size());  ///< of each row of that table
  std::uint8_t lamp_count = 0;                                                  ///< of LampsPart::listed
  std::uint8_t sun_count = 0;                                                   ///< of SunsPart::open and shadowed
  CoordinateChoice coordinates = {};
  ShaderConstants constants = {};

  template <typename Answer>
  void choose(Part part, Answer answer) {
    answers[static_cast<std::size_t>(part)] = static_cast<std::uint8_t>(answer);
  }
  template <typename Answer>
  bool has(Part part, Answer answer) const {
    return answers[static_cast<std::size_t>(part)] == static_cast<std::uint8_t>(answer);
  }
  /// Whether it has the parts that include row_of_lobes.glsl.
  bool readsRows() const { return has(Part::look_up, LookUpPart::lobe_row) || has(Part::look_up, LookUpPart::strata); }
  bool operator==(const SurfaceVariant&) const = default;
  /// Any order, for maps. libc++ 14, which compilers for browsers have, lacks <=> of containers.
  bool operator<(const SurfaceVariant& other) const {
    return std::tie(answers, maps, lamp_count, sun_count, coordinates, constants) <
           std::tie(other.answers, other.maps, other.lamp_count, other.sun_count, other.coordinates, other.constants);
  }
};

/// Units of a material's textures up to which a body can read the copy of the screen (FrameTexture::opaque_picture).
constexpr int kUnitsBesideScreen = 3;

/// Whether what is behind a surface is looked for in a picture of the opaque ones, after which it is then drawn.
bool seesScreen(const Material& material, const FrameSettings& settings);

/// How light passes through a material's bodies, where the settings leave it to their size.
RefractionKind refractionOf(const Scene& scene, int material, RefractionKind asked);

/// Whether light passes so through some body.
bool someRefract(const Scene& scene, RefractionKind kind, RefractionKind asked);

/// How many small lights a frame has.
struct LampCounts {
  std::size_t lamps = 0;  ///< of LampsPart
  std::size_t suns = 0;   ///< of SunsPart
};

/// maps          mapSources() of the material
/// lamps         how many there are, and suns that stand apart
/// coordinates   of the frame
SurfaceVariant surfaceVariant(const Material& material, std::vector<MapSource> maps, const FrameSettings& settings,
                              LampCounts lamps, const CoordinateChoice& coordinates = {});

/// Lets surfaces share a program that differ only in whether a metal's complex index is known. One without an index is
/// 5 % more work for each of its pixels in the program of one with an index; but a program more takes a software driver
/// up to seconds to compile.
///
/// variants   of all surfaces of a frame
void shareVariants(std::span<SurfaceVariant> variants);

/// Whether reflected light comes from a row of lobes along the tangent: about the reflected ray of each fragment, and
/// not where other coordinates are asked for.
bool stretchesLobes(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates);

/// Whether a surface's normals are not its mesh's alone, so that a pixel may hide some of them.
bool hasBumps(const Material& material, const FrameSettings& settings);

/// Whether it comes from strata of what a sample sees of bumps, likewise.
bool readsStrata(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates);

/// Whether it comes from a row of lobes in the plane of incidence, likewise.
bool readsLobeRow(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates);

}  // namespace mirrorball
