// The parallel loops of builds without threads, as for a browser without shared memory.

#include <algorithm>

#include "mirrorball/base/parallel.h"

namespace mirrorball {

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  grain = std::max<std::size_t>(grain, 1);
  for (std::size_t begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
}

int threadLimit() { return 1; }

void setThreadLimit(int) {}

std::launch besideOthers() { return std::launch::deferred; }

}  // namespace mirrorball
