#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/viewer_status.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// The panoramas of a workspace in small, where it has several. They are made beside their owner, one after the other.
class MapThumbnails {
 public:
  explicit MapThumbnails(const Device& device);

  /// Takes what was made, begins with the next, and lets go of what is not asked for any more.
  ///
  /// returns  whether there is another picture than before
  /// errors   no_gl
  Result<bool> follow(const Workspace& workspace);
  bool isDone(const Workspace& workspace) const;

  /// In the workspace's order; empty: it has but one panorama.
  std::vector<MapThumbnail> of(const Workspace& workspace) const;

 private:
  /// A map, and whether it is a photograph: one that is unwrapped otherwise looks much the same in small.
  using Key = std::pair<std::string, bool>;
  static Key keyOf(const Workspace& workspace, const std::string& map);

  struct OnDevice {
    Device device;                                                // outlives all else
    std::map<Key, std::optional<gl::Framebuffer>> pictures = {};  // nothing: it cannot be loaded
  };
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  BackgroundTask<Image8> making_;
  Key made_;  // that is made now
};

}  // namespace mirrorball
