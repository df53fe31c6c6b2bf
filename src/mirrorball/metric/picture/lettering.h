#pragma once

#include <cstdint>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// How far one line of text lies below the one before it [pixels].
///
/// scale    how many pixels a letter's strokes are wide, at least 1
int lineHeight(int scale);

/// How wide a line of text is [pixels]. All letters are equally wide, so that columns stand below each other.
int textWidth(std::string_view text, int scale);

/// Draws a line of text into a picture of 3 channels; what lies beside the picture is left out.
///
/// upper_left  of the first letter
/// text        UTF-8; drawn in plainLetters
void drawText(Image8& picture, glm::ivec2 upper_left, int scale, glm::vec<3, std::uint8_t> color,
              std::string_view text);

}  // namespace mirrorball
