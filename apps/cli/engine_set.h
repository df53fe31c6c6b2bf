#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/bake_command.h"

namespace mirrorball::cli {

/// What lies in a baked folder.
enum class SetFiles {
  ours,    ///< chain, irradiance, BRDF table, sh.json, sh.h; a skybox if it is asked for
  cmgens,  ///< as Filament's cmgen deploys it: FOLDER_ibl, which has the harmonics too, FOLDER_skybox and sh.txt
};

/// How a program has its baked maps, where the command line does not say otherwise.
struct EngineSet {
  std::string_view program;  ///< Preset::name; "" for all that are not in the table
  MipMappingChoice mip_mapping = MipMappingChoice::filament;
  SetFiles files = SetFiles::ours;
  std::string_view extension = "ktx2";              ///< of textures
  std::optional<TexelFormat> format = {};           ///< of such textures' texels; none: as they need
  std::span<const TexelFormat> other_formats = {};  ///< that it reads, where it has a format of its own
  int smallest_face = 4;                            ///< of the chain [texels]
};

/// errors   usage: there is no such program
Result<EngineSet> engineSetFor(std::string_view program);

/// All that `bake` was told of one environment.
struct BakeRequest {
  std::string environment;
  BakeOptions options;
  MapOutputOptions output;
  EngineSet set = {};  ///< of output.program
};

/// How many levels the chain has.
int levelCount(const BakeRequest& request);

}  // namespace mirrorball::cli
