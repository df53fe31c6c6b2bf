#pragma once

namespace mirrorball {

/// How colours between two codes of a picture of 8 bits become codes.
enum class Dither {
  none,     ///< the nearest
  pattern,  ///< the one or the other, by the pixel's place: formula::dithered
};

}  // namespace mirrorball
