#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// Whether this build can read its file, which is OpenEXR's.
bool hasSunset();

/// The built-in environment "sunset": a photographed square in a town (sunset_file.h).
///
/// errors   unsupported: !hasSunset()
/// cost     that of reading its file: some 20 ms
Result<Environment> sunsetEnvironment();

}  // namespace mirrorball
