#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/light_edit/lamp_settings.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// How far around its body a small lamp's glow reaches at least: what is bright there belongs to it, be it lens flare,
/// thin cloud or the rest of a sun behind leaves.
inline constexpr float kGlow_rad = 0.0131f;  // 0.75°

/// That reach in a map: at least two of its texels.
float glowReach_rad(const EnvironmentMap& map);

/// The map in which lamps are searched: that of an environment itself if it is a panorama or a cube, else a panorama of
/// the same detail.
///
/// errors   as convert's
Result<EnvironmentMap> searchedMap(Environment environment, const ProgressFunction& progress = {});

/// That panorama, whatever form the environment has.
Result<EnvironmentMap> searchedPanorama(const Environment& environment, const ProgressFunction& progress = {});

/// ∫ radiance over the sphere.
///
/// cost     one pass over the texels, on all cores: 0.1 µs for each of a cube, less for those of a panorama
glm::vec3 wholeLight(const EnvironmentMap& map);

/// The lamps of a map. Bright are texels with more than eight times the mean of the map without them (brightLights,
/// bake/prefilter/bright_lights.h): a bright sky is no lamp, as it is the mean. From the brightest of them on, those
/// that are at least a 16th as bright and touch each other at a side or a corner are a lamp's body. A small body, of at
/// most 5°, takes what else is bright within its glow; a wider one all that is bright and touches it.
///
/// map      a panorama or a cube; finite, not negative
/// all      wholeLight of it
/// returns  the strongest first, by the luminance of their irradiance
/// cost     two passes over the texels, and 1 µs for each that is bright
std::vector<MapLamp> findLamps(const EnvironmentMap& map, glm::vec3 all, const LampSettings& settings = {});

}  // namespace mirrorball
