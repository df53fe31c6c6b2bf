#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace mirrorball::testing {

/// What work of this process costs. Instructions are the better unit: other programs do not change them. Virtual
/// machines often have no counter; then there is the processors' time alone.
class CostCounter {
 public:
  CostCounter();
  ~CostCounter();
  CostCounter(const CostCounter&) = delete;
  CostCounter& operator=(const CostCounter&) = delete;

  bool countsInstructions() const { return counter_ >= 0; }

  /// Of this thread, outside of the kernel.
  std::uint64_t instructionsOf(const std::function<void()>& work) const;

 private:
  int counter_;  ///< a file descriptor, or −1
};

/// The processors' time of all threads of this process, user and system [s].
double processorTimeOf(const std::function<void()>& work);

}  // namespace mirrorball::testing
