#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "formula/sun.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// Renderers make a picture of shadows for each.
constexpr int kMostSuns = 4;

/// An environment without its suns, and those: its lamps of at most 2° that have at least a twentieth of the light.
struct SunlessEnvironment {
  Environment rest;
  std::vector<formula::Sun> suns;  ///< at most kMostSuns, the strongest first; empty: `rest` is the environment
};

/// Takes the suns out of an environment (splitLamps).
///
/// environment   finite, not negative
/// errors        as searchedMap's
/// cost          as splitMap's; of what is no panorama and no cube that of a panorama of its detail, too
Result<SunlessEnvironment> withoutSuns(const Environment& environment);

/// Both together again: the suns as discs of even radiance.
///
/// cost     of a direction that of the rest's
Environment withSuns(SunlessEnvironment split);

/// The direction towards a sun that has more than a fifth of an environment's light, so that its shadows are seen: in
/// the environment, unit. Nothing: there is none.
///
/// environment, errors   as withoutSuns'
/// cost                  as wholeLight's, and where something is bright enough, findLamps'; of what is no panorama and
///                       no cube, a panorama of 256 rows, too
Result<std::optional<glm::vec3>> strongSun(const Environment& environment);

/// Whether there is one; as strongSun.
Result<bool> hasStrongSun(const Environment& environment);

}  // namespace mirrorball
