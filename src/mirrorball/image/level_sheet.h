#pragma once

#include <span>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Mip levels on one sheet: the first in the upper left corner, the others one below the other on its right or, where
/// it is wider than 3:2, side by side below it; halves of halves, they are together as long as the first. Between it
/// and them is a gap of 1/64 of its shorter side. What is left of the sheet is 0.
///
/// levels   at least one, all of as many channels
Image levelSheet(std::span<const Image> levels);

}  // namespace mirrorball
