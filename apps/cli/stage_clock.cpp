#include "cli/stage_clock.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace mirrorball::cli {
namespace {

double milliseconds(StageClock::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

void StageClock::add(std::string name, Clock::time_point begin, Clock::time_point end) {
  const std::lock_guard lock(mutex_);
  stages_.push_back({std::move(name), milliseconds(begin - start_), milliseconds(end - begin)});
}

Observer StageClock::observing(Observer observer) {
  observer.timing = [this](std::string_view stage) -> std::function<void()> {
    return [this, name = std::string(stage), begin = Clock::now()] { add(name, begin, Clock::now()); };
  };
  return observer;
}

void StageClock::print() const {
  std::vector<Stage> ordered = stages_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Stage& a, const Stage& b) { return a.begin_ms < b.begin_ms; });
  for (const Stage& stage : ordered)
    std::fprintf(stderr, "%8.1f ms  + %7.1f ms  %s\n", stage.begin_ms, stage.length_ms, stage.name.c_str());
}

}  // namespace mirrorball::cli
