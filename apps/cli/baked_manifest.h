#pragma once

#include <string>

#include "cli/baked_set.h"

namespace mirrorball::cli {

/// In which formats the cubes of a set were written.
struct WrittenFormats {
  std::string specular;
  std::string irradiance;
  std::string skybox;
};

/// manifest.json: what is what in a set.
std::string manifestOf(const BakedSet& set, const BakedFiles& files, const BakeOptions& options,
                       const WrittenFormats& formats);

/// Removes an older set's manifest, which would tell of other maps than those that now take their places, and those of
/// its files that the new set has not, but for the environment itself.
void removeOlderSet(const BakedFiles& files, const std::vector<std::string>& inputs);

}  // namespace mirrorball::cli
