#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"

namespace mirrorball {

/// The coefficients of the polynomial by which Filament's shaders light matt surfaces:
///   irradiance / π = c₀ + c₁ y + c₂ z + c₃ x + c₄ yx + c₅ yz + c₆ (3z² − 1) + c₇ zx + c₈ (x² − y²),
/// with (x, y, z) the normal, a unit vector in the world's axes, which are ours.
///
/// from     Filament, surface_light_indirect.fs, Irradiance_SphericalHarmonics
using FilamentHarmonics = std::array<glm::vec3, 9>;

/// They, of an environment. Three bands fall below 0 opposite of a bright lamp. Then they are blurred, each band by
/// exp(−t l (l + 1)), a Gaussian of the sphere, with the least t that leaves no channel below 0 anywhere.
///
/// radiance at least three bands of it
FilamentHarmonics filamentHarmonics(const Harmonics& radiance);

/// The polynomial's value.
glm::vec3 irradianceOverPi(const FilamentHarmonics& harmonics, glm::vec3 normal);

/// The 27 numbers as Filament's KTX files have them: "0.5 0.25 …", each coefficient's red, green and blue.
std::string textOf(const FilamentHarmonics& harmonics);

/// The harmonics in such a text; nothing where it has no 27 numbers.
std::optional<FilamentHarmonics> filamentHarmonicsIn(std::string_view text);

}  // namespace mirrorball
