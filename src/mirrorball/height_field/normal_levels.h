#pragma once

#include <vector>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// A normal map as a renderer filters it: what a pixel averages away is kept as a spread.
///
/// normals  4 channels, n of any length as formula::encodedNormal writes it; the fourth is not looked at. Texels
///          without a direction do not count
/// zero     the code that stands for 0: 127.5 or 128
/// returns  all mip levels: the means of the unit normals, and alphaOfSpread() of their lengths, rounded to 8 bits so
///          that what the 8 bits of normals scatter is none. The first has the picture's normals and no spread
/// cost     about 10 ns a texel
/// from     Toksvig 2005, "Mipmapping normal maps": whose length is read here from unit normals and not from filtered
///          texels, which would make a surface rough between any two texels seen from nearby
std::vector<Image8> normalLevels(const Image8& normals, float zero);

/// Levels of numbers: they hold the means themselves, decoded, and nothing is rounded.
///
/// zero     the same, of 255; 0 where the normals are not encoded
std::vector<Image> decodedNormalLevels(const Image& normals, float zero);

}  // namespace mirrorball
