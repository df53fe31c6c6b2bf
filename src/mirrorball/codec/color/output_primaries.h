#pragma once

#include <glm/mat3x3.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

struct Primaries;

/// The primaries that files are written with, in the order of --primaries' choices.
enum class OutputPrimaries {
  rec709,   ///< those of all images in memory, and of files that state none
  p3,       ///< Display P3: SMPTE RP 431-2 under D65
  rec2020,  ///< ITU-R BT.2020
  acescg,   ///< ACEScg, a space of linear light: AP1 under ACES' white, some 6000 K
};

/// Their chromaticities.
const Primaries& chromaticitiesOf(OutputPrimaries primaries);

/// The matrix that brings linear colours of Rec.709 to them: the inverse of rec709FromPrimaries (primaries.h), so that
/// white stays (1, 1, 1). All have Rec.709's gamut within theirs: no number of it is negative, and light that is not
/// negative stays so. Sums of a row are 1: nothing becomes greater than the greatest channel, but for rounding.
///
/// source   SMPTE RP 177-1993; Bradford's adaptation as in ACES (aces-dev, ACESlib.Utilities_Color.ctl)
glm::mat3 primariesFromRec709(OutputPrimaries primaries);

/// Brings an image in linear light on its way into a file from Rec.709 to the file's primaries. Grey is the same in
/// all. Negative light, which is a colour beyond Rec.709, keeps its colour; what is negative by rounding alone becomes
/// 0, so that pure colours of a file in these primaries are pure again. A texel with NaN becomes NaN.
///
/// cost     none for Rec.709; else one pass over the image on all cores
void convertFromRec709(Image& image, OutputPrimaries primaries);

}  // namespace mirrorball
