#pragma once

#include "mirrorball/environment/convert/conversion.h"

namespace mirrorball {

/// The rows of a panorama, `height` in all, that hold everything a piece looks up in it.
///
/// cost     a sixteenth of looking up the piece's texels
RowRange rowsNeeded(const Conversion& conversion, const Piece& piece, int height);

}  // namespace mirrorball
