#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Of a display of 3840 pixels over 0.7 m, seen from 0.7 m: what FLIP's authors publish their values for.
inline constexpr float kUsualPixelsPerDegree = 67.0206451f;
/// Below, FLIP's detectors of features are narrower than a pixel.
inline constexpr float kMinPixelsPerDegree = 5.0f;

/// LDR-FLIP: how strongly an observer sees two pictures differ who flips between them, pixel by pixel.
///
/// a, b               linear light of pictures in [0, 1] (clipped to it), 3 channels or 1, of one size, all finite
/// pixels_per_degree  of the observer's eye, at least kMinPixelsPerDegree
/// returns            one channel in [0, 1]; 0 where nothing differs. Symmetric. Its mean is what is called FLIP
/// errors             interrupted
/// cost               about 0.5 µs a pixel on one core at the usual density; bit-identical for any number of threads
/// from               Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images"; compared with
///                    values of the published program in flip_test
Result<Image> ldrFlip(const Image& a, const Image& b, float pixels_per_degree, const ProgressFunction& progress = {});

/// The exposures at which HDR-FLIP shows light: `count` of them, evenly from `start_ev` to `stop_ev` [stops].
struct ExposureRange {
  float start_ev = 0.0f;
  float stop_ev = 0.0f;
  int count = 2;

  float at(int index) const;
};

/// The exposures that show a reference from its brightest light to its median: each is brought to 0.85 on the display.
///
/// reference  linear light, 3 channels or 1, finite. Where half of its pixels or more are black, the median is that of
///            the others, which the paper leaves open (its exposure would be infinite); all black: 0 stops
/// from       Andersson et al. 2021, section 4.2
ExposureRange exposureRangeOf(const Image& reference);

/// HDR-FLIP: the greatest LDR-FLIP of all exposures, each tone mapped by the ACES curve.
///
/// test, reference    linear light; negative light counts as none
/// returns, errors    as ldrFlip's. Not symmetric where the exposures are those of the reference
/// cost               that of ldrFlip for each exposure
/// from               Andersson et al. 2021, "Visualizing Errors in Rendered High Dynamic Range Images"
Result<Image> hdrFlip(const Image& test, const Image& reference, const ExposureRange& exposures,
                      float pixels_per_degree, const ProgressFunction& progress = {});

}  // namespace mirrorball
