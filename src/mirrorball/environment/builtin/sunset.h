#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// The built-in environment "sunset": a photographed square in a town (sunset_file.h).
///
/// cost     that of reading its file: some 20 ms
Result<Environment> sunsetEnvironment();

}  // namespace mirrorball
