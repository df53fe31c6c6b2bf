#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The nine coefficients of formula::harmonicIrradiance: light × harmonic × cosineLobeBand, numbered l (l + 1) + m.
using IrradianceHarmonics = std::array<glm::vec3, 9>;

/// Projects the light of a map on spherical harmonics up to l = 2 and weights them with the cosine lobe, so that they
/// give irradiance [W/m²] at any normal. Nine coefficients are exact for light that varies slowly; a single small lamp
/// is reproduced within about 9 % of its greatest irradiance.
///
/// map      all texels finite
/// cost     one pass over the texels; bit-identical for any number of threads
/// from     Ramamoorthi & Hanrahan 2001, "An efficient representation for irradiance environment maps"
IrradianceHarmonics irradianceHarmonics(const EnvironmentMap& map);

}  // namespace mirrorball
