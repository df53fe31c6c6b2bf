#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/photo/ball_view.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/control/event.h"
#include "mirrorball/view/map/map_layout.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// What a workspace is to become, as History::change takes it.
struct Change {
  std::string name;
  Workspace next;
  bool goes_on = false;
};

/// A photograph beside the map that it was unwrapped to, and the ball in it.
struct ShownBall {
  BallView view;          ///< in pixels of the photograph
  PixelRectangle place;   ///< of the photograph in the picture
  glm::ivec2 size_px{1};  ///< of the photograph

  /// Where a pixel of the photograph is seen, and the other way.
  glm::vec2 placeOf(glm::dvec2 photograph_px) const {
    return glm::vec2(place.corner) + glm::vec2(photograph_px) * scale();
  }
  glm::dvec2 photographPixel(glm::vec2 place_px) const { return (place_px - glm::vec2(place.corner)) / scale(); }

 private:
  glm::vec2 scale() const { return glm::vec2(place.extent) / glm::vec2(size_px); }
};

/// What hands must know of the picture that they move.
struct ShownPicture {
  CameraOptions camera = {};  ///< placedCamera()
  BoundingSphere bounds = {};
  glm::ivec2 size_px{1};
  glm::vec3 env_rotation_deg{0.0f};
  std::optional<ShownBall> ball = {};
};

/// The picture of a map alone, and of a photograph beside it.
MapCanvas mapCanvas(glm::ivec2 size_px, glm::ivec2 photograph_px = glm::ivec2(0));

/// What a hand does, for pages of help.
struct GestureText {
  std::string_view hand;  ///< "Shift and right button"
  std::string_view does;
};
std::span<const GestureText> gestureTexts();

/// What pointer and keys do to a workspace while they are held: gestureTexts().
class Gesture {
 public:
  /// returns  what the event changes; nothing: it changes nothing here
  std::optional<Change> handle(const Event& event, const Workspace& now, const ShownPicture& shown);

  /// What keys that are held change as time goes on.
  std::optional<Change> advance(double seconds, const Workspace& now, const ShownPicture& shown) const;

  /// Whether `handle` needs to know what is shown; else any ShownPicture does.
  bool asksForPicture(const Event& event, const Workspace& now) const;

  /// Where the left button was pressed and let go without a move since it was last asked [pixels].
  std::optional<glm::vec2> takeClick() { return std::exchange(click_px_, std::nullopt); }

  /// Whether a key is held that flies, so that `advance` has something to do.
  bool isFlying() const { return !flying_.empty(); }
  /// Whether something is held that moves the picture.
  bool isGoingOn() const { return held_.has_value() || !flying_.empty(); }

 private:
  enum class Kind { orbit, pan, look_around, approach, turn_light, divide, move_ball, resize_ball, nothing };
  struct Held {
    PointerButton button;
    Kind kind;
    glm::vec2 place_px;
    glm::vec2 begin_px;
    bool has_moved = false;
  };
  static Kind kindOf(const PointerPressed& pressed, const Workspace& now, const ShownPicture& shown);
  static Kind kindOverMap(const PointerPressed& pressed, const std::optional<ShownBall>& ball);
  std::optional<Change> handleMap(const Event& event, const Workspace& now, const ShownPicture& shown);
  std::optional<Change> dragBall(glm::vec2 from_px, glm::vec2 to_px, const Workspace& now, const ShownBall& ball) const;
  std::optional<Change> drag(glm::vec2 to_px, const Workspace& now, const ShownPicture& shown);

  std::optional<Held> held_;
  std::optional<glm::vec2> click_px_;
  std::set<std::string, std::less<>> flying_;  ///< keys
};

}  // namespace mirrorball
