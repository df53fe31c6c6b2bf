#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/output/map_file.h"

namespace mirrorball {

/// What a cube's files are called, in one folder and without their extension.
struct CubeNames {
  std::string texture;  ///< "specular"
  std::string picture;  ///< before the number of the level, if there are levels, and the face: "m" for m0_px
  bool has_levels = false;
};

/// Where a cube goes with all its levels: one texture, or six pictures of each level.
class CubeFiles {
 public:
  /// options   all but the layout
  /// errors    as MapFile::resolve's
  static Result<CubeFiles> resolve(const MapFileOptions& options, const std::string& folder, const CubeNames& names,
                                   std::string_view extension, int levels, const Observer& observer = {});

  /// One texture of that name.
  static Result<CubeFiles> resolve(const MapFileOptions& options, const std::string& path, const Observer& observer);

  bool isTexture() const { return isTexturePath(paths().front()); }
  std::vector<std::string> paths() const;
  const MapForm& form() const { return outputs_.front().form(); }

  /// The memory that writing level 0 takes beside it.
  std::uint64_t memoryToWrite(int size) const { return outputs_.front().memoryToWrite(size); }

  /// Remarks how to read the cube again, if its file does not say what map it is.
  void remarkOnForm() const { outputs_.front().remarkOnForm(); }

  /// Writes the files.
  ///
  /// facts    that a texture keeps beside its form
  /// go_on    asked before each further level's pictures; its error ends the writing
  /// returns  in which format: "b10g11r11 ufloat", "three channels of half floats"
  /// errors   as writeImageSet's and writeImage's
  Result<std::string> write(ImageSet levels, const Metadata& facts, const std::function<Result<void>()>& go_on) const;

 private:
  std::vector<MapFile> outputs_;  // the texture, or each level's pictures
};

}  // namespace mirrorball
