#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"

namespace mirrorball {

/// Finds the files that an OBJ, a .mtl or a PLY names, also where a name fits the disk of another machine alone.
class NamedFiles {
 public:
  /// model   the model's own file, of whose folder `files` is
  NamedFiles(const std::filesystem::path& model, ModelFiles& files) : folder_(model.parent_path()), files_(files) {}

  struct Found {
    std::span<const std::uint8_t> bytes;  ///< live as long as the ModelFiles
    std::string path;                     ///< from the model's folder
  };

  /// The content of the first of some readings of a name that is a file. Of each are tried: the name with '/' for '\';
  /// the same in capital and small letters, whichever the folder has; the name without its folders, beside the model.
  /// What is found otherwise than it is spelled is remarked on, once a file.
  ///
  /// readings   at least one; the first is what an error calls it
  /// size       how long it is to be, where that is known [bytes]: one of that size is not taken for an archive,
  ///            whatever numbers it begins with
  /// errors     as ModelFiles::find's of the first reading, and its read's: "'a.mtl' is missing; put it beside the
  ///            model"; unsupported: what stands in its place, as a Git LFS pointer, with what helps
  Result<Found> read(std::span<const std::string> readings, std::optional<std::size_t> size = {});

  ModelFiles& files() { return files_; }

  /// "'C:\x\Wood.PNG' is read from 'wood.png' in the model's folder". One a file.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  Result<std::filesystem::path> findReading(const std::string& name, std::string& path);
  /// The name as the disk spells it; empty: there is none.
  std::string spelledOnDisk(const std::string& name);

  using Names = std::map<std::string, std::string>;  // as they are, by their small letters

  std::filesystem::path folder_;
  ModelFiles& files_;
  std::map<std::filesystem::path, Names> listings_;
  std::set<std::string> told_;  // paths that a remark is on
  std::vector<std::string> remarks_;
};

/// What a line names: the whole of it; without its quotes; up to a " #".
std::vector<std::string> readingsOfName(std::string_view line);

}  // namespace mirrorball
