#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/map_output.h"
#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// --mip-mapping: MipMapping's values after one that leaves it to --for, which is settled before anything is made.
enum class MipMappingChoice { as_for, filament, linear, unreal, unity, frostbite };
constexpr MipMapping mipMappingOf(MipMappingChoice choice) {
  return choice == MipMappingChoice::as_for ? MipMapping::filament
                                            : static_cast<MipMapping>(static_cast<int>(choice) - 1);
}

/// What `bake` is told beside its input and how its textures are stored (map_output.h).
struct BakeOptions {
  std::string output;
  std::string from;
  bool repair = false;
  std::vector<float> rotate_deg;
  int size = 256;
  int levels = 0;
  Distribution distribution = Distribution::ggx;
  MipMappingChoice mip_mapping = MipMappingChoice::as_for;
  int irradiance_size = 32;
  int harmonics_degree = 2;
  int brdf_size = 128;
  int brdf_channels = 3;
  BrdfAxes brdf_axes = BrdfAxes::linear;
  std::string brdf_extension;
  bool skybox = false;
  int skybox_size = 0;
  std::string extension;
  bool timings = false;
  std::string max_memory;
};

std::span<const Option<BakeOptions>> bakeOptions();

/// How the value of one of them is written on the command line.
std::string writtenValue(const BakeOptions& options, std::string_view name);

}  // namespace mirrorball::cli
