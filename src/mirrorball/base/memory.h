#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The maximum memory for the images of one task [bytes]: initially 3/4 of the machine's memory, or of what its control
/// group allows.
std::uint64_t memoryLimit();

/// Changes this limit for the whole process.
void setMemoryLimit(std::uint64_t bytes);

/// The addresses that this process may still take [bytes], where `ulimit -v` or a service's limit bounds them; else
/// UINT64_MAX. Some libraries end the process when addresses run out.
std::uint64_t addressSpaceLeft();

/// Refuses to take more memory than the limit, or than a MemoryShare of this thread has left. Called before memory is
/// taken whose size a file states.
///
/// errors   too_large
Result<void> checkMemory(std::uint64_t bytes);

/// The memory of a task whose parts each fit into memoryLimit(), and may be too large together: the pictures and meshes
/// of a model. Several threads may ask at the same time.
class MemoryBudget {
 public:
  /// Asks for memory before it is taken.
  ///
  /// errors   too_large: what was taken and this are more than memoryLimit(); then nothing is taken
  Result<void> take(std::uint64_t bytes);
  void giveBack(std::uint64_t bytes) { taken_ -= bytes; }

  std::uint64_t taken() const { return taken_; }

 private:
  std::atomic<std::uint64_t> taken_ = 0;
};

/// While it lives, what this thread asks checkMemory for comes from a budget. So whoever reads a part of a task, as a
/// picture of a model, asks as it would without the task.
class MemoryShare {
 public:
  explicit MemoryShare(MemoryBudget& budget);
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;
  /// Gives back all but what is kept.
  ~MemoryShare();

  /// What stays taken of it when the part is read: its bytes, without those that reading it took.
  ///
  /// errors   too_large, where nobody asked for so much
  Result<void> keep(std::uint64_t bytes);

 private:
  friend Result<void> checkMemory(std::uint64_t bytes);
  Result<void> raiseTo(std::uint64_t bytes);

  MemoryBudget& budget_;
  MemoryShare* outer_;  // that this thread had before
  std::uint64_t taken_ = 0;
  std::uint64_t kept_ = 0;
};

/// "1.5 GB", "320 MB"; a GB is 2³⁰ bytes.
std::string textOfBytes(std::uint64_t bytes);

/// The bytes of "1.5G", "1.5GB", "800M", "2e9".
///
/// errors   usage
Result<std::uint64_t> parseBytes(std::string_view written);

}  // namespace mirrorball
