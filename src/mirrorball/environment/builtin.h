#pragma once

#include <span>
#include <string_view>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// What "sky:elevation=20,turbidity=3" may set.
struct SkyParameters {
  float elevation_deg = 35.0f;  ///< of the sun
  float azimuth_deg = 60.0f;    ///< of the sun: 0 stands over +Z, 90 over +X
  float turbidity = 3.0f;       ///< 2 very clear … 10 hazy
  float sun = 1.0f;             ///< strength of the sun's disc; 0 leaves the sky alone
};

/// The table of the sky's parameters.
std::span<const Option<SkyParameters>> skyParameters();

/// "studio", "sky", "uv", "white".
std::span<const std::string_view> builtinEnvironmentNames();

/// Whether a name is a built-in environment's, with or without parameters after a colon.
bool isBuiltinEnvironment(std::string_view name);

/// Makes a built-in:
///   studio   soft boxes in a dim room
///   sky      analytic daylight with the sun's disc (formula/sky.glsl); radiance 1 is 20 kcd/m²
///   uv       six coloured faces with their names, to check which way round things are
///   white    radiance 1 from everywhere: what reflects all light vanishes in it
///
/// errors   not_found; usage (a parameter that it does not have, or out of range)
Result<Environment> builtinEnvironment(std::string_view name);

/// The error for a name that is neither a file nor a built-in.
Error noSuchEnvironment(std::string_view name);

}  // namespace mirrorball
