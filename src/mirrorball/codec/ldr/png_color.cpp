#include "mirrorball/codec/ldr/png_color.h"

#include <cstdlib>

#include "mirrorball/codec/color/icc_profile.h"

namespace mirrorball {
namespace {

/// gAMA holds the exponent from light to samples, times this.
constexpr double kGammaUnit = 100000.0;

TransferCurve readCurve(png_const_structrp png, png_inforp info) {
  png_fixed_point gamma = 0;
  if (png_get_gAMA_fixed(png, info, &gamma) == 0 || gamma <= 0) return kSrgbCurve;
  // 0.45455 is what sRGB pictures are told to state for readers that do not know the sRGB chunk (PNG, 11.3.2.5); some
  // writers leave out the chunk, or round the number.
  constexpr int kOfSrgb = 45455;
  constexpr int kRounding = 500;
  if (std::abs(gamma - kOfSrgb) <= kRounding) return kSrgbCurve;
  return {kGammaUnit / gamma};
}

std::optional<Primaries> readPrimaries(png_const_structrp png, png_inforp info) {
  Primaries read;
  if (png_get_cHRM(png, info, &read.white.x, &read.white.y, &read.red.x, &read.red.y, &read.green.x, &read.green.y,
                   &read.blue.x, &read.blue.y) == 0)
    return {};
  return read;
}

}  // namespace

PngColor readPngColor(png_const_structrp png, png_inforp info) {
  if (png_get_valid(png, info, PNG_INFO_sRGB) != 0) return {};
  png_charp name = nullptr;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  int compression = 0;
  if (png_get_iCCP(png, info, &name, &compression, &profile, &size) != 0)
    return {kSrgbCurve, {}, iccDescription({profile, size})};
  return {readCurve(png, info), readPrimaries(png, info), {}};
}

std::string describeColor(const PngColor& color, int channels) {
  if (!color.icc_description.empty()) return describeIccColor(color.icc_description);
  return describeColor(color.curve, color.primaries, channels);
}

}  // namespace mirrorball
