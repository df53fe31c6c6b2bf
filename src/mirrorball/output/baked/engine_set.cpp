#include "mirrorball/output/baked/engine_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "mirrorball/base/range.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/output/baked/babylon_environment.h"
#include "mirrorball/output/baked/image_based_light_gltf.h"
#include "mirrorball/output/baked/playcanvas_atlas.h"

namespace mirrorball {
namespace {

constexpr std::array<TexelFormat, 3> kOfFilament{TexelFormat::half, TexelFormat::float32, TexelFormat::bc6h};
constexpr std::array<TexelFormat, 3> kOfThree{TexelFormat::half, TexelFormat::float32, TexelFormat::bc6h};
constexpr std::array<TexelFormat, 2> kOfUnreal{TexelFormat::half, TexelFormat::float32};
constexpr std::array<TexelFormat, 4> kOfUnityAndGodot{TexelFormat::half, TexelFormat::float32, TexelFormat::e5b9g9r9,
                                                      TexelFormat::bc6h};

/// Of PNGs of four bytes a texel, of all levels: they, what they are gathered in, and the file.
constexpr int kBytesOfPictures = 3 * 4 * 4 / 3;

/// docs/prefiltering.md and docs/engines have the sources.
constexpr auto kEngineSets = std::to_array<EngineSet>({
    {.program = ""},
    {.program = "unreal", .mip_mapping = MipMapping::unreal, .extension = "dds", .other_formats = kOfUnreal},
    {.program = "unity", .mip_mapping = MipMapping::unity, .extension = "dds", .other_formats = kOfUnityAndGodot},
    {.program = "godot",
     .mip_mapping = MipMapping::frostbite,
     .extension = "dds",
     .other_formats = kOfUnityAndGodot,
     .smallest_face = 1},
    {.program = "filament",
     .mip_mapping = MipMapping::filament,
     .files = SetFiles::cmgens,
     .extension = "ktx",
     .format = TexelFormat::b10g11r11,
     .other_formats = kOfFilament,
     .smallest_face = 16,
     .has_irradiance_cube = false,
     .needs_no_others = "Filament has a BRDF table of its own, looks reflections up once, and has irradiance from "
                        "harmonics of three bands"},
    {.program = "three",
     .mip_mapping = MipMapping::filament,
     .files = SetFiles::chain,
     .format = TexelFormat::uastc_hdr,
     .other_formats = kOfThree,
     .smallest_face = 8,
     .has_irradiance_cube = false,
     .needs_no_others = "three.js has a BRDF table of its own, and finds irradiance in the last level"},
    {.program = "babylon",
     .mip_mapping = MipMapping::babylon,
     .files = SetFiles::packed,
     .extension = "env",
     .smallest_face = 1,
     .needs_power_of_two = true,
     .beside = "dds",
     .pack = babylonEnvironment,
     .pack_bytes = kBytesOfPictures,
     .needs_no_others = "Babylon.js has a BRDF table of its own, looks reflections up once, and finds the rest in its "
                        ".env file"},
    {.program = "playcanvas",
     .mip_mapping = MipMapping::linear,
     .files = SetFiles::packed,
     .extension = "png",
     .levels = kAtlasLevels,
     .pack = playcanvasAtlas,
     .pack_bytes = 4 * 12 / 3 + 12 + 2,  // a chain of floats, a level of it, and its texels' solid angles
     .needs_no_others = "PlayCanvas needs no BRDF table, looks reflections up once, and finds the rest in its atlas"},
    {.program = "gltf",
     .mip_mapping = MipMapping::gltf,
     .files = SetFiles::packed,
     .extension = "glb",
     .takes_any_mapping = true,
     .has_irradiance_cube = false,
     .needs_power_of_two = true,
     .pack = imageBasedLightGltf,
     .pack_bytes = kBytesOfPictures,
     .needs_no_others = "EXT_lights_image_based of glTF has reflections and three bands of irradiance only"},
    {.program = "openexr", .extension = "exr"},
});

/// How a program reads the maps of SetFiles::ours, whose levels have whatever roughness they are asked for.
EngineSet withOurFiles(const EngineSet& set) { return {.program = set.program, .mip_mapping = set.mip_mapping}; }

}  // namespace

Result<EngineSet> engineSetFor(std::string_view program, std::optional<MipMapping> mip_mapping) {
  if (program.empty()) return kEngineSets.front();
  MIRRORBALL_TRY(preset, presetNamed(program));
  const auto* const row = findBy(kEngineSets, preset.name, &EngineSet::program);
  if (row == kEngineSets.end()) return kEngineSets.front();
  const bool is_packed = row->files == SetFiles::packed;
  const bool is_packed_so = is_packed && (row->takes_any_mapping || mip_mapping == row->mip_mapping);
  const bool has_a_mapping = is_packed || row->files == SetFiles::chain;
  return mip_mapping && has_a_mapping && !is_packed_so ? withOurFiles(*row) : *row;
}

std::string_view programOfPacked(std::string_view extension) {
  for (const EngineSet& set : kEngineSets)
    if (set.files == SetFiles::packed && set.extension == extension) return set.program;
  return "";
}

int levelCountFor(const EngineSet& set, MipMapping mip_mapping, int size) {
  if (set.levels > 0) return set.levels;
  // Its roughness goes by the texels of a face, and reaches 1 in the smallest ones only.
  if (mip_mapping == MipMapping::babylon) return maxLevels(size);
  int levels = 1;
  while (levels < maxLevels(size) && levelSide(size, levels) >= set.smallest_face) ++levels;
  // As cmgen has it: one level would leave all surfaces mirrors.
  return levels == 1 && set.files == SetFiles::cmgens ? maxLevels(size) : levels;
}

std::string programNameOf(const EngineSet& set) {
  const auto preset = presetNamed(set.program);
  return std::string(preset ? preset->program : set.program);
}

Result<void> checkChain(const EngineSet& set, int size, int levels) {
  const std::string program = programNameOf(set);
  if (set.needs_power_of_two && !std::has_single_bit(static_cast<unsigned>(size)))
    return fail(ErrorCode::usage, program + " reads faces whose side is a power of two, not " + std::to_string(size) +
                                      "; ask for " + std::to_string(std::bit_floor(static_cast<unsigned>(size))));
  const int needed = set.smallest_face == 1 ? maxLevels(size) : set.levels;
  if (needed > 0 && levels > 0 && levels != needed)
    return fail(ErrorCode::usage, program + " reads a chain of " + std::to_string(needed) + " levels, not of " +
                                      std::to_string(levels) + "; leave their number to it");
  if (set.levels > maxLevels(size))
    return fail(ErrorCode::usage, program + " reads " + std::to_string(set.levels) + " levels, and faces of " +
                                      std::to_string(size) + " texels have " + std::to_string(maxLevels(size)) +
                                      "; ask for larger ones");
  return {};
}

}  // namespace mirrorball
