#pragma once

#include <optional>
#include <string>

#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball {

/// Loads the six files of a cube.
///
/// name     that of one of them, or of their folder
/// errors   as loadEnvironment's
Result<LoadedEnvironment> loadFaces(const std::string& name, const FaceFiles& files,
                                    const EnvironmentLoadOptions& options);

/// The cube of which a file is one face.
///
/// returns  nothing where it is none, or the six are only named alike
/// errors   as loadFaces'; not_found: others are missing
Result<std::optional<LoadedEnvironment>> loadCubeAround(const std::string& path, const EnvironmentLoadOptions& options);

/// Remarks that a square picture which was loaded has the name of a face, without the others or without a sign that
/// they are a cube.
void remarkOtherFaces(const std::string& path, LoadedEnvironment& loaded);

}  // namespace mirrorball
