#include "cli/stage_clock.h"

#include <algorithm>
#include <cstdio>

namespace mirrorball::cli {
namespace {

double milliseconds(StageClock::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

void StageClock::add(const char* name, Clock::time_point begin, Clock::time_point end) {
  const std::lock_guard lock(mutex_);
  stages_.push_back({name, milliseconds(begin - start_), milliseconds(end - begin)});
}

void StageClock::print() const {
  std::vector<Stage> ordered = stages_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Stage& a, const Stage& b) { return a.begin_ms < b.begin_ms; });
  for (const Stage& stage : ordered)
    std::fprintf(stderr, "%8.1f ms  + %7.1f ms  %s\n", stage.begin_ms, stage.length_ms, stage.name.c_str());
}

}  // namespace mirrorball::cli
