#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The CIE xy chromaticities of a file's red, green, blue and white.
struct Primaries {
  glm::dvec2 red;
  glm::dvec2 green;
  glm::dvec2 blue;
  glm::dvec2 white;
};

/// ITU-R BT.709: what every image inside the program has.
inline constexpr Primaries kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

/// The matrix that brings linear colours of other primaries to Rec.709. Where the white points
/// differ, colours are adapted by the Bradford transform, so that (1, 1, 1) stays (1, 1, 1).
///
/// returns  nothing where there is nothing to do: the primaries are Rec.709's, or they are none
///          (writers leave them all zero)
std::optional<glm::mat3> rec709FromPrimaries(const Primaries& primaries);

/// Multiplies the first three channels of every texel.
void transformColors(Image& image, const glm::mat3& matrix);

}  // namespace mirrorball
