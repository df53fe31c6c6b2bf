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
#include "mirrorball/view/viewer/file_watch.h"
#include "mirrorball/view/viewer/viewer_status.h"
#include "mirrorball/view/workspace/asked_map.h"
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

  /// Has those made again whose files have changed; until they are, the ones before are shown.
  void askDisk();

  /// In the workspace's order; empty: it has but one panorama.
  std::vector<MapThumbnail> of(const Workspace& workspace) const;

 private:
  /// A map, and whether it is a photograph: one that is unwrapped otherwise looks much the same in small.
  using Key = std::pair<std::string, bool>;
  static Key keyOf(const Workspace& workspace, const std::string& map);

  struct Thumbnail {
    std::optional<gl::Framebuffer> picture;  // nothing: it cannot be loaded
    AskedMap asked;                          // of which it was made
    FileWatch watch = {};
    bool is_stale = false;
  };
  struct OnDevice {
    Device device;                             // outlives all else
    std::map<Key, Thumbnail> thumbnails = {};  // and those that are made
  };
  /// Whether there is nothing to make of a map: what failed is tried again when it is asked for otherwise.
  bool isMade(const Workspace& workspace, const std::string& map) const;
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  BackgroundTask<Image8> making_;
  Key making_key_;
};

}  // namespace mirrorball
