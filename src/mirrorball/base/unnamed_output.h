#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "mirrorball/base/descriptor.h"

namespace mirrorball {

/// An output file without a name on any disk. While this lives, a FileWriter of its name writes into an unnamed file of
/// the temporary folder, which the kernel removes however the process ends, be it by SIGKILL.
class UnnamedOutput {
 public:
  /// name   for FileWriter; no two that live at a time have the same
  explicit UnnamedOutput(std::string name);
  UnnamedOutput(const UnnamedOutput&) = delete;
  UnnamedOutput& operator=(const UnnamedOutput&) = delete;
  ~UnnamedOutput();

  /// What the last FileWriter committed, open for reading and writing; not open: none has.
  const Descriptor& file() const { return file_; }

  /// Takes what a FileWriter commits.
  void take(Descriptor file) { file_ = std::move(file); }

  /// The one of this name; nullptr: there is none. From any thread, while none is made or goes away.
  static UnnamedOutput* find(std::string_view name);

 private:
  std::string name_;
  Descriptor file_;
};

}  // namespace mirrorball
