#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "mirrorball/base/observer.h"

namespace mirrorball::cli {

/// Collects how long the stages of a command take, for --timings. May be used from several threads.
class StageClock {
 public:
  using Clock = std::chrono::steady_clock;

  /// Runs `work` as a stage of that name and returns what it returns.
  template <typename Work>
  auto time(const char* name, Work&& work) {
    struct Stop {
      StageClock& clock;
      const char* name;
      Clock::time_point start = Clock::now();
      ~Stop() { clock.add(name, start, Clock::now()); }
    } stop{*this, name};
    return work();
  }

  /// The observer, which times the stages of what it observes too.
  Observer observing(Observer observer);

  /// Prints the stages in the order in which they began, each with its begin and length, to standard error.
  void print() const;

 private:
  struct Stage {
    std::string name;
    double begin_ms;
    double length_ms;
  };
  void add(std::string name, Clock::time_point begin, Clock::time_point end);

  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::vector<Stage> stages_;
};

}  // namespace mirrorball::cli
