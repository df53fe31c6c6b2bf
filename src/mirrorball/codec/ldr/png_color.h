#pragma once

#include <png.h>

#include "mirrorball/codec/color/coded_color.h"

namespace mirrorball {

/// Has the chunk cICP kept for readPngColor; before png_read_info.
void keepPngColor(png_structrp png);

/// Reads the chunks cICP, sRGB, iCCP, gAMA and cHRM, of which each makes those behind it mean nothing but that the last
/// two go together; with none of them the picture is sRGB. A cICP of other codes than RGB in full range is passed over.
///
/// info     as png_read_info has left it
/// from     PNG (third edition), 11.3.2 "Colour space information"
CodedColor readPngColor(png_const_structrp png, png_inforp info);

/// States sRGB's curve with these primaries; for those that are not Rec.709's by cICP, with cHRM and gAMA for readers
/// that do not know it. Before png_write_info.
///
/// primaries  not ACEScg's
void writePngColor(png_structrp png, png_inforp info, OutputPrimaries primaries);

}  // namespace mirrorball
