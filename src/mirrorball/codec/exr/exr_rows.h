#pragma once

#include <memory>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/row_reader.h"

namespace mirrorball {

/// openRows for a file that begins as OpenEXR's do: scan lines or tiles.
Result<std::unique_ptr<RowReader>> openExrRows(FileReader file, const ImageReadOptions& options = {});

}  // namespace mirrorball
