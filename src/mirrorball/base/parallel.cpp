#include "mirrorball/base/parallel.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace mirrorball {

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t pieces = (count + grain - 1) / grain;
  tbb::parallel_for(std::size_t{0}, pieces,
                    [&](std::size_t piece) { body(piece * grain, std::min(count, (piece + 1) * grain)); });
}

}  // namespace mirrorball
