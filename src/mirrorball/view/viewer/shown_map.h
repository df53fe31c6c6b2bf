#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/map/map_picture.h"
#include "mirrorball/view/viewer/file_watch.h"
#include "mirrorball/view/viewer/loading.h"
#include "mirrorball/view/viewer/under_pointer.h"

namespace mirrorball {

/// A panorama without a model: loaded and drawn beside its owner; until another picture is there, the one before is
/// shown.
class ShownMap {
 public:
  explicit ShownMap(const Device& device);

  /// Begins to load a map, and takes what was loaded.
  void follow(const AskedMap& map, const std::optional<CacheFolder>& cache);
  /// Loads it again if a file of it has changed, when it is next asked for.
  void askDisk() {
    if (watch_.hasChanged()) loading_.forget();
  }

  /// Begins to draw what is wanted, and takes what was drawn.
  ///
  /// returns  whether there is another picture than before
  /// errors   no_gl; all else is told by problem()
  Result<bool> draw(const MapViewSettings& settings, const MapCanvas& canvas);
  bool isDone(const AskedMap& map, const MapViewSettings& settings, const MapCanvas& canvas) const;

  /// The last one; null: there is none.
  const gl::Framebuffer* picture() const { return on_->picture ? &*on_->picture : nullptr; }
  /// What is known of a pixel, and of the whole map.
  std::vector<InspectionRow> factsAt(const MapViewSettings& settings, const MapCanvas& canvas,
                                     std::optional<glm::vec2> pixel) const;

  /// The panorama, the cross and the sphere map in small, of the display that is wanted, with a path's end in them.
  ///
  /// errors   no_gl; too_large
  Result<void> makeSmall(const Display& display);
  std::vector<MarkedPicture> marked(glm::vec3 direction, std::span<const glm::vec3> outline, glm::vec3 color) const;

  /// The photograph that the map which is there was unwrapped from; null: from none.
  const PhotographedBall* ball() const { return ball_ ? &*ball_ : nullptr; }
  /// What that map was asked for by.
  const AskedMap& asked() const { return asked_; }
  /// What is doubtful about it: LoadedMap's.
  const std::string& remark() const { return remark_; }

  const LoadingByName<ViewedMap, AskedMap>& loading() const { return loading_; }
  bool isDrawing() const { return drawing_.isRunning(); }
  const std::string& problem() const { return loading_.problem().empty() ? problem_ : loading_.problem(); }

 private:
  /// Pictures of one map, one after the other.
  struct Maker {
    explicit Maker(PreparedMap map) : viewer(std::move(map)) {}
    std::mutex mutex;  // a drawing that was told to stop may go on for a moment
    MapViewer viewer;
  };
  /// A small picture of one projection.
  struct Small {
    MapViewSettings settings;
    MapCanvas canvas;
    PixelRectangle place;  // of the map in it
    std::optional<gl::Framebuffer> picture = {};
  };
  Result<void> keep(Image8 picture);

  struct OnDevice {
    Device device;  // outlives all else
    std::optional<gl::Framebuffer> picture = {};
    std::array<Small, 3> small = {};
  };
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  LoadingByName<ViewedMap, AskedMap> loading_;
  FileWatch watch_;
  std::shared_ptr<Maker> maker_;
  BackgroundTask<Image8> drawing_;
  std::optional<MapViewSettings> begun_;
  MapCanvas begun_canvas_;
  std::optional<Display> small_display_;
  std::string problem_;
  std::optional<PhotographedBall> ball_;
  AskedMap asked_;
  std::string remark_;
};

}  // namespace mirrorball
