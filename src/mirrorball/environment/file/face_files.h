#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// How the six files of a cube are told apart: what their names end in.
enum class FaceNaming { px, posx, top, up, signs };

/// What the names end in, in the order of the faces +X −X +Y −Y +Z −Z:
///   px     px nx py ny pz nz
///   posx   posx negx posy negy posz negz
///   top    right left top bottom front back
///   up     right left up down front back
///   signs  +X -X +Y -Y +Z -Z
const std::array<std::string_view, 6>& endingsOf(FaceNaming naming);

/// "px nx py ny pz nz"
std::string textOf(FaceNaming naming);

/// The six files of a cube, in the order of the faces.
struct FaceFiles {
  std::array<std::filesystem::path, 6> paths;
  FaceNaming naming = FaceNaming::px;
  int present = 0;  ///< how many of them exist
};

/// The six files that a path to one of them stands for. Its name is one of a naming's endings, or has the ending after
/// one of the characters "_-. " (the signs need none before them), in small or capital letters. If several namings fit,
/// as for "right", the one of which most files exist is taken.
///
/// returns  nothing when the name ends in none
std::optional<FaceFiles> faceFilesBeside(const std::filesystem::path& file);

/// The six files of the one cube in a folder.
///
/// errors   not_found: there are not six; usage: there are several cubes, and one of their files has to be named
Result<FaceFiles> faceFilesIn(const std::filesystem::path& folder);

}  // namespace mirrorball
