#pragma once

#include <optional>
#include <string>

#include <png.h>

#include "mirrorball/codec/color/primaries.h"

namespace mirrorball {

/// What a PNG says of its colour.
struct PngColor {
  TransferCurve curve = kSrgbCurve;
  std::optional<Primaries> primaries;
  std::string icc_description;  ///< of an ICC profile, which is not applied; empty: there is none
};

/// Reads the chunks sRGB, gAMA and cHRM; with none of them the picture is sRGB. Beside the profile of an iCCP chunk the
/// last two mean nothing.
///
/// info     as png_read_info has left it
/// from     PNG (third edition), 11.3.2 "Colour space information"
PngColor readPngColor(png_const_structrp png, png_inforp info);

/// What `info` says of it.
std::string describeColor(const PngColor& color, int channels);

}  // namespace mirrorball
