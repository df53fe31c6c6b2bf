#pragma once

#include <span>
#include <string_view>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/builtin/sky.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// The table of the sky's parameters.
std::span<const Option<SkyParameters>> skyParameters();

/// "studio", "sky", "sunset" (not in a build without OpenEXR), "uv", "white".
std::span<const std::string_view> builtinEnvironmentNames();

/// Whether a name is a built-in environment's, with or without parameters after a colon.
bool isBuiltinEnvironment(std::string_view name);

/// Makes a built-in:
///   studio   a photo studio with soft boxes and a satin floor (environment/builtin/studio.h)
///   sky      clear daylight with the sun's disc, over soil (environment/builtin/sky.h)
///   sunset   a photographed square in a town (environment/builtin/sunset.h)
///   uv       six coloured faces with their names, to check orientation
///   white    radiance 1 from everywhere: objects that reflect all light are invisible in it
///
/// errors   not_found; usage (a parameter that it does not have, or out of range)
Result<Environment> builtinEnvironment(std::string_view name);

/// The error for a name that is neither a file nor a built-in.
Error noSuchEnvironment(std::string_view name);

}  // namespace mirrorball
