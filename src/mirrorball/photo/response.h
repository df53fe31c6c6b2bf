#pragma once

#include <array>
#include <functional>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A camera's response: how much light each of the 256 codes of each channel stands for. It never falls, and code 128
/// stands for the light that sRGB gives it, 0.216, in every channel: grey stays grey.
struct Response {
  std::array<std::array<float, 256>, 3> light{};
};

/// Curves that may be assumed.
enum class ResponseKind { srgb, gamma, linear };

/// The sRGB curve, a power of 2.2, or proportional.
Response assumedResponse(ResponseKind kind);

/// The light of a code to that power.
///
/// power    > 0
Response responseOfPower(double power);

/// Recovers the response from photographs of one static scene with different exposures.
///
/// Debevec & Malik's least squares for ln light of each code: every sample says that two codes differ by the ratio of
/// their exposures, and where there are few samples, the curve deviates smoothly from sRGB's. It was preferred to
/// Robertson's iteration since it is one linear system with one answer, gives a usable curve even from two exposures,
/// and does not depend on where the iteration starts. Unlike theirs, which was made for film, it recovers one curve for
/// the three channels, as cameras have: three curves that differ where there are few samples would tint the light. A
/// sample's own light is eliminated from the system beforehand, so that thousands of samples cost no more than the 256
/// unknowns.
///
/// codes      RGB(A) pictures of one size, at least two
/// exposures  one each, > 0, not all the same
/// errors     bad_shape: too few places are properly exposed, neither black nor clipped, in at least two photographs
/// cost       one pass over a grid of at most 40 000 places, one system of 256 unknowns
/// from       Debevec & Malik 1997, "Recovering high dynamic range radiance maps from photographs", eq. 3
Result<Response> recoverResponse(std::span<const Image8* const> codes, std::span<const double> exposures);

/// How far a code may be trusted: 1 in the middle, falling to 0 at black and at white, where the sensor gives no
/// information (Debevec & Malik's hat).
inline double trustInCode(double code) { return code < 127.5 ? code / 127.5 : (255.0 - code) / 127.5; }

/// Codes from here on count as clipped: JPEG's rounding may change 255 to a little less.
inline constexpr int kFirstClippedCode = 251;

/// Calls `visit` with the mean codes [photograph][channel] of 3 × 3 places on a regular grid where no photograph has an
/// edge, so that small shifts do not matter: at most about 40 000, in a fixed order.
void forEachSmoothPlace(std::span<const Image8* const> codes,
                        const std::function<void(std::span<const std::array<double, 3>> mean)>& visit);

}  // namespace mirrorball
