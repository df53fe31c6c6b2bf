#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

// What a window or a page tells a viewer. Places are pixels of the picture, from its top left corner.

enum class PointerButton { left, middle, right };

/// Keys that are held beside another, or beside a button.
struct Modifiers {
  bool control = false;
  bool shift = false;
  bool alt = false;

  bool operator==(const Modifiers&) const = default;
};

struct PointerPressed {
  PointerButton button = PointerButton::left;
  glm::vec2 place_px{0.0f};
  Modifiers held = {};
};
struct PointerMoved {
  glm::vec2 place_px{0.0f};
};
struct PointerReleased {
  PointerButton button = PointerButton::left;
};
/// By a wheel or two fingers.
struct Scrolled {
  float notches = 0.0f;  ///< of a wheel; above 0 away from the hand
  glm::vec2 place_px{0.0f};
};
/// A key by the name that stands on it: "W", "[", "Home".
struct KeyPressed {
  std::string key;
  Modifiers held = {};
};
struct KeyReleased {
  std::string key;
};
/// The picture's size has changed.
struct Resized {
  glm::ivec2 size_px{0};
};
/// The window lost the keyboard or the pointer: nothing is held any more.
struct FocusLost {};

using Event =
    std::variant<PointerPressed, PointerMoved, PointerReleased, Scrolled, KeyPressed, KeyReleased, Resized, FocusLost>;

/// "Ctrl+Shift+Z"
std::string chordOf(const KeyPressed& pressed);
/// The same the other way: what stands before the key is held.
KeyPressed pressedOf(std::string_view chord);

}  // namespace mirrorball
