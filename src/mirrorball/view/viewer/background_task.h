#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// Work that goes on beside its owner, who asks from time to time what has become of it: the last that was begun.
/// Where there are no threads it is done when it is asked for. What does not stop when it is told to is waited for at
/// the end, and where four such works go on still.
template <typename Value>
class BackgroundTask {
 public:
  /// Is to ask its progress function often, which tells it to stop.
  using Work = std::function<Result<Value>(const ProgressFunction& progress)>;

  BackgroundTask() = default;
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;
  /// Waits until all has stopped.
  ~BackgroundTask() { cancel(); }

  /// Begins another work. What was begun before is told to stop, and its result is not asked for.
  void begin(Work work) {
    cancel();
    auto steps = std::make_shared<Steps>();
    auto running = std::async(besideOthers(), [steps, work = std::move(work)] {
      auto result = work([steps](std::size_t done, std::size_t total) {
        steps->done = done;
        steps->total = total;
        return !steps->is_cancelled.load();
      });
      // What nobody asks for any more takes no memory.
      if (steps->is_cancelled) return Result<Value>(fail(ErrorCode::interrupted, "interrupted"));
      return result;
    });
    now_ = Run{std::move(steps), std::move(running)};
  }

  /// Leaves what was begun. It is not waited for, unless so many have not stopped yet.
  void cancel() {
    constexpr std::size_t kMostStopping = 4;
    std::erase_if(stopping_, [](const Run& run) { return hasEnded(run); });
    if (!now_) return;
    now_->steps->is_cancelled = true;
    if (now_->future.wait_for(std::chrono::seconds(0)) != std::future_status::deferred)
      stopping_.push_back(std::move(*now_));
    now_.reset();
    if (stopping_.size() > kMostStopping) stopping_.erase(stopping_.begin());
  }

  bool isRunning() const { return now_.has_value(); }

  /// How much of it is done, 0 … 1; 0 where it does not say.
  double share() const {
    if (!now_) return 0.0;
    const std::size_t total = now_->steps->total;
    return total == 0 ? 0.0 : std::min(double(now_->steps->done) / double(total), 1.0);
  }

  /// What has become of it, once; nothing: there is none, or it goes on.
  std::optional<Result<Value>> take() {
    std::erase_if(stopping_, [](const Run& run) { return hasEnded(run); });
    if (!now_ || now_->future.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return std::nullopt;
    std::optional<Result<Value>> result(now_->future.get());
    now_.reset();
    return result;
  }

 private:
  struct Steps {
    std::atomic<bool> is_cancelled = false;
    std::atomic<std::size_t> done = 0;
    std::atomic<std::size_t> total = 0;
  };
  struct Run {
    std::shared_ptr<Steps> steps;
    std::future<Result<Value>> future;  // whose end waits for the work
  };
  static bool hasEnded(const Run& run) {
    return run.future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }

  std::optional<Run> now_;
  std::vector<Run> stopping_;
};

}  // namespace mirrorball
