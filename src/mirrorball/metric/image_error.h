#pragma once

#include <glm/vec2.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// How far the samples of two images are apart.
struct ImageError {
  double mean_square = 0.0;           ///< mean of (a − b)² over all samples
  double relative_mean_square = 0.0;  ///< mean of (a − b)² / (b² + kRelativeEpsilon) over all samples
  double mean_of_worst = 0.0;         ///< mean over the pixels of |a − b| of the channel that is farthest apart
  float max = 0.0f;                   ///< greatest |a − b| of a sample
  glm::ivec2 worst{0};                ///< the pixel that has it, the first in reading order
};

/// Keeps pixels that are black in the reference from counting without bound: the usual value of the measure of
/// Rousselle et al. 2011 ("Adaptive Sampling and Reconstruction using Greedy Error Minimization"), in the samples' unit
/// squared.
inline constexpr double kRelativeEpsilon = 0.01;

/// Compares an image with the reference `b`, sample by sample.
///
/// a, b     of one size and number of channels, at least one texel, all finite
/// cost     a few ns a sample; bit-identical for any number of threads
ImageError imageError(const Image& a, const Image& b);

/// Peak signal-to-noise ratio [dB] of values of which the greatest possible is 1: −10 log₁₀ of the mean square error.
/// Infinite where that is 0.
double peakSignalToNoise_db(double mean_square);

/// The difference a − b of the channel that is farthest apart, with its sign, as an image of one channel.
///
/// a, b     as imageError's
Image signedDifference(const Image& a, const Image& b);

}  // namespace mirrorball
