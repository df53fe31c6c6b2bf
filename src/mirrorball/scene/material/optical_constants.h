#pragma once

#include <span>
#include <string_view>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace mirrorball {

/// A metal by its complex index of refraction n + ik, as measured. Three wavelengths stand for the three channels of a
/// picture: 650 nm for red, 550 nm for green and 450 nm for blue; between two rows of a source the index is
/// interpolated. docs/techniques/materials.md says how far the colours are from those of the whole spectrum.
struct MeasuredMetal {
  std::string_view name;    ///< as in --material: "gold"
  glm::vec3 n;              ///< real part
  glm::vec3 k;              ///< imaginary part, positive
  std::string_view source;  ///< who published it: "Johnson & Christy 1972"
};

/// A clear substance by Sellmeier's formula, n² = 1 + Σ b λ² / (λ² − c), with λ in µm: formula::iorOfSellmeier.
struct MeasuredGlass {
  std::string_view name;  ///< as in --material: "bk7"
  glm::vec4 b;
  glm::vec4 c;              ///< µm²; a source's wavelengths are squared here. A term that it has not is 0, 0
  std::string_view source;  ///< who published it: "Schott, N-BK7"
};

/// The table of metals, in the order of their names.
std::span<const MeasuredMetal> measuredMetals();

/// The table of glasses and other clear substances.
std::span<const MeasuredGlass> measuredGlasses();

/// The index at the line d of helium (587.6 nm), by which a catalogue names a glass.
float iorOf(const MeasuredGlass& glass);

/// Abbe's number V = (n_d − 1) / (n_F − n_C), of helium's line d and hydrogen's F (486.1 nm) and C (656.3 nm): the
/// greater it is, the less a glass disperses.
float abbeNumberOf(const MeasuredGlass& glass);

}  // namespace mirrorball
