#include "frame_cost/cost_counter.h"

#include <ctime>

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace mirrorball::testing {

CostCounter::CostCounter() {
  perf_event_attr what{};
  what.type = PERF_TYPE_HARDWARE;
  what.size = sizeof what;
  what.config = PERF_COUNT_HW_INSTRUCTIONS;
  what.disabled = 1;
  what.exclude_kernel = 1;
  what.exclude_hv = 1;
  constexpr int kThisThread = 0;
  constexpr int kAnyCore = -1;
  counter_ = static_cast<int>(::syscall(SYS_perf_event_open, &what, kThisThread, kAnyCore, -1, 0));
}

CostCounter::~CostCounter() {
  if (counter_ >= 0) ::close(counter_);
}

std::uint64_t CostCounter::instructionsOf(const std::function<void()>& work) const {
  ::ioctl(counter_, PERF_EVENT_IOC_RESET, 0);
  ::ioctl(counter_, PERF_EVENT_IOC_ENABLE, 0);
  work();
  ::ioctl(counter_, PERF_EVENT_IOC_DISABLE, 0);
  std::uint64_t count = 0;
  return ::read(counter_, &count, sizeof count) == sizeof count ? count : 0;
}

double processorTimeOf(const std::function<void()>& work) {
  const auto now = [] {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

}  // namespace mirrorball::testing
