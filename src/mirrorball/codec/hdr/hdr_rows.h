#pragma once

#include <memory>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/row_reader.h"

namespace mirrorball {

/// openRows for a file that begins as a Radiance picture does.
///
/// cost     reads the whole file, to find its scan lines
Result<std::unique_ptr<RowReader>> openHdrRows(FileReader file);

}  // namespace mirrorball
