#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/texture/texture_file.h"

namespace mirrorball {

/// What lies in a folder of baked maps.
enum class SetFiles {
  ours,    ///< mip chain, irradiance, BRDF table, lobe rows, sh.json, sh.h; a skybox if it is asked for
  cmgens,  ///< as Filament's cmgen deploys it: FOLDER_ibl, which has the harmonics too, FOLDER_skybox and sh.txt
};

/// How a program expects its baked maps, where the settings leave it open.
struct EngineSet {
  std::string_view program;  ///< Preset::name; "" for all that are not in the table
  MipMapping mip_mapping = MipMapping::filament;
  SetFiles files = SetFiles::ours;
  std::string_view extension = "ktx2";              ///< of textures
  std::optional<TexelFormat> format = {};           ///< of such textures' texels; none: as they need
  std::span<const TexelFormat> other_formats = {};  ///< that it reads, where it has a format of its own
  int smallest_face = 4;                            ///< of the chain [texels]
};

/// errors   usage: there is no such program
Result<EngineSet> engineSetFor(std::string_view program);

/// The number of levels of a chain whose settings leave it to the program.
///
/// size     of level 0 [texels]
int levelCountFor(const EngineSet& set, int size);

}  // namespace mirrorball
