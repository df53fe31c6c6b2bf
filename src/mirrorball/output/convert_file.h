#pragma once

#include <optional>
#include <string>

#include "mirrorball/base/observer.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/compass_heading.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/output/map_file.h"
#include "mirrorball/output/save_map.h"

namespace mirrorball {

/// What becomes of a map on its way from file to file.
struct FileConversion {
  std::optional<Projection> to = {};  ///< nothing: the input's own, and a cube's layout too where `file` has none
  int size = 0;                       ///< as convert's; 0: what keeps the input's detail
  Resampling resampling = {};
  EnvironmentLoadOptions load = {};
  MapFileOptions file = {};
  std::optional<CompassHeading> marked_north = {};  ///< of a panorama: draw a mark where its north is (drawNorth)
};

/// How a map is written in the form that it was read in: with its own layout of a cube, where the options leave that
/// open and the file can have it.
///
/// path     of the output
MapFileOptions keepingLayout(const LoadedEnvironment& loaded, const std::string& path, MapFileOptions options);

/// Refuses, before anything is read, what can be refused by then.
///
/// errors   usage
Result<void> checkConversion(const std::string& input, const std::string& output, const FileConversion& conversion);

/// Converts a map from file to file: what loadEnvironment, convert and saveMap do, in less memory. A large panorama is
/// read by rows, a texture is written while it is converted, and texels (of a texture the mip levels, too) that need
/// not change are copied.
///
/// input    a file, or a built-in environment
/// output   one file, or the name from which a cube's six are named
/// errors   as loadEnvironment's, convert's and saveMap's; usage: the output is the input; bad_shape: north is to be
///          marked, and the map is not a panorama
/// cost     docs/performance.md; bit-identical for any number of threads
Result<SavedMap> convertFile(const std::string& input, const std::string& output, const FileConversion& conversion = {},
                             const Observer& observer = {});

}  // namespace mirrorball
