#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What a BRDF table is of, in the words of the command line.
struct BrdfTableFacts {
  std::string distribution;  ///< "ggx"
  std::string axes;          ///< "linear", "warped"
  int channels = 3;          ///< scale, bias and, of three, the mean for multiple scattering
};

/// Where a BRDF table goes, and how.
struct BrdfFile {
  std::string path;
  TexelFormat format = TexelFormat::half;  ///< of a picture: half or float32
  int zstandard_level = 0;
  BrdfTableFacts facts = {};

  bool isTexture() const { return isTexturePath(path); }
};

/// Writes a table, which says what it is where the format has a place for words: all but .dds.
///
/// errors   as writeImageSet's and writeImage's
Result<void> writeBrdf(Image table, const BrdfFile& file);

/// A BRDF table that was found in a file.
struct FoundBrdfTable {
  BrdfTableFacts facts;
  std::string format;  ///< the file's
  Image table;
};

/// A BRDF table that bake wrote: by what the file says, or the manifest beside it says of it.
///
/// returns  nothing where it is none, or there is no such file
/// errors   what reading a file finds that says it is one
Result<std::optional<FoundBrdfTable>> brdfTableIn(const std::string& path);

}  // namespace mirrorball
