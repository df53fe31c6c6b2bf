#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/animation_choice.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How a model is loaded.
struct ModelLoadOptions {
  /// Refuses the files that the model names outside of its folder, be it by `..` or through a symbolic link: for models
  /// from people who are not to learn what lies there.
  bool inside_only = false;
  AnimationChoice animation = {};  ///< the moment that loadModel shows; none: the model is at rest
  ProgressFunction progress = {};  ///< is told of pictures and meshes, and may stop what reads them

  /// Whether they give the same model.
  bool operator==(const ModelLoadOptions& other) const {
    return inside_only == other.inside_only && animation == other.animation;
  }
};

/// The files that a model's file names: buffers, pictures, tables of materials. Names are paths from the model's
/// folder; what begins at the root of the file system or is an address, and what is no regular file, is refused.
class ModelFiles {
 public:
  /// model    the model's own file
  ModelFiles(const std::filesystem::path& model, const ModelLoadOptions& options);

  /// The file that a name leads to, without links and dots: names that are spelled otherwise and lead to the same file
  /// have the same.
  ///
  /// errors   bad_file, unsupported: how the name's sentence goes on, as in "is missing; put it beside the model"
  Result<std::filesystem::path> find(const std::string& name);

  /// The content of a file of find(), which is read once. It lives as long as this does.
  ///
  /// errors   as readFile's; too_large: the budget has not so much
  Result<std::span<const std::uint8_t>> read(const std::filesystem::path& file);

  /// The memory for all that the model holds: its files, meshes and pictures.
  MemoryBudget& budget() { return budget_; }

  /// Of one half of the work, of two, in hundredths of a half.
  ProgressFunction progressOfHalf(std::size_t half) const { return partOf(options_.progress, 100 * half, 100, 200); }

  /// What was read.
  std::vector<std::string> files() const;

  /// A remark on those that lie outside of the model's folder; empty: none was read.
  std::string remarkOnOutside() const;

 private:
  bool isOutside(const std::filesystem::path& file) const;

  std::string model_;
  std::filesystem::path folder_;       // as it was given
  std::filesystem::path true_folder_;  // without links
  ModelLoadOptions options_;
  std::map<std::filesystem::path, Bytes> contents_;
  MemoryBudget budget_;
};

/// Notes in a scene which files were read for it, and remarks on those outside of the model's folder.
void tellOfFiles(const ModelFiles& files, Scene& scene);

}  // namespace mirrorball
