#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mirrorball/output/baked/baked_set.h"
#include "mirrorball/output/baked/brdf_file.h"
#include "mirrorball/output/baked/cube_files.h"
#include "mirrorball/output/baked/engine_set.h"
#include "mirrorball/output/baked/lobe_row_files.h"

namespace mirrorball {

/// The extensions that the files of a set can have: of its cubes, and of its table, which holds no light but numbers.
std::span<const std::string_view> bakedCubeExtensions();
std::span<const std::string_view> bakedBrdfExtensions();

/// The value of a setting as its option writes it: "ggx".
std::string writtenSetting(const BakedSetSettings& settings, std::string_view name);

/// What the names of a set's lamps begin with, and those of a program's own file and of the chain beside it.
inline constexpr const char* kLampStem = "lamps";
inline constexpr const char* kPackedStem = "environment";
inline constexpr const char* kManifestName = "manifest.json";

/// Where the files of a set are, and how they are stored.
struct BakedFiles {
  std::string folder = {};  ///< empty: one file alone
  EngineSet set;
  std::optional<CubeFiles> specular = {};
  std::string packed = {};  ///< of SetFiles::packed; empty: none
  std::optional<CubeFiles> irradiance = {};
  std::optional<CubeFiles> skybox = {};
  std::optional<BrdfFile> brdf = {};
  std::optional<LobeRowFiles> lobe_rows = {};
  std::vector<std::string> harmonics = {};  ///< names in the folder: as `set` has them
  std::vector<std::string> lamps = {};      ///< writeLamps knows them by their endings

  /// output, settings   as BakedSet::resolve's, levels and format settled
  /// errors             usage: no such folder can be, or no such files
  static Result<BakedFiles> resolve(const std::string& output, const BakedSetSettings& settings, const EngineSet& set,
                                    const Observer& observer);

  /// Of all that is written.
  std::vector<std::string> paths() const;

  /// The first of the cubes that there are; nullptr: there are none.
  const CubeFiles* anyCube() const;

  /// Whether any of them depends on the environment; tables do not.
  bool hasLight() const { return anyCube() != nullptr || !packed.empty() || !harmonics.empty() || !lamps.empty(); }
};

/// The format of the cubes that the settings leave to the engine.
///
/// extension  of the cubes' files; empty: the engine's
/// errors     usage: the engine reads no such format
Result<std::optional<TexelFormat>> settledFormat(const EngineSet& set, const BakedSetSettings& settings,
                                                 const std::string& extension);

}  // namespace mirrorball
