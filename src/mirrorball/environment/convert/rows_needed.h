#pragma once

#include "mirrorball/environment/convert/conversion.h"

namespace mirrorball {

/// The rows of a panorama, `height` in all, that hold everything a strip looks up in it.
///
/// cost     a sixteenth of looking up the strip's texels
RowRange rowsNeeded(const Conversion& conversion, const Strip& strip, int height);

}  // namespace mirrorball
