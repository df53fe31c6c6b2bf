#include "mirrorball/view/control/gesture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mirrorball/photo/find_ball.h"
#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/control/light_control.h"
#include "mirrorball/view/map/map_hand.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

constexpr float kNearerForNotch = 0.9f;  // of the distance
constexpr float kFlown = 1.0f;           // model radii a second

struct FlyingKey {
  std::string_view key;
  glm::vec3 by;  // to the right, up and ahead
};
constexpr std::array<FlyingKey, 6> kFlyingKeys{FlyingKey{"W", {0, 0, 1}},  FlyingKey{"S", {0, 0, -1}},
                                               FlyingKey{"A", {-1, 0, 0}}, FlyingKey{"D", {1, 0, 0}},
                                               FlyingKey{"E", {0, 1, 0}},  FlyingKey{"Q", {0, -1, 0}}};

// A hand that clicks may tremble so far, and a line is met so far from it [pixels].
constexpr float kTremble_px = 3.0f;
constexpr float kOfLine_px = 8.0f;

bool isFlyingKey(std::string_view key) {
  return std::any_of(kFlyingKeys.begin(), kFlyingKeys.end(), [&](const FlyingKey& each) { return each.key == key; });
}

Change cameraChange(std::string name, const Workspace& now, const CameraOptions& camera) {
  return {std::move(name), withCamera(now, camera), true};
}

constexpr auto kTexts = std::to_array<GestureText>({
    {"left button", "goes round the model; a click selects the material that it meets"},
    {"Shift and left button, or the middle one", "shifts the picture: what is under the pointer stays there"},
    {"Ctrl and left button", "looks around from where the camera stands"},
    {"left button on the line of a comparison", "moves the line"},
    {"left button on the circle of a ball, beside its map", "moves it; near its rim it becomes larger or smaller"},
    {"wheel", "comes nearer to what is under the pointer"},
    {"right button", "comes nearer"},
    {"Shift and right button", "turns the light"},
    {"W A S D, E Q", "fly ahead, to the left, back and to the right, up and down"},
});

}  // namespace

std::span<const GestureText> gestureTexts() { return kTexts; }

std::string chordOf(const KeyPressed& pressed) {
  return std::string(pressed.held.control ? "Ctrl+" : "") + (pressed.held.alt ? "Alt+" : "") +
         (pressed.held.shift ? "Shift+" : "") + pressed.key;
}

KeyPressed pressedOf(std::string_view chord) {
  KeyPressed pressed;
  const auto takes = [&](std::string_view held) {
    if (!chord.starts_with(held)) return false;
    chord.remove_prefix(held.size());
    return true;
  };
  pressed.held.control = takes("Ctrl+");
  pressed.held.alt = takes("Alt+");
  pressed.held.shift = takes("Shift+");
  pressed.key = chord;
  return pressed;
}

Gesture::Kind Gesture::kindOf(const PointerPressed& pressed, const Workspace& now, const ShownPicture& shown) {
  if (now.shows_map) return kindOverMap(pressed, shown.ball);
  switch (pressed.button) {
    case PointerButton::middle:
      return Kind::pan;
    case PointerButton::right:
      return pressed.held.shift ? Kind::turn_light : Kind::approach;
    case PointerButton::left:
      break;
  }
  if (pressed.held.shift) return Kind::pan;
  const float line_px = now.divider * static_cast<float>(shown.size_px.x);
  if (now.compare_by == CompareBy::slider && std::abs(pressed.place_px.x - line_px) <= kOfLine_px) return Kind::divide;
  return pressed.held.control ? Kind::look_around : Kind::orbit;
}

std::optional<Change> Gesture::drag(glm::vec2 to_px, const Workspace& now, const ShownPicture& shown) {
  held_->has_moved = held_->has_moved || glm::distance(to_px, held_->begin_px) > kTremble_px;
  // Else a click would turn the model a little.
  if (!held_->has_moved) return std::nullopt;
  const glm::vec2 by_px = to_px - std::exchange(held_->place_px, to_px);
  const CameraOptions& camera = shown.camera;
  switch (held_->kind) {
    case Kind::orbit:
      return cameraChange("Turn", now, orbited(camera, by_px, shown.size_px));
    case Kind::pan:
      return cameraChange("Shift", now, panned(camera, shown.bounds, by_px, shown.size_px));
    case Kind::look_around:
      return cameraChange("Look around", now, lookedAround(camera, shown.bounds, by_px, shown.size_px));
    case Kind::approach: {
      // The picture's height is as much as 32 notches of the wheel.
      const float notches = -32.0f * by_px.y / static_cast<float>(std::max(shown.size_px.y, 1));
      const glm::vec2 middle = 0.5f * glm::vec2(shown.size_px);
      return cameraChange("Zoom", now,
                          zoomed(camera, shown.bounds, std::pow(kNearerForNotch, notches), middle, shown.size_px));
    }
    case Kind::divide: {
      Workspace next = now;
      next.divider = std::clamp(to_px.x / static_cast<float>(std::max(shown.size_px.x, 1)), 0.0f, 1.0f);
      return Change{"Move the line", std::move(next), true};
    }
    case Kind::turn_light:
      return Change{"Turn the light", withLightTurned(now, turnedLight(shown.env_rotation_deg, by_px, shown.size_px)),
                    true};
    case Kind::move_ball:
    case Kind::resize_ball:
    case Kind::nothing:
      break;  // of the map alone, which is left
  }
  return std::nullopt;
}

MapCanvas mapCanvas(glm::ivec2 size_px, glm::ivec2 photograph_px) {
  return {.size_px = size_px, .photograph_px = photograph_px};
}

