#include "mirrorball/codec/ldr/png_color.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "mirrorball/codec/color/icc_profile.h"

namespace mirrorball {
namespace {

constexpr std::array<png_byte, 5> kCicp{'c', 'I', 'C', 'P', 0};
constexpr png_byte kSrgbTransfer = 13;  // ITU-T H.273's number of IEC 61966-2-1
constexpr png_byte kRgbMatrix = 0;
constexpr png_byte kFullRange = 1;

/// gAMA holds the exponent from light to samples, times this.
constexpr double kGammaUnit = 100000.0;

/// What sRGB pictures are told to state for readers that do not know the sRGB chunk (PNG, 11.3.2.5).
constexpr int kGammaOfSrgb = 45455;

TransferCurve readCurve(png_const_structrp png, png_inforp info) {
  png_fixed_point gamma = 0;
  if (png_get_gAMA_fixed(png, info, &gamma) == 0 || gamma <= 0) return kSrgbCurve;
  // Some writers leave out the sRGB chunk, or round the number.
  constexpr int kRounding = 500;
  if (std::abs(gamma - kGammaOfSrgb) <= kRounding) return kSrgbCurve;
  return {kGammaUnit / gamma};
}

std::optional<Primaries> readPrimaries(png_const_structrp png, png_inforp info) {
  Primaries read;
  if (png_get_cHRM(png, info, &read.white.x, &read.white.y, &read.red.x, &read.red.y, &read.green.x, &read.green.y,
                   &read.blue.x, &read.blue.y) == 0)
    return {};
  return read;
}

/// What a chunk cICP says: four numbers of ITU-T H.273, of the primaries, the curve, the matrix and the range.
std::optional<CodedColor> readCodePoints(png_const_structrp png, png_inforp info) {
  png_unknown_chunkp chunks = nullptr;
  const int count = png_get_unknown_chunks(png, info, &chunks);
  for (int i = 0; i < count; ++i) {
    const png_unknown_chunk& chunk = chunks[i];
    const bool is_cicp = std::memcmp(chunk.name, kCicp.data(), kCicp.size()) == 0 && chunk.size == 4;
    if (is_cicp && chunk.data[2] == kRgbMatrix && chunk.data[3] == kFullRange)
      return codedColor(chunk.data[0], chunk.data[1]);
  }
  return {};
}

}  // namespace

void keepPngColor(png_structrp png) { png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, kCicp.data(), 1); }

CodedColor readPngColor(png_const_structrp png, png_inforp info) {
  if (const auto coded = readCodePoints(png, info)) return *coded;
  if (png_get_valid(png, info, PNG_INFO_sRGB) != 0) return {};
  png_charp name = nullptr;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  int compression = 0;
  if (png_get_iCCP(png, info, &name, &compression, &profile, &size) != 0)
    return codedColor(readIccProfile({profile, size}));
  return codedColor(readCurve(png, info), readPrimaries(png, info));
}

void writePngColor(png_structrp png, png_inforp info, OutputPrimaries primaries) {
  if (primaries == OutputPrimaries::rec709) return png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  std::array<png_byte, 4> code_points{static_cast<png_byte>(codePointOf(primaries)), kSrgbTransfer, kRgbMatrix,
                                      kFullRange};
  png_unknown_chunk chunk{};
  std::memcpy(chunk.name, kCicp.data(), kCicp.size());
  chunk.data = code_points.data();
  chunk.size = code_points.size();
  chunk.location = PNG_HAVE_IHDR;  // before palettes and texels
  keepPngColor(png);
  png_set_unknown_chunks(png, info, &chunk, 1);
  const Primaries& xy = chromaticitiesOf(primaries);
  png_set_cHRM(png, info, xy.white.x, xy.white.y, xy.red.x, xy.red.y, xy.green.x, xy.green.y, xy.blue.x, xy.blue.y);
  png_set_gAMA_fixed(png, info, kGammaOfSrgb);
}

}  // namespace mirrorball
