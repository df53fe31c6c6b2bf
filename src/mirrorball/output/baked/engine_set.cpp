#include "mirrorball/output/baked/engine_set.h"

#include <algorithm>
#include <array>

#include "mirrorball/base/range.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball {
namespace {

constexpr std::array<TexelFormat, 3> kOfFilament{TexelFormat::half, TexelFormat::float32, TexelFormat::bc6h};

/// docs/prefiltering.md has the sources.
constexpr auto kEngineSets = std::to_array<EngineSet>({
    {.program = ""},
    {.program = "unreal", .mip_mapping = MipMapping::unreal},
    {.program = "unity", .mip_mapping = MipMapping::unity},
    {.program = "godot", .mip_mapping = MipMapping::frostbite},
    {.program = "filament",
     .mip_mapping = MipMapping::filament,
     .files = SetFiles::cmgens,
     .extension = "ktx",
     .format = TexelFormat::b10g11r11,
     .other_formats = kOfFilament,
     .smallest_face = 16},
    {.program = "openexr", .extension = "exr"},
});

}  // namespace

Result<EngineSet> engineSetFor(std::string_view program) {
  if (program.empty()) return kEngineSets.front();
  MIRRORBALL_TRY(preset, presetNamed(program));
  const auto* const row = findBy(kEngineSets, preset.name, &EngineSet::program);
  return row != kEngineSets.end() ? *row : kEngineSets.front();
}

int levelCountFor(const EngineSet& set, int size) {
  int levels = 1;
  while (levelSide(size, levels) >= set.smallest_face) ++levels;
  // As cmgen has it: one level would leave all surfaces mirrors.
  return levels == 1 && set.files == SetFiles::cmgens ? maxLevels(size) : levels;
}

}  // namespace mirrorball
