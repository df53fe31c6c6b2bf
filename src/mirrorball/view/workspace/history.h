#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// A workspace with all that was done to it: each change has a name and can be undone and done again.
class History {
 public:
  explicit History(Workspace start = {});

  const Workspace& now() const { return steps_[now_].workspace; }

  /// Makes a change. What was undone is forgotten. One that changes nothing is no step.
  ///
  /// name       as a menu says it after "Undo": "Roughness", "Turn the light"
  /// goes_on    it goes on with the step before, if that has the same name, as while a hand drags: both are one step
  void change(std::string name, Workspace next, bool goes_on = false);

  /// What goes on by itself, as an animation: takes the place of what is now, and is no step.
  void goOn(Workspace next) { steps_[now_].workspace = std::move(next); }

  /// Ends what a hand does: a change that comes after is another step, whatever its name.
  void endGesture() { is_going_on_ = false; }

  // What there is to undo or to do again; empty: nothing.
  std::string_view undoName() const { return now_ == 0 ? std::string_view() : steps_[now_].name; }
  std::string_view redoName() const;

  /// returns   whether there was anything
  bool undo();
  bool redo();

  /// Steps that are kept; beyond that the oldest cannot be undone any more.
  static constexpr std::size_t kMostSteps = 20000;

 private:
  struct Step {
    std::string name;  ///< of what led to it
    Workspace workspace;
  };
  std::deque<Step> steps_;
  std::size_t now_ = 0;
  bool is_going_on_ = false;
};

}  // namespace mirrorball
