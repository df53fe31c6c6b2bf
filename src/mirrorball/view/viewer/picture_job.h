#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// A picture file that is to be made of one half of a workspace, or several of a full turn of the camera or of an
/// animation.
struct PictureRequest {
  std::string path;  ///< as `render --output` takes it
  glm::ivec2 size_px{1280, 720};
  int frames = 0;      ///< several, numbered as numberedPaths does; 0: one picture
  bool plays = false;  ///< several go over the length of the animation that is chosen; else they make a full turn
  std::size_t side = 0;
};

/// Makes it as `render` does, with a driver of its own, in any thread; of a workspace that shows the map alone, that.
///
/// inside_only  ModelLoadOptions'
/// returns      what was written: "a.png", "a_000.png … a_089.png"
/// errors       usage (what the extension cannot hold, several traced pictures); as `render` has them; interrupted
/// cost         that of `render`
Result<std::string> makePicture(const Workspace& workspace, const PictureRequest& request, bool inside_only,
                                const std::optional<CacheFolder>& cache, const ProgressFunction& progress);

}  // namespace mirrorball
