#pragma once

#include <functional>

namespace mirrorball::window {

/// Has the program end when the connection to the X server breaks: with code 1, after a function. Xlib ends it then in
/// any case, with a line of its own. To be made when there is a connection, one at a time; without X it does nothing.
class AtDisplayLoss {
 public:
  explicit AtDisplayLoss(std::function<void()> function);
  /// From now on nothing is done before the end.
  ~AtDisplayLoss();
  AtDisplayLoss(const AtDisplayLoss&) = delete;
  AtDisplayLoss& operator=(const AtDisplayLoss&) = delete;
};

}  // namespace mirrorball::window
