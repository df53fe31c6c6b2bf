#pragma once

#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// What "sky:elevation=20,turbidity=3" may set.
struct SkyParameters {
  float elevation_deg = 35.0f;  ///< of the sun
  float azimuth_deg = 60.0f;    ///< of the sun: 0 stands over +Z, 90 over +X
  float turbidity = 2.5f;       ///< 2 very clear … 10 hazy
  float sun = 1.0f;             ///< factor on the radiance of the sun's disc; 0 leaves only the sky
  float adaptation = 0.7f;      ///< how far the exposure follows the daylight: 0 not at all, 1 fully
};

/// The built-in environment "sky": daylight (environment/builtin/sky_light.h) with the sun's disc over a ground of soil
/// and stubble (formula/sky/ground.glsl). Radiance 1 is 20 kcd/m² · (E / 70 klx)^adaptation, where E is the light on
/// level ground, of sun and sky: 70 klx under a sun of about 38°, 2 klx under one of 2°.
///
/// cost   about 20 ms of one core
Environment skyEnvironment(const SkyParameters& parameters);

}  // namespace mirrorball
