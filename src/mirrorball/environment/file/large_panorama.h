#pragma once

#include "mirrorball/environment/file/load.h"

namespace mirrorball {

/// Opens a panorama that takes so much memory as a whole, 512 MB or half of memoryLimit(), that it is worth to be read
/// by rows: decoding and converting then follow each other. What is missing of its file is known, and its light was
/// looked at in a coarse picture.
///
/// returns  nothing if it is smaller, or must be loaded as a whole (openPanorama)
/// errors   as loadEnvironment's
/// cost     decodes 128 rows; of Radiance HDR reads the whole file
Result<std::optional<PanoramaRows>> openLargePanorama(const std::string& name_or_path,
                                                      const EnvironmentLoadOptions& options = {});

}  // namespace mirrorball
