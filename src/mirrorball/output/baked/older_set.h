#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/output/baked/baked_files.h"

namespace mirrorball {

/// A manifest as the bytes of its file.
std::string manifestText(const nlohmann::ordered_json& manifest);

/// What a folder holds already, as its manifest states.
class OlderSet {
 public:
  /// Reads an older set's manifest. Where the new set has some parts only, the others remain; its tables, which depend
  /// on no light, remain beside any.
  ///
  /// settings     of the new set
  /// light_hash   of the new set's light (lightHash)
  /// returns      nothing known of a folder whose manifest is missing, or cannot be read and is replaced
  /// errors       of some parts only. usage: the parts that remain show another light, or have their faces arranged in
  ///              another way; an older program's, which has no hash of its light, counts as another light.
  ///              As readFile's, bad_file: it is not known which parts there are
  static Result<OlderSet> find(const BakedFiles& files, const BakedSetSettings& settings,
                               const std::string& light_hash);

  /// Writes a manifest of what remains, or removes that of a set of which nothing does, since it would describe other
  /// maps than those that now take their places; then removes the other files that the older manifest names and the new
  /// set has not. If writing ends early, the manifest describes what remains.
  ///
  /// inputs   the environment's files, which stay
  /// errors   io
  Result<void> makeWay(const BakedFiles& files, const std::vector<std::string>& inputs) const;

  /// A manifest of what remains; an empty object where nothing does.
  const nlohmann::ordered_json& remains() const { return remains_; }

 private:
  nlohmann::ordered_json remains_ = nlohmann::ordered_json::object();
  std::vector<std::string> names_;  // of all files of its manifest
};

}  // namespace mirrorball
