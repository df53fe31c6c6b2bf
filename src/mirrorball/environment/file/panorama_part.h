#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// The part of a panorama that a picture shows, between two meridians and two parallels, in shares of the whole: of the
/// circle, from the panorama's left edge, and of the way from the zenith to the nadir. A part that goes on across the
/// panorama's right edge, at its left, ends beyond 1.
struct PanoramaPart {
  glm::dvec2 begin{0.0};
  glm::dvec2 end{1.0};

  bool isWhole() const { return begin == glm::dvec2(0.0) && end == glm::dvec2(1.0); }
  bool crossesSeam() const { return end.x > 1.0; }
  /// Whether it is the whole circle, at whichever meridian it begins.
  bool goesRound() const { return end.x - begin.x > 1.0 - 1e-9; }
  bool showsAll() const { return goesRound() && end.y - begin.y == 1.0; }
};

/// A rectangle of a panorama's texels, as a file states it.
struct PanoramaArea {
  glm::ivec2 corner{0};  ///< its upper left texel
  glm::ivec2 size{0};
  glm::ivec2 whole{0};  ///< size of the panorama
};

/// Whether a picture of that size is meant as a whole panorama, if as any: 2:1, or one or two rows or columns off, as
/// programs that scale or crop by an odd number leave it.
bool isNearlyWholePanorama(glm::ivec2 size);

/// errors   bad_shape: the area is empty, higher or wider than the whole, or begins beyond it, or that is not nearly
///          2:1. Says what of it
Result<PanoramaPart> panoramaPart(const PanoramaArea& area);

/// The same where the whole may be wider than 2:1, as programs state it that know of no more than the strip which they
/// made: the whole circle, with the horizon in the middle of its height.
Result<PanoramaPart> panoramaPartOfStrip(const PanoramaArea& area);

/// Whether that is another part than panoramaPart's.
bool isStrip(const PanoramaArea& area);

/// A part in words: "crop=X,Y,W,H/FULLWxFULLH", in texels of the panorama as it was cropped, or "fov=HxV", in degrees
/// around its middle.
///
/// errors   usage
Result<PanoramaPart> panoramaPartNamed(std::string_view word);

/// The height of the whole panorama that loses nothing of a picture of a part of it.
///
/// returns  nothing where the picture has not the part's proportion, to 3 %, or the panorama were too high for an int
std::optional<int> heightOfWhole(glm::ivec2 picture, const PanoramaPart& part);

/// "180 x 90 degrees"
std::string textOf(const PanoramaPart& part);

/// The share of the sphere that the part of a panorama takes which a picture's window is, in [0, 1].
///
/// goes_round  beyond the panorama's right edge the window goes on at its left, and is not cut off
double shareOfSphere(const PictureWindow& window, bool goes_round = false);

/// Where the window of a picture lies in the panorama of which that picture is a part.
///
/// whole    size of the panorama
PictureWindow windowInPanorama(const PictureWindow& window, const PanoramaPart& part, glm::ivec2 whole);

/// A whole panorama, 2:1, with a picture in its place and black around it. Texels are moved where the panorama's are
/// the picture's; else they are interpolated (bicubic).
///
/// part     whose proportion the picture has; it does not cross the seam
/// window   becomes what the picture takes of the panorama, to the nearest texel; `source` stays
/// errors   too_large
Result<Image> placedInPanorama(Image picture, const PanoramaPart& part, PictureWindow& window);

/// Moves the columns of a panorama to the right; those that leave it there come in at the left.
///
/// columns  from 0 to its width
void turnColumns(Image& panorama, int columns);

/// Continues the light of a panorama smoothly from the edge of what is known into the rest, as `continueSmoothly` does,
/// with a detail of 1.4 degrees.
///
/// known    window of the panorama that holds light
/// errors   bad_shape: it is too small to be continued
Result<void> fillAround(const PictureWindow& known, Image& panorama);

}  // namespace mirrorball
