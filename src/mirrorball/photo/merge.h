#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/photo/photograph.h"
#include "mirrorball/photo/response.h"

namespace mirrorball {

/// How a series is merged into light.
struct MergeOptions {
  std::vector<double> exposures;         ///< one a photograph, > 0; empty: from EXIF
  std::optional<ResponseKind> response;  ///< to assume; nothing: recovered from a series, sRGB of a single photograph
  std::optional<Response> known = {};    ///< the camera's curve, recovered before; used instead of `response`
};

/// The light of a series.
struct MergedPhotographs {
  Image light;                            ///< 3 channels, linear; 1 is sRGB's white in the reference exposure
  std::size_t reference = 0;              ///< index of the photograph with the middle exposure, of two the brighter
  std::size_t clipped = 0;                ///< pixels with a channel that even the shortest exposure clips
  std::size_t black = 0;                  ///< pixels with a channel that is black even in the longest
  std::vector<double> contradicts_stops;  ///< per photograph: its difference from the closest other one
  std::optional<Response> curve;          ///< of a camera whose response was recovered
  std::string response;                   ///< "recovered", "the first side's", "assumed sRGB", …, "linear light"
};

/// Beyond this difference a photograph contradicts the others: its exposure is wrong, or it shows another scene.
inline constexpr double kContradiction_stops = 0.5;

/// Merges photographs of one static scene, taken from one place with different exposures, into linear light. The
/// pictures are taken as aligned. Each pixel's light is the mean over the photographs, weighted by the square of the
/// exposure (the noise of a code's light falls with it) and by the trust in the code; clipped codes have no weight. If
/// all are clipped, the shortest exposure is used; if all are black, the longest. The light of the photographs' own
/// primaries is converted to Rec.709's at the end.
///
/// Linear codes are light by themselves, unless the options name a response.
///
/// photographs  at least one, of one size; a file of linear light stands alone, if its light is not that of codes
/// errors       too_large; bad_shape (sizes or primaries differ; too little to recover the response from); usage (no
///              exposure times; all the same; a wrong number of them; linear light of floats in a series)
/// cost         one pass over all pixels; bit-identical for any number of threads
/// from         Robertson, Borman & Stevenson 2003, "Estimation-theoretic approach to dynamic range enhancement using
///              multiple exposures", eq. 10
Result<MergedPhotographs> mergePhotographs(std::span<const Photograph> photographs, const MergeOptions& options);

}  // namespace mirrorball
