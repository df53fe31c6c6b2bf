#pragma once

#include <string>
#include <vector>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/output/baked/baked_files.h"
#include "mirrorball/output/baked/older_set.h"

namespace mirrorball {

/// In which formats the cubes of a set were written.
struct WrittenFormats {
  std::string specular;
  std::string irradiance;
  std::string skybox;
};

/// What the manifest tells of maps beside what was asked for.
struct BakedFacts {
  const std::vector<PrefilterLevel>& levels;  ///< of the specular mip chain
  int skybox_size;
  WrittenFormats formats;
  std::size_t lamps;       ///< how many were taken out
  std::string light_hash;  ///< lightHash
};

/// How the faces of a set's cubes are arranged, in words; "" where it has no cube.
std::string writtenFaces(const BakedFiles& files);

/// manifest.json: what is what in a set.
///
/// older   whose parts that remain it describes, too
std::string makeManifest(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings,
                         const OlderSet& older);

}  // namespace mirrorball
