#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The function that long work calls as it goes on. It returns false when the work should stop (Ctrl-C).
///
/// done     how many steps are finished, from 0
/// total    how many there are
using ProgressFunction = std::function<bool(std::size_t done, std::size_t total)>;

/// The function for one part of some work: it reports the part's steps as steps of the whole.
///
/// first, count   those of the whole's `total` steps that are this part's
/// returns        nothing for nothing
ProgressFunction partOf(const ProgressFunction& whole, std::size_t first, std::size_t count, std::size_t total);

/// Counts the steps of some work that several threads finish in any order. The function is called by one of them at a
/// time, with numbers that only grow. Once it was told to stop, it stays stopped.
class ProgressCounter {
 public:
  /// progress   must outlive it; nothing: never stops
  ProgressCounter(const ProgressFunction& progress, std::size_t total) : progress_(progress), total_(total) {}

  /// Tells that some more steps are finished; of 0 steps only asks whether to go on.
  void advance(std::size_t steps = 1);

  bool stopped() const { return stopped_; }

  /// errors   interrupted, if it was told to stop
  Result<void> result() const;

 private:
  const ProgressFunction& progress_;
  std::size_t total_;
  std::mutex mutex_;  ///< of done_, and while progress_ is called
  std::size_t done_ = 0;
  std::atomic<bool> stopped_ = false;
};

}  // namespace mirrorball
