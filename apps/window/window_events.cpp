#include "window/window_events.h"

#include <array>
#include <cctype>
#include <optional>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace mirrorball::window {
namespace {

struct NamedKey {
  int key;
  const char* name;
};
constexpr std::array<NamedKey, 12> kNamedKeys{{{GLFW_KEY_HOME, "Home"},
                                               {GLFW_KEY_END, "End"},
                                               {GLFW_KEY_TAB, "Tab"},
                                               {GLFW_KEY_ESCAPE, "Escape"},
                                               {GLFW_KEY_ENTER, "Enter"},
                                               {GLFW_KEY_SPACE, "Space"},
                                               {GLFW_KEY_DELETE, "Delete"},
                                               {GLFW_KEY_LEFT, "Left"},
                                               {GLFW_KEY_RIGHT, "Right"},
                                               {GLFW_KEY_UP, "Up"},
                                               {GLFW_KEY_DOWN, "Down"},
                                               {GLFW_KEY_F1, "F1"}}};

/// What stands on a key; empty: it is not known.
std::string nameOfKey(int key, int scancode) {
  for (const NamedKey& each : kNamedKeys)
    if (each.key == key) return each.name;
  const char* printed = glfwGetKeyName(key, scancode);
  std::string name = printed ? printed : "";
  for (char& letter : name) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return name;
}

std::optional<PointerButton> buttonOf(int button) {
  if (button == GLFW_MOUSE_BUTTON_LEFT) return PointerButton::left;
  if (button == GLFW_MOUSE_BUTTON_MIDDLE) return PointerButton::middle;
  if (button == GLFW_MOUSE_BUTTON_RIGHT) return PointerButton::right;
  return std::nullopt;
}

Modifiers heldOf(int mods) {
  return {.control = (mods & GLFW_MOD_CONTROL) != 0,
          .shift = (mods & GLFW_MOD_SHIFT) != 0,
          .alt = (mods & GLFW_MOD_ALT) != 0};
}

glm::vec2 pointerOf(GLFWwindow* window) {
  double x = 0.0, y = 0.0;
  glfwGetCursorPos(window, &x, &y);
  return {static_cast<float>(x), static_cast<float>(y)};
}

// Panels come first.
bool panelsTakePointer() { return ImGui::GetIO().WantCaptureMouse; }
bool panelsTakeKeys() { return ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }

}  // namespace

WindowEvents& WindowEvents::of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

std::vector<Event> WindowEvents::take(glm::vec2 picture_px) {
  for (Event& event : events_)
    std::visit(
        [&](auto& each) {
          if constexpr (requires { each.place_px; }) each.place_px -= picture_px;
        },
        event);
  return std::exchange(events_, {});
}

WindowEvents::WindowEvents(GLFWwindow* window) {
  glfwSetWindowUserPointer(window, this);
  glfwSetMouseButtonCallback(window, [](GLFWwindow* of_window, int button, int action, int mods) {
    const auto pressed = buttonOf(button);
    if (!pressed) return;
    // What is let go over a panel is let go.
    if (action == GLFW_RELEASE) of(of_window).add(PointerReleased{*pressed});
    if (action == GLFW_PRESS && !panelsTakePointer())
      of(of_window).add(PointerPressed{*pressed, pointerOf(of_window), heldOf(mods)});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* of_window, double x, double y) {
    of(of_window).add(PointerMoved{{static_cast<float>(x), static_cast<float>(y)}});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* of_window, double, double notches) {
    if (!panelsTakePointer()) of(of_window).add(Scrolled{static_cast<float>(notches), pointerOf(of_window)});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* of_window, int key, int scancode, int action, int mods) {
    const std::string name = nameOfKey(key, scancode);
    if (name.empty()) return;
    if (action == GLFW_RELEASE) of(of_window).add(KeyReleased{name});
    if (action == GLFW_PRESS && !panelsTakeKeys()) of(of_window).add(KeyPressed{name, heldOf(mods)});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* of_window, int has_focus) {
    if (!has_focus) of(of_window).add(FocusLost{});
  });
  glfwSetDropCallback(window, [](GLFWwindow* of_window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) of(of_window).dropped_.emplace_back(paths[i]);
  });
}

}  // namespace mirrorball::window
