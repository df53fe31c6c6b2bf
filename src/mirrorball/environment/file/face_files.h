#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// How the six files of a cube are told apart: what their names end in. docs/conventions.md has the table, with the
/// source of each row.
enum class FaceNaming {
  px,
  posx,
  pos_x,
  xpos,
  x_pos,
  positive_x,
  positive_x_hyphen,
  positivex,
  signs,
  signs_behind,
  top,
  up,
  forward,
  forward_backward,
  forward_top,
  quake,
  ogre,
  unity,
  unity_cameras,
  unity_textures,
  c00,
  face0,
  letters,
  from_0,
  from_1,
  from_00,
  from_0000,
};

/// What the names end in, in the order of the slots +X −X +Y −Y +Z −Z: "px nx py ny pz nz".
const std::array<std::string_view, 6>& endingsOf(FaceNaming naming);

/// "px nx py ny pz nz"
std::string textOf(FaceNaming naming);

/// How the images of files so named lie, as `formHintNamed` reads it: "faces:for=quake"; "faces" by OpenGL's table.
std::string usualReading(FaceNaming naming);

/// Whether many other files end so: single letters, and numbers. Such six are a cube only if their edges meet.
bool isCommon(FaceNaming naming);

/// Which of the six is the lower one.
inline constexpr std::size_t kBottomFace = 3;

/// The six files of a cube, in the order of the slots.
struct FaceFiles {
  std::array<std::filesystem::path, 6> paths;
  FaceNaming naming = FaceNaming::px;
  int present = 0;  ///< how many of them exist
};

/// The six files that a path to one of them stands for. Its name is one of a naming's endings, or has the ending after
/// one of the characters "_-. ", in small or capital letters. The signs, and where most of the six exist Quake's
/// endings, need nothing before them. If several namings fit, as for "right", the one of which most files exist is
/// taken.
///
/// returns  nothing when the name ends in none, or in a common one without the other five
std::optional<FaceFiles> faceFilesBeside(const std::filesystem::path& file);

/// Whether the file of the lower face is missing and the other five are there, as of skies for programs which hide it
/// behind their ground. Not of common endings.
bool lacksBottomAlone(const FaceFiles& files);

/// The names of those of the six that exist, or do not: "room_py.exr and room_nz.exr".
///
/// but      a path that is left out
std::string listFaces(const FaceFiles& files, bool exist, const std::filesystem::path& but = {});

/// The six files of the one cube in a folder.
///
/// errors   not_found: there are not six, nor all but the lower one; usage: there are several cubes, and one of their
///          files has to be named
Result<FaceFiles> faceFilesIn(const std::filesystem::path& folder);

}  // namespace mirrorball
