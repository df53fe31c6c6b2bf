#pragma once

#include "mirrorball/photo/rim_fit.h"

namespace mirrorball {

/// The logarithm of the odds that a circle is a mirror ball's rim, against there being no ball.
/// Three things speak for it:
///   - edges along its rim;
///   - more detail just inside than just outside: a ball squeezes everything around it into its rim, while the picture
///     beside it shows a few degrees of that;
///   - size, since chance makes small circles more easily.
/// Their weights are those of a multinomial logistic regression over the circles that were found in 440 traced
/// photographs (docs/photo.md), rounded.
///
/// share  of the rim inside the picture, how much has an edge that runs along it
/// pixel  size of the picture's texels in pixels of the photograph
double ballLogOdds(const PlanePicture& picture, const Circle& circle, double share, double pixel);

}  // namespace mirrorball
