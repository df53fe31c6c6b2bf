#pragma once

#include <cstdint>
#include <functional>

#include "mirrorball/trace/film.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// Draws a pass over one half of the film, up to those counts, and adds it.
///
/// expected   how many paths there will be in the whole picture, as far as is known
/// returns    whether it is whole; if not, nothing was added
using DrawPass = std::function<bool(int half, const PathCounts& counts, std::uint64_t expected)>;

/// Asked between passes.
///
/// returns   whether there is time for another
using GoesOn = std::function<bool()>;

/// At least so many paths a pixel are drawn before their noise may end them: that of few is not known well enough.
constexpr int kMinPathsForNoise = 16;

/// Passes with the same number of paths for each pixel, each as many as all before it, at most 128.
///
/// film      of one half
/// returns   whether all of them were whole
bool traceEvenly(const Film& film, const TraceSettings& settings, const DrawPass& draw, const GoesOn& goesOn);

/// Paths where the noise is, in passes of at most 128 a pixel in the mean, until its mean over the picture is that of
/// the settings: the mean of all pixels' standard errors is least, for a number of paths, where each pixel has as many
/// as its paths' deviation to the power of 2/3.
///
/// Without bias: a pixel with few paths by chance is not left so because it looks good. The two halves have a few paths
/// everywhere first; then each pixel of a half has as many as these first paths of the *other* half say, of which its
/// own light is independent ("two-stage sampling": Kirk & Arvo 1991, who leave out the first paths instead). The noise
/// of the picture, by which all of these counts grow, is one number for all pixels.
///
/// film      of two halves
/// settings  with at least kMinPathsForNoise samples
/// returns   as traceEvenly's
bool traceToNoise(const Film& film, const TraceSettings& settings, const DrawPass& draw, const GoesOn& goesOn);

}  // namespace mirrorball
