#pragma once

#include <cstddef>
#include <span>

#include "mirrorball/base/progress.h"
#include "mirrorball/environment/convert/conversion.h"

namespace mirrorball {

/// Converts strips on all cores and hands them on, until all are done, one cannot be taken, or `progress` says stop.
class ParallelConversion {
 public:
  /// total    how many strips there will be in all runs together, for `progress`
  ParallelConversion(const Conversion& conversion, const TakeTexels& take, const ProgressFunction& progress,
                     std::size_t total)
      : conversion_(conversion), take_(take), steps_(progress, total) {}

  /// errors   interrupted; of the strips that could not be taken the first one's
  Result<void> run(const Environment& source, std::span<const Strip> strips);

 private:
  const Conversion& conversion_;
  const TakeTexels& take_;
  ProgressCounter steps_;
};

}  // namespace mirrorball
