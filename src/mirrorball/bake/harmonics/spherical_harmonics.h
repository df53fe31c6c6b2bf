#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/prefilter/blurred_light.h"

namespace mirrorball {

/// Coefficients of formula::harmonic in our world's axes, numbered l (l + 1) + m: (degree + 1)² of them.
using Harmonics = std::vector<glm::vec3>;

/// The radiance of an environment in harmonics up to `degree`: ∫ radiance · harmonic.
///
/// degree   0 to 4
/// source_from_target   turns the harmonics' directions into the environment's: a rotation
/// cost     microseconds
Harmonics radianceHarmonics(const LightHarmonics& light, int degree,
                            const glm::mat3& source_from_target = glm::mat3(1.0f));

/// Irradiance [W/m²] instead of radiance: each band times what the cosine lobe leaves of it.
Harmonics irradianceOf(Harmonics radiance);

/// Each band times Hann's window (formula::harmonicWindow).
Harmonics windowed(Harmonics harmonics);

}  // namespace mirrorball
