#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/base/unfinished.h"

namespace mirrorball {

/// Whether an output is a folder: one that is there, or a name that ends in '/'.
bool isFolder(const std::string& output);

/// Whether an output is one file: not a folder, and with an extension.
bool isOneFile(const std::string& output);

/// Makes a folder, and those above it, if it is not there.
///
/// errors   io (something else is in its place)
Result<void> makeFolder(const std::string& folder);

/// A folder for files that belong together. What was not there before, the folder and the files that this process puts
/// into it, goes away again unless it is kept.
class OutputFolder {
 public:
  /// errors   io
  static Result<OutputFolder> make(const std::string& folder);

  /// Whether it was not there before.
  bool isNew() const { return !made_.empty(); }
  void keep() { made_.keep(); }

 private:
  explicit OutputFolder(std::vector<std::string> made) : made_(std::move(made)) {}

  UnfinishedFolder made_;
};

}  // namespace mirrorball