/// Near its rim a ball becomes larger or smaller, within it moves; all else is of the map.
Gesture::Kind Gesture::kindOverMap(const PointerPressed& pressed, const std::optional<ShownBall>& ball) {
  if (!ball || !ball->place.holds(pressed.place_px)) return Kind::look_around;
  const Circle circle = circleInPicture(ball->view);
  const float radius_px = glm::distance(ball->placeOf(circle.center_px + glm::dvec2(circle.radius_px, 0.0)),
                                        ball->placeOf(circle.center_px));
  const float outside_px = glm::distance(ball->placeOf(circle.center_px), pressed.place_px) - radius_px;
  if (pressed.button != PointerButton::left || outside_px > kOfLine_px) return Kind::nothing;
  // Of a small ball the middle moves it still.
  return outside_px > -std::min(kOfLine_px, 0.5f * radius_px) ? Kind::resize_ball : Kind::move_ball;
}

/// The ball is to stay in the photograph, and to be seen.
std::optional<Change> Gesture::dragBall(glm::vec2 from_px, glm::vec2 to_px, const Workspace& now,
                                        const ShownBall& ball) const {
  constexpr double kSmallest_px = 3.0;
  const glm::dvec2 from = ball.photographPixel(from_px), to = ball.photographPixel(to_px);
  Circle circle = circleInPicture(ball.view);
  if (held_->kind == Kind::resize_ball) {
    const double by = glm::distance(to, circle.center_px) - glm::distance(from, circle.center_px);
    circle.radius_px = std::max(circle.radius_px + by, kSmallest_px);
    return Change{"Resize the ball's circle", withBallCircle(now, circle), true};
  }
  circle.center_px = glm::clamp(circle.center_px + to - from, glm::dvec2(0.0), glm::dvec2(ball.size_px));
  return Change{"Move the ball's circle", withBallCircle(now, circle), true};
}

/// Of a map alone one looks around from inside.
std::optional<Change> Gesture::handleMap(const Event& event, const Workspace& now, const ShownPicture& shown) {
  const auto settings = mapViewOf(now);
  if (!settings) return std::nullopt;
  const MapCanvas canvas = mapCanvas(shown.size_px, shown.ball ? shown.ball->size_px : glm::ivec2(0));
  if (const auto* moved = std::get_if<PointerMoved>(&event); moved && held_) {
    const glm::vec2 from_px = std::exchange(held_->place_px, moved->place_px);
    if (held_->kind == Kind::nothing) return std::nullopt;
    if (held_->kind == Kind::move_ball || held_->kind == Kind::resize_ball)
      return shown.ball ? dragBall(from_px, moved->place_px, now, *shown.ball) : std::nullopt;
    return Change{"Look around in the map", withMapView(now, dragged(*settings, canvas, from_px, moved->place_px)),
                  true};
  }
  if (const auto* scrolled = std::get_if<Scrolled>(&event)) {
    if (shown.ball && shown.ball->place.holds(scrolled->place_px)) return std::nullopt;
    const float factor = std::pow(kNearerForNotch, scrolled->notches);
    return Change{"Zoom in the map", withMapView(now, zoomed(*settings, canvas, factor, scrolled->place_px)), true};
  }
  return std::nullopt;
}

bool Gesture::asksForPicture(const Event& event, const Workspace& now) const {
  if ((now.compare_by == CompareBy::slider || now.shows_map) && std::holds_alternative<PointerPressed>(event))
    return true;
  return std::holds_alternative<Scrolled>(event) || (held_ && std::holds_alternative<PointerMoved>(event));
}

std::optional<Change> Gesture::handle(const Event& event, const Workspace& now, const ShownPicture& shown) {
  const bool is_of_map = std::holds_alternative<PointerMoved>(event) || std::holds_alternative<Scrolled>(event);
  if (now.shows_map && is_of_map) return handleMap(event, now, shown);
  if (const auto* pressed = std::get_if<PointerPressed>(&event)) {
    if (!held_) held_ = Held{pressed->button, kindOf(*pressed, now, shown), pressed->place_px, pressed->place_px};
  } else if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    if (held_) return drag(moved->place_px, now, shown);
  } else if (const auto* released = std::get_if<PointerReleased>(&event)) {
    if (!held_ || held_->button != released->button) return std::nullopt;
    if (held_->kind == Kind::orbit && !held_->has_moved) click_px_ = held_->begin_px;
    held_.reset();
  } else if (const auto* scrolled = std::get_if<Scrolled>(&event)) {
    return cameraChange("Zoom", now,
                        zoomed(shown.camera, shown.bounds, std::pow(kNearerForNotch, scrolled->notches),
                               scrolled->place_px, shown.size_px));
  } else if (const auto* key = std::get_if<KeyPressed>(&event)) {
    if (isFlyingKey(key->key) && !key->held.control && !key->held.alt) flying_.insert(key->key);
  } else if (const auto* up = std::get_if<KeyReleased>(&event)) {
    flying_.erase(up->key);
  } else if (std::holds_alternative<FocusLost>(event)) {
    held_.reset();
    flying_.clear();
  }
  return std::nullopt;
}

std::optional<Change> Gesture::advance(double seconds, const Workspace& now, const ShownPicture& shown) const {
  glm::vec3 by(0.0f);
  for (const FlyingKey& each : kFlyingKeys)
    if (flying_.contains(each.key)) by += each.by;
  if (by == glm::vec3(0.0f) || !(seconds > 0.0)) return std::nullopt;
  return cameraChange("Fly", now, flown(shown.camera, shown.bounds, kFlown * static_cast<float>(seconds) * by));
}

}  // namespace mirrorball
