#pragma once

#include <string>
#include <vector>

#include "mirrorball/output/map_file.h"

namespace mirrorball {

/// The result of saving a map.
struct SavedMap {
  std::vector<std::string> paths;  ///< the file, or a cube's six
  std::vector<Remark> remarks;     ///< what the file does not hold of the map
};

/// Writes a map as the file's name says: a picture of light (.exr .hdr), an encoded one (.png .jpg), or a texture
/// (.ktx2 .ktx .dds), in the form that the options ask for. The file says what map it holds, except a .dds.
///
/// path     its folder must be there
/// errors   usage: the options and the file do not go together; io; out_of_range: a format that was asked for does not
///          hold the light; too_large
Result<SavedMap> saveMap(const std::string& path, EnvironmentMap map, const MapFileOptions& options = {},
                         const Observer& observer = {});

/// Writes a cube whose mip levels exist already, such as a prefiltered chain, as a texture.
///
/// levels   six square faces each, in OpenGL's order
/// errors   usage also: no name of a texture
Result<SavedMap> saveMap(const std::string& path, ImageSet levels, const MapFileOptions& options = {},
                         const Observer& observer = {});

}  // namespace mirrorball
