#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/photo/ball_view.h"
#include "mirrorball/view/map/prepared_map.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {

/// A photograph, and the ball in it whose light is a map.
struct PhotographedBall {
  std::shared_ptr<const Image> light;  ///< of the photograph, linear; in small where that is large
  glm::ivec2 size_px{0};               ///< of the photograph itself
  Exif exif = {};
  BallView view;  ///< in its pixels
};

/// A map of all directions, be it of a file that holds one or unwrapped from a photograph.
struct LoadedMap {
  LoadedEnvironment loaded;
  std::optional<PhotographedBall> ball = {};
  std::string remark = {};  ///< what is doubtful about the ball, one line; empty: nothing
};

struct MapLoadOptions {
  EnvironmentLoadOptions environment = {};  ///< of what is no photograph
  /// Takes a circle in the middle of a photograph in which no ball is found, from where a hand can move it.
  bool suggests_circle = false;
};

/// Loads a map. This is the only way by which a viewer does: so a photograph is a map wherever one is shown or written.
///
/// errors   as loadEnvironment's; of a photograph as readBallLight's, ballIn's and unwrapBall's; interrupted
/// cost     of a photograph that of `mirrorball photo`: some 0.3 s to find the ball, and the panorama's texels
Result<LoadedMap> loadMap(const AskedMap& source, const MapLoadOptions& options = {},
                          const ProgressFunction& progress = {});

/// A map to be looked at, with all that is found of it.
struct ViewedMap {
  PreparedMap map;  ///< with the photograph
  std::optional<PhotographedBall> ball = {};
  std::string remark = {};  ///< LoadedMap's
};

/// Loads and prepares it, with bad texels as they are, and with a suggested circle where no ball is found.
///
/// errors   as loadMap's and prepareMap's
Result<ViewedMap> viewedMap(const AskedMap& source, const std::optional<CacheFolder>& cache,
                            const ProgressFunction& progress);

}  // namespace mirrorball
