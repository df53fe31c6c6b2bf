#include "mirrorball/base/progress.h"

#include <cassert>

namespace mirrorball {

ProgressFunction partOf(const ProgressFunction& whole, std::size_t first, std::size_t count, std::size_t total) {
  if (!whole) return {};
  return [=](std::size_t part_done, std::size_t part_total) {
    const std::size_t done = part_total > 0 ? count * part_done / part_total : 0;
    return whole(first + done, total);
  };
}

void ProgressCounter::advance(std::size_t steps) {
  if (!progress_) return;
  const std::lock_guard lock(mutex_);
  done_ += steps;
  assert(done_ <= total_);
  if (!progress_(done_, total_)) stopped_ = true;
}

Result<void> ProgressCounter::result() const {
  if (stopped_) return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  return {};
}

}  // namespace mirrorball
