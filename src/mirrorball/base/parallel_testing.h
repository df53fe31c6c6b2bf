#pragma once

#include "mirrorball/base/parallel.h"

namespace mirrorball::testing {

/// As long as it lives, one thread computes.
class OneThread {
 public:
  OneThread() : before_(threadLimit()) { setThreadLimit(1); }
  ~OneThread() { setThreadLimit(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_;
};

}  // namespace mirrorball::testing
