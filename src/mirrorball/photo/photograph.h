#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A photograph as the camera stored it, upright. It is either codes, whose light is known only through a response
/// curve (response.h), or already linear light.
struct Photograph {
  std::string name;  ///< the file, for messages
  Image8 codes;      ///< 4 channels, RGB as stored; empty where the file says what light it holds
  Image light;       ///< linear light of such a file, with the primaries of `color`; else empty
  Exif exif = {};
  CodedColor color = {};                   ///< of the codes, whose camera may not keep to the curve, or of the light
  bool is_clipped_at_1 = false;            ///< the light is linear codes as a camera has them, and 1 the greatest
  std::vector<std::string> oddities = {};  ///< what is unusual in the file and how it was read; lines without its name

  int width() const { return codes.empty() ? light.width() : codes.width(); }
  int height() const { return codes.empty() ? light.height() : codes.height(); }
  /// Of its picture.
  std::uint64_t bytes() const { return codes.samples().size_bytes() + light.samples().size_bytes(); }
};

/// Reads a photograph, upright. Integers of 16 bits are rounded to 8, but for those that the file says are proportional
/// to light. Floats are linear light, and so are codes of PQ, HLG and other curves that are not a camera's.
///
/// layer    of a file of several pictures (ImageReadOptions::layer); empty: the picture
/// errors   whatever the codec finds; non_finite in linear light
Result<Photograph> readPhotograph(const std::filesystem::path& path, const std::string& layer = {});

/// How much light reaches the sensor for the same scene, relative to others of the series: time · ISO / f-number². A
/// factor that is missing in one photograph, such as the f-number of a manual lens, is left out for the whole series.
///
/// photographs  of one series
/// returns      one exposure a photograph [s]
/// errors       usage: a photograph without an exposure time, and what to do
Result<std::vector<double>> exposuresFromExif(std::span<const Photograph> photographs);

/// The focal length in pixels that EXIF's 35 mm equivalent means in a picture of that size; 0 when it does not say.
///
/// from     CIPA DCG-001: equivalence is of the diagonal, 43.27 mm of the 36 × 24 mm frame
double focalLengthFromExif(const Exif& exif, int width, int height);

}  // namespace mirrorball
