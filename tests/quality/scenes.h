#pragma once

#include <filesystem>
#include <ostream>
#include <span>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::quality {

/// A scene made by code after the idea of some of Khronos' sample models, and how near to the path-traced truth it is
/// drawn: tone mapped, kSize pixels, kPaths paths a pixel with all of their bounces.
struct SampleScene {
  const char* name;   ///< of its file
  const char* after;  ///< the sample models whose idea it has
  Scene (*make)();
  const char* shown;  ///< options of `render`: environment and camera
  double draft_db;    ///< PSNR by --quality draft
  double good_db;     ///< and by --quality good
};

inline constexpr const char* kSize = "96x72";
inline constexpr int kPaths = 144;

std::span<const SampleScene> sampleScenes();

/// Writes a scene into a folder as NAME.glb.
///
/// returns  the file
/// errors   io
Result<std::filesystem::path> writeScene(const SampleScene& scene, const std::filesystem::path& folder);

/// How GoogleTest shows it.
inline void PrintTo(const SampleScene& scene, std::ostream* out) { *out << scene.name; }

/// What follows `render` and the file of a scene.
///
/// how   "--quality draft", or "--reference"
inline std::string shownBy(const SampleScene& scene, const std::string& how) {
  return std::string(scene.shown) + " --size " + kSize + " " + how;
}

}  // namespace mirrorball::quality
