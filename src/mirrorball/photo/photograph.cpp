#include "mirrorball/photo/photograph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_layers.h"

namespace mirrorball {
namespace {

/// Whether the codes may be a camera's, whose own response is to be found: those of sRGB and of powers.
bool isOfCamera(const CodedColor& color) {
  return color.transfer == Transfer::srgb || color.transfer == Transfer::gamma;
}

/// Codes that are proportional to light need no response: all their bits count, as the file has them, so that what
/// was too bright for the camera is still known by it.
Result<Photograph> withLinearCodes(Photograph photograph, std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(read, withName(photograph.name, decodeCodeFractions(bytes)));
  photograph.light = std::move(read.codes);
  photograph.color = std::move(read.color);
  photograph.oddities = std::move(read.oddities);
  photograph.is_clipped_at_1 = true;
  return photograph;
}

}  // namespace

Result<Photograph> readPhotograph(const std::filesystem::path& path, const std::string& layer) {
  Photograph photograph{.name = path.string(), .codes = {}, .light = {}};
  MIRRORBALL_TRY(bytes, readImageFile(path));
  if (holdsCodes(bytes) && layer.empty()) {
    MIRRORBALL_TRY(read, withName(photograph.name, decodeCodes(bytes)));
    photograph.exif = read.exif;
    if (isOfCamera(read.color)) {
      photograph.codes = std::move(read.codes);
      photograph.color = std::move(read.color);
      photograph.oddities = std::move(read.oddities);
      return photograph;
    }
    if (read.color.transfer == Transfer::linear) return withLinearCodes(std::move(photograph), bytes);
  }
  MIRRORBALL_TRY(decoded, withName(photograph.name, decodeImage(bytes, {.layer = layer})));
  if (const NonFinite bad = findNonFinite(decoded.image); bad.count > 0)
    return fail(ErrorCode::non_finite, photograph.name + ": " + textOf(bad));
  photograph.light = std::move(decoded.image);
  photograph.oddities = withOtherLayer(std::move(decoded.oddities), decoded.is_layer_guessed);
  return photograph;
}

Result<std::vector<double>> exposuresFromExif(std::span<const Photograph> photographs) {
  for (const Photograph& photograph : photographs)
    if (!photograph.exif.exposure_time_s)
      return fail(ErrorCode::usage, photograph.name + ": has no exposure time in its EXIF", FixHint::give_exposures);
  const auto all = [&](auto member) {
    return std::all_of(photographs.begin(), photographs.end(),
                       [&](const Photograph& p) { return (p.exif.*member).has_value(); });
  };
  const bool all_iso = all(&Exif::iso);
  const bool all_f_numbers = all(&Exif::f_number);
  std::vector<double> exposures;
  for (const Photograph& photograph : photographs) {
    double exposure = *photograph.exif.exposure_time_s;
    if (all_iso) exposure *= *photograph.exif.iso / 100.0;
    if (all_f_numbers) exposure /= *photograph.exif.f_number * *photograph.exif.f_number;
    exposures.push_back(exposure);
  }
  return exposures;
}

double focalLengthFromExif(const Exif& exif, int width, int height) {
  constexpr double kDiagonal_mm = 43.2666;
  return exif.focal_length_35mm.value_or(0.0) / kDiagonal_mm * std::hypot(width, height);
}

}  // namespace mirrorball
