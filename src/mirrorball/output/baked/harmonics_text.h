#pragma once

#include <string>

#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/bake/harmonics/spherical_harmonics.h"

namespace mirrorball {

/// sh.json: the harmonics of radiance and irradiance, each as they are and windowed.
///
/// degree   of their last band
std::string harmonicsJson(const Harmonics& radiance, int degree);

/// sh.h: the same as arrays of C.
std::string harmonicsHeader(const Harmonics& radiance, const std::string& source);

/// sh.txt, as Filament's cmgen writes it: a line for each coefficient. Its readers take numbers with a point only.
std::string cmgensHarmonics(const FilamentHarmonics& harmonics);

}  // namespace mirrorball
