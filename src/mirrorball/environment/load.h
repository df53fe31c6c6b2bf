#pragma once

#include <optional>
#include <string>

#include "mirrorball/environment/environment.h"
#include "mirrorball/environment/recognize.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// How to read an environment.
struct EnvironmentLoadOptions {
  FormHint from = {};     ///< overrides what is recognised
  bool repair = false;    ///< replace NaN and infinite texels by their neighbours' mean
  bool keep_bad = false;  ///< leave them as they are: for `info`, which only counts them
};

/// An environment and what is known about where it came from.
struct LoadedEnvironment {
  Environment environment;
  std::string name;                        ///< the path, or the built-in's name
  std::string format;                      ///< the file's; "built in"
  std::string color;                       ///< the file's, and what was done about it: DecodedImage::color
  std::optional<Recognition> recognition;  ///< of a file
  glm::ivec2 file_size{0};                 ///< of the picture in the file (of one face where each has its own)
  NonFinite bad_texels;                    ///< as found, before any repair
  std::vector<std::string> files = {};     ///< that were read
};

/// Loads a built-in by its name (builtin.h), else a file (.hdr .exr .png .jpg; LDR as sRGB unless it states another
/// curve). A name that ends in _px, _nx, … _nz stands for the six files of a cube.
///
/// errors   not_found (lists the built-ins); bad_shape; non_finite (count and first texel; --repair mends it);
///          whatever the codec finds
Result<LoadedEnvironment> loadEnvironment(const std::string& name_or_path, const EnvironmentLoadOptions& options = {});

}  // namespace mirrorball
