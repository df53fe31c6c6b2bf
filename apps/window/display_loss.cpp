#include "window/display_loss.h"

#include <cstdlib>
#include <utility>

#include <dlfcn.h>

namespace mirrorball::window {
namespace {

std::function<void()>& atLoss() {
  static std::function<void()> function;
  return function;
}

int endAfterLoss(void*) {
  if (atLoss()) atLoss()();
  // What is still at work beside the window knows of no end, and nothing that is left can tell the display anything.
  std::_Exit(1);
}

}  // namespace

// The window's library has loaded Xlib, or another library for another kind of display.
AtDisplayLoss::AtDisplayLoss(std::function<void()> function) {
  void* const xlib = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (!xlib) return;
  using Handler = int (*)(void*);
  const auto set_handler = reinterpret_cast<Handler (*)(Handler)>(dlsym(xlib, "XSetIOErrorHandler"));
  if (!set_handler) return;
  atLoss() = std::move(function);
  set_handler(endAfterLoss);
}

AtDisplayLoss::~AtDisplayLoss() { atLoss() = {}; }

}  // namespace mirrorball::window
