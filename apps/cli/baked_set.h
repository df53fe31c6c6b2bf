#pragma once

#include <string>
#include <vector>

#include "cli/bake_command.h"
#include "cli/brdf_file.h"
#include "cli/map_output.h"
#include "mirrorball/bake/spherical_harmonics.h"

namespace mirrorball::cli {

/// All that `bake` makes of an environment for an engine.
struct BakedSet {
  std::vector<std::string> inputs;  ///< the environment's files
  std::vector<PrefilterLevel> levels;
  ImageSet specular;
  EnvironmentMap irradiance;  ///< divided by π
  Harmonics radiance;
  Image brdf;
};

/// Where the files of a set lie, and how.
struct BakedFiles {
  std::string source;  ///< the environment's name, for the manifest
  std::string folder;
  MapOutput specular;
  MapOutput irradiance;
  BrdfFile brdf;

  /// Of all that is written.
  std::vector<std::string> paths() const;
};

/// Writes specular, irradiance and BRDF table as textures, the harmonics as sh.json and sh.h, and at last manifest.json,
/// which says what is what. The folder is made if it is not there, and is gone again if they could not all be written; of
/// an older set in it the manifest is gone then, and files may be.
///
/// errors   io; interrupted, between files; as writeImageSet's and writeImage's
Result<void> writeSet(BakedSet set, const BakedFiles& files, const BakeOptions& options);

}  // namespace mirrorball::cli
