#include "mirrorball/view/workspace/history.h"

#include <utility>

namespace mirrorball {

History::History(Workspace start) { steps_.push_back({"", std::move(start)}); }

void History::change(std::string name, Workspace next, bool goes_on) {
  const bool joins = goes_on && is_going_on_ && now_ > 0 && steps_[now_].name == name;
  is_going_on_ = goes_on;
  if (next == now()) return;
  steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(now_) + 1, steps_.end());
  if (!joins) {
    steps_.push_back({std::move(name), std::move(next)});
    if (steps_.size() > kMostSteps + 1) steps_.pop_front();
  } else if (next == steps_[now_ - 1].workspace) {
    steps_.pop_back();  // back where it came from: nothing was done
    is_going_on_ = false;
  } else {
    steps_[now_].workspace = std::move(next);
  }
  now_ = steps_.size() - 1;
}

std::string_view History::redoName() const {
  return now_ + 1 < steps_.size() ? std::string_view(steps_[now_ + 1].name) : std::string_view();
}

bool History::undo() {
  endGesture();
  if (now_ == 0) return false;
  --now_;
  return true;
}

bool History::redo() {
  endGesture();
  if (now_ + 1 >= steps_.size()) return false;
  ++now_;
  return true;
}

}  // namespace mirrorball
