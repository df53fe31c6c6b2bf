#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/bake/bake.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/output/baked/packed_light.h"

namespace mirrorball {

/// What lies in a folder of baked maps.
enum class SetFiles {
  ours,    ///< mip chain, irradiance, BRDF table, lobe rows, sh.json, sh.h; a skybox if it is asked for
  cmgens,  ///< as Filament's cmgen deploys it: FOLDER_ibl, which has the harmonics too, FOLDER_skybox and sh.txt
  chain,   ///< the mip chain, which has the irradiance in its last level, and lobe rows; a skybox if it is asked for
  packed,  ///< one file of the program's own kind, which has all in it; the chain beside it where EngineSet::beside is
};

/// How a program expects its baked maps, where the settings leave it open.
struct EngineSet {
  std::string_view program;  ///< Preset::name; "" for all that are not in the table
  MipMapping mip_mapping = MipMapping::filament;
  SetFiles files = SetFiles::ours;
  std::string_view extension = "ktx2";              ///< of textures, or of the packed file
  std::optional<TexelFormat> format = {};           ///< of such textures' texels; none: as they need
  std::span<const TexelFormat> other_formats = {};  ///< that it reads in textures of its extension; none: any
  int smallest_face = 4;                            ///< of the chain [texels]; 1: no level may be missing
  int levels = 0;                                   ///< of the chain whatever its size; 0: by the smallest face
  bool takes_any_mapping = false;                   ///< its own files may have another mip mapping than `mip_mapping`
  bool has_irradiance_cube = true;                  ///< as a file of its own or in the packed one
  bool needs_power_of_two = false;                  ///< of the chain's size
  std::string_view beside = {};                     ///< the extension of the chain's texture beside a packed file
  PackLight pack = nullptr;                         ///< makes the packed file
  int pack_bytes = 0;                               ///< that it takes at most, its result included, a texel of level 0
  std::string_view needs_no_others = {};            ///< why it has no use for the maps of SetFiles::ours

  bool hasLobeRows() const { return files == SetFiles::ours || files == SetFiles::chain; }
  bool hasHarmonics() const { return files == SetFiles::ours || files == SetFiles::cmgens; }
};

/// mip_mapping   that was asked for. One that the program's packed file cannot have makes the set SetFiles::ours, as
///               any does where it is SetFiles::chain.
/// errors        usage: there is no such program
Result<EngineSet> engineSetFor(std::string_view program, std::optional<MipMapping> mip_mapping);

/// "three.js", for messages.
std::string programNameOf(const EngineSet& set);

/// The program whose own file has that extension; "" if there is none.
std::string_view programOfPacked(std::string_view extension);

/// The number of levels of a chain whose settings leave it to the program.
///
/// mip_mapping   that the chain has
/// size          of level 0 [texels]
int levelCountFor(const EngineSet& set, MipMapping mip_mapping, int size);

/// Refuses chains that the program's own file cannot have.
///
/// levels   that were asked for; 0: the program's
/// errors   usage
Result<void> checkChain(const EngineSet& set, int size, int levels);

}  // namespace mirrorball
