#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// One eye's half of a stereo picture: of two panoramas above each other or side by side.
enum class PictureHalf { top, bottom, left, right };

/// "top", "bottom", "left", "right": the enumeration's order.
inline constexpr std::array<std::string_view, 4> kPictureHalfNames{"top", "bottom", "left", "right"};

/// The name of a half.
std::string_view halfName(PictureHalf half);

/// Whether it is the upper or the lower one.
bool isUpperOrLower(PictureHalf half);

/// The size of a half of a picture; an odd row or column in the middle is left out.
glm::ivec2 sizeOfHalf(glm::ivec2 picture, PictureHalf half);

/// The half of a picture.
///
/// picture  of at least two rows, or columns
Image cutHalf(const Image& picture, PictureHalf half);

}  // namespace mirrorball
