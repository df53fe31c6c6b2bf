#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/control/gesture.h"
#include "mirrorball/view/viewer/animation_player.h"
#include "mirrorball/view/viewer/compared_sides.h"
#include "mirrorball/view/viewer/composition.h"
#include "mirrorball/view/viewer/drawn_side.h"
#include "mirrorball/view/viewer/lit_stage.h"
#include "mirrorball/view/viewer/map_thumbnails.h"
#include "mirrorball/view/viewer/pointer_inspector.h"
#include "mirrorball/view/viewer/shown_map.h"
#include "mirrorball/view/viewer/shown_model.h"
#include "mirrorball/view/viewer/traced_side.h"
#include "mirrorball/view/viewer/viewer.h"

namespace mirrorball {

/// How a half is to look.
struct WantedFrame {
  FrameSettings drawn;      ///< by the renderer, with what its quality fills in
  FrameSettings traced;     ///< by paths, as many as its samples say
  std::string chosen = {};  ///< SideStatus'
};

/// A viewer's parts, and what they do in turn.
struct Viewer::State {
  State(const Device& device, Workspace start, glm::ivec2 size, ViewerOptions given);

  const Workspace& now() const { return history.now(); }
  bool isComparing() const { return now().compare_by != CompareBy::none; }
  /// Whether that half is of paths; it is drawn as long as there are none.
  bool isTraced(std::size_t side) const { return mirrorball::isTraced(now(), side); }
  /// Whether something moves, or has a moment ago.
  bool moves() const;
  /// The halves that are seen now, and those that are wanted, too.
  std::vector<std::size_t> seenSides() const;
  std::vector<std::size_t> wantedSides() const;

  // Hands.
  /// Of the half that hands move, without what its quality fills in.
  FrameSettings movedFrame() const;
  /// Stands the model of a half on its ground. The camera holds the shadow wherever the light is turned, and so stays
  /// where it is meanwhile.
  void standInView(FrameSettings& frame, std::size_t side) const;
  ShownPicture shown() const;
  void apply(std::optional<Change> change);
  Result<void> takeClick();

  // The place under the pointer (viewer_pointer.cpp).
  bool needsMap() const { return now().shows_map || now().inspects; }
  /// Of the map alone.
  MapCanvas canvas() const;
  /// The ball in the photograph beside the map, as the workspace has it; nothing: none is shown.
  std::optional<ShownBall> shownBall() const;
  /// Where the map shows what the ball reflects under the pointer.
  std::vector<glm::vec2> seenInMap() const;
  /// The half whose panorama is looked at, alone or around what is inspected.
  std::size_t sideOfMap() const;
  Result<bool> advanceMap();
  Result<void> advanceInspection();
  bool isMapDone() const;
  /// Whether all is there that is asked about the place under the pointer.
  bool isInspectorDone() const;
  UnderPointer underPointer() const;

  /// Shows the next moment of an animation that goes on, once the one before is seen.
  void play(double seconds);
  bool isMomentSeen() const;

  // What is loaded.
  Result<void> follow();
  /// The map of a half as it is to be loaded now: what is said of a photograph may still move under a hand, and is
  /// taken up once it rests.
  ///
  /// asked   for what was asked last
  AskedMap restingMap(std::size_t side, const AskedMap& asked) const;
  void watchPhotos(double seconds);
  /// Loads again what has changed on the disk, which it asks about once a second.
  void askDisk(double seconds);
  LitStage& stageOf(std::size_t side) const;
  /// Whether all is loaded that the workspace asks for, or the status says why not.
  bool isUpToDate() const;

  // What is drawn (viewer_drawing.cpp).
  Result<WantedFrame> wanted(std::size_t side) const;
  Result<bool> advanceModel();
  void takeSaved(double seconds);
  Result<bool> advanceSides();
  Result<bool> advance(std::size_t side);
  Result<bool> draw(std::size_t side);
  /// Of its picture as it is wanted now.
  int samplesOf(std::size_t side) const;
  Result<bool> advanceComparison();
  /// Whether that half shows all that is wanted of it, or the status says why not.
  bool isSideDone(std::size_t side) const;
  /// Whether there is something to be drawn of it now, beside what is found elsewhere.
  bool canGoOn(std::size_t side) const;
  /// Whether both halves have pictures of one size that are to be compared.
  bool canCompare() const;
  const gl::Framebuffer* pictureOf(std::size_t side) const;
  /// What is found of the two halves once both are done; null: nothing yet.
  const gl::Framebuffer* heatMap() const;
  ComparedSides::Version comparedVersion() const;
  void show(const FramebufferPart& part) const;

  // What there is to be said.
  SideStatus statusOf(std::size_t side) const;
  void tellLoading(ViewerStatus& status) const;
  const std::string& problem() const;
  const std::string& remark() const;

  Device device;
  ViewerOptions options;
  History history;
  Gesture gesture = {};
  glm::ivec2 size_px;
  double since_moved_s;
  double since_asked_disk_s = 0.0;
  double since_photos_changed_s = 0.0;  ///< Workspace::photos
  std::map<std::string, GivenTexts> photos_before = {};
  bool has_just_moved = false;               ///< since the last `advance`
  std::optional<glm::vec2> clicked_px = {};  ///< where what is there is still to be found
  ShownModel model = {};
  AnimationPlayer player = {};
  double since_moment_s = 0.0;
  std::array<std::unique_ptr<LitStage>, 2> stages;  ///< of both halves; with one map the first is
  std::array<DrawnSide, 2> drawn;
  std::array<TracedSide, 2> traced;
  ComparedSides compared;
  ShownMap map;
  MapThumbnails thumbnails;
  PointerInspector inspector = {};
  std::optional<glm::vec2> pointer_px = {};
  MapViewSettings map_settings = {};  ///< that are shown; of a text that is refused, those before
  UnderPointer inspected = {};
  BackgroundTask<std::string> saving = {};
  std::string saving_path = {};
  std::string saved_last = {};  ///< ViewerStatus'
  double since_saved_s = 0.0;
  std::array<std::string, 2> problems_of_frames = {};
  std::string problem_of_picking = {};
};

}  // namespace mirrorball
