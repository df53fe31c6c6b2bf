#include "mirrorball/base/parallel.h"

#include <algorithm>
#include <optional>
#include <thread>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace mirrorball {
namespace {

/// The limit that was set: oneTBB keeps to it as long as this lives.
std::optional<tbb::global_control>& threadControl() {
  static std::optional<tbb::global_control> control;
  return control;
}

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t pieces = (count + grain - 1) / grain;
  tbb::parallel_for(std::size_t{0}, pieces,
                    [&](std::size_t piece) { body(piece * grain, std::min(count, (piece + 1) * grain)); });
}

int threadLimit() {
  if (threadControl())
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void setThreadLimit(int threads) {
  threadControl().emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
}

std::launch besideOthers() { return threadLimit() > 1 ? std::launch::async : std::launch::deferred; }

}  // namespace mirrorball
