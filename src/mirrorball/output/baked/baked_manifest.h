#pragma once

#include <string>
#include <vector>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/output/baked/baked_files.h"

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
  std::size_t lamps;  ///< how many were taken out
};

/// manifest.json: what is what in a set.
std::string manifestOf(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings);

/// Removes an older set's manifest, which would tell of other maps than those that now take their places, and those of
/// its files that the new set has not, but for the environment itself.
///
/// inputs   the environment's files
void removeOlderSet(const BakedFiles& files, const std::vector<std::string>& inputs);

}  // namespace mirrorball
