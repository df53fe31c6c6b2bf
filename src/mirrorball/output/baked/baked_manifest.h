#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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

/// What stays of an older set in a folder.
class OlderSet {
 public:
  /// Removes an older set's manifest, which would describe other maps than those that now take their places, and those
  /// of its files that the new set has not, but for the environment itself. A new set of some parts leaves the others
  /// of a set that was made from the same environment, turned and arranged in the same way, with its lamps in it.
  ///
  /// settings  of the new set, with its source
  /// inputs    the environment's files
  static OlderSet takeFrom(const BakedFiles& files, const BakedSetSettings& settings,
                           const std::vector<std::string>& inputs);

  /// What its manifest has of the parts that stay.
  const nlohmann::ordered_json& parts() const { return parts_; }

 private:
  nlohmann::ordered_json parts_ = nlohmann::ordered_json::object();
};

/// manifest.json: what is what in a set.
std::string makeManifest(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings,
                       const OlderSet& older);

}  // namespace mirrorball
