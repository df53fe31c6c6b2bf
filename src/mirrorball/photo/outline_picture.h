#pragma once

#include "mirrorball/image/image.h"
#include "mirrorball/photo/ball_view.h"

namespace mirrorball {

/// The photograph with a ball's rim and centre drawn over it, to see by eye whether they are right.
///
/// light    the photograph, linear; shown in sRGB, clipped
/// returns  3 channels
Image8 outlinePicture(const Image& light, const BallView& view);

}  // namespace mirrorball
