#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Pictures from left to right on one sheet, their upper edges in line.
///
/// panels   at least one, of 3 channels
/// gap_px   between them
/// paper    the grey of all that they leave free
Image8 sideBySide(std::span<const Image8> panels, int gap_px, std::uint8_t paper);

/// Copies a picture into a larger one.
void place(const Image8& picture, Image8& sheet, int left, int top);

}  // namespace mirrorball
