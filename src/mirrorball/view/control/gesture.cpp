#include "mirrorball/view/control/gesture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/control/light_control.h"
#include "mirrorball/view/map/map_hand.h"

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
      break;
  }
  return Change{"Turn the light", withLightTurned(now, turnedLight(shown.env_rotation_deg, by_px, shown.size_px)),
                true};
}

MapCanvas mapCanvas(glm::ivec2 size_px) { return {.size_px = size_px}; }

/// Of a map alone one looks around from inside.
std::optional<Change> Gesture::handleMap(const Event& event, const Workspace& now, glm::ivec2 size_px) {
  const auto settings = mapViewOf(now);
  if (!settings) return std::nullopt;
  const MapCanvas canvas = mapCanvas(size_px);
  if (const auto* moved = std::get_if<PointerMoved>(&event); moved && held_) {
    const glm::vec2 from_px = std::exchange(held_->place_px, moved->place_px);
    return Change{"Look around in the map", withMapView(now, dragged(*settings, canvas, from_px, moved->place_px)),
                  true};
  }
  if (const auto* scrolled = std::get_if<Scrolled>(&event)) {
    const float factor = std::pow(kNearerForNotch, scrolled->notches);
    return Change{"Zoom in the map", withMapView(now, zoomed(*settings, canvas, factor, scrolled->place_px)), true};
  }
  return std::nullopt;
}

bool Gesture::asksForPicture(const Event& event, const Workspace& now) const {
  if (now.compare_by == CompareBy::slider && std::holds_alternative<PointerPressed>(event)) return true;
  return std::holds_alternative<Scrolled>(event) || (held_ && std::holds_alternative<PointerMoved>(event));
}

std::optional<Change> Gesture::handle(const Event& event, const Workspace& now, const ShownPicture& shown) {
  const bool is_of_map = std::holds_alternative<PointerMoved>(event) || std::holds_alternative<Scrolled>(event);
  if (now.shows_map && is_of_map) return handleMap(event, now, shown.size_px);
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
