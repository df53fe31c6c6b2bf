#pragma once

#include <optional>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// The CIE xy chromaticities of a file's red, green, blue and white.
struct Primaries {
  glm::dvec2 red;
  glm::dvec2 green;
  glm::dvec2 blue;
  glm::dvec2 white;

  bool operator==(const Primaries&) const = default;
};

inline constexpr glm::dvec2 kD65{0.3127, 0.3290};
/// Of ICC's profile connection space: XYZ 0.9642, 1, 0.8249 (ICC.1:2022, 7.2.16).
inline constexpr glm::dvec2 kD50{0.345703, 0.358539};
inline constexpr glm::dvec2 kAcesWhite{0.32168, 0.33767};

/// ITU-R BT.709: what every image inside the program has.
inline constexpr Primaries kRec709{{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}, kD65};
inline constexpr Primaries kRec601Of625Lines{{0.640, 0.330}, {0.290, 0.600}, {0.150, 0.060}, kD65};
inline constexpr Primaries kRec601Of525Lines{{0.630, 0.340}, {0.310, 0.595}, {0.155, 0.070}, kD65};
inline constexpr Primaries kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65};
inline constexpr Primaries kDisplayP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65};
inline constexpr Primaries kDciP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.314, 0.351}};
inline constexpr Primaries kAdobeRgb{{0.640, 0.330}, {0.210, 0.710}, {0.150, 0.060}, kD65};
/// SMPTE ST 2065-1 and the narrower ones of ACEScg.
inline constexpr Primaries kAcesAp0{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, kAcesWhite};
inline constexpr Primaries kAcesAp1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, kAcesWhite};
/// X, Y and Z themselves, as EXR files of CIE XYZ state them.
inline constexpr Primaries kCieXyz{{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}, {1.0 / 3.0, 1.0 / 3.0}};

/// Whether the primaries span a triangle, and make the white by finite shares.
bool arePossible(const Primaries& primaries);

/// Bradford's transform of XYZ from one white point to another.
glm::dmat3 adaptation(glm::dvec2 from_white, glm::dvec2 to_white);

/// The matrix that brings linear colours of other primaries to Rec.709. Where the white points
/// differ, colours are adapted by the Bradford transform, so that (1, 1, 1) stays (1, 1, 1).
///
/// returns  nothing where there is nothing to do: the primaries are Rec.709's, or they are none
///          (writers leave them all zero)
std::optional<glm::mat3> rec709FromPrimaries(const Primaries& primaries);

/// That matrix in double precision, of primaries that span a triangle with the white inside.
glm::dmat3 rec709Matrix(const Primaries& primaries);

/// How a file's samples stand for light.
struct TransferCurve {
  /// Light is the sample to this power: 1 is linear light, 2.2 the gamma of old pictures. Nothing: sRGB's curve.
  std::optional<double> power;
};

inline constexpr TransferCurve kLinearLight{1.0};
inline constexpr TransferCurve kSrgbCurve{};

/// A well-known name, else "red 0.61 0.33, green …".
std::string primariesName(const Primaries& primaries);

/// "sRGB", "linear", "gamma 1.8"
std::string curveName(const TransferCurve& curve);

/// What a file says of its colour and what was done about it, as `info` prints it: "sRGB"; "linear, Rec.709"; "linear,
/// primaries of the file (Rec.2020): converted". Well-known primaries are named, others written out.
///
/// stated   nothing: the file leaves them to its format, which means Rec.709
/// channels of the image; below 3 there is nothing to convert
std::string describeColor(const TransferCurve& curve, const std::optional<Primaries>& stated, int channels);

/// Brings linear colours of the primaries that a file states to Rec.709, where they are others and there are at least
/// three channels.
///
/// returns  whether that changed them
bool convertToRec709(Image& image, const std::optional<Primaries>& stated);

/// Multiplies the first three channels of every texel.
///
/// rounding  channels that are negative by less than this share of the greatest become 0
void transformColors(Image& image, const glm::mat3& matrix, float rounding = 0.0f);

}  // namespace mirrorball
