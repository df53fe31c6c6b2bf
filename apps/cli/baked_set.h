#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/brdf_file.h"
#include "cli/cube_files.h"
#include "cli/engine_set.h"
#include "mirrorball/bake/bake.h"

namespace mirrorball::cli {

/// All that `bake` makes of an environment for an engine; cubes and table as far as they are asked for.
struct BakedSet {
  std::vector<std::string> inputs;  ///< the environment's files
  BakedMaps maps;
  int skybox_size = 0;
  Image brdf;
};

/// Where the files of a set lie, and how.
struct BakedFiles {
  std::string source;  ///< the environment's name, for the manifest
  std::string folder;
  EngineSet set;
  CubeFiles specular;
  std::optional<CubeFiles> irradiance = {};
  std::optional<CubeFiles> skybox = {};
  std::optional<BrdfFile> brdf = {};

  /// Of all that is written.
  std::vector<std::string> paths() const;
};

/// What a chain for a program says of the environment beside its levels: Filament's, the harmonics.
Metadata factsFor(const EngineSet& set, const Harmonics& radiance);

/// Writes the cubes and the BRDF table, the harmonics as text, and at last manifest.json, which says what is what. The
/// folder is made if it is not there, and is gone again if they could not all be written; of an older set in it the
/// manifest is gone then, and files may be.
///
/// errors   io; interrupted, between files; as writeImageSet's and writeImage's
Result<void> writeSet(BakedSet set, const BakedFiles& files, const BakeOptions& options);

}  // namespace mirrorball::cli
