#pragma once

#include <optional>
#include <string>

#include "mirrorball/codec/metadata.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A file that says that it holds a table of numbers, which of bake's it may be.
struct TableFile {
  Metadata metadata;
  std::string format;
  Image table;
};

/// returns  nothing where a file does not say so near its beginning, or there is no such file
/// errors   what reading a file finds that says it is one
Result<std::optional<TableFile>> tableFileIn(const std::string& path);

}  // namespace mirrorball
