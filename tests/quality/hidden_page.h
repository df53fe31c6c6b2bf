#pragma once

#include "mirrorball/base/result.h"

namespace mirrorball::quality {

/// Writes the table of the page hidden.md between its marks, from the tables of numbers beside the tests.
///
/// errors   as readNumberTable's; bad_file: the page has no marks, or a scene has no row
Result<void> writeHiddenPage();

}  // namespace mirrorball::quality
