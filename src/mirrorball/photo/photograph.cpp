#include "mirrorball/photo/photograph.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_layers.h"

namespace mirrorball {
namespace {

/// Whether the codes may be a camera's, whose own response is to be found: those of sRGB and of powers.
bool isOfCamera(const CodedColor& color) {
  return color.transfer == Transfer::srgb || color.transfer == Transfer::gamma;
}

/// Takes up what a file of integers holds, if it is a camera's: codes, or codes that are proportional to light and need
/// no response. Of those all bits count, as the file has them, so that what was too bright for the camera is known by
/// them.
///
/// returns  whether it is
bool takeCodes(std::variant<PictureCodes, PictureFractions> read, Photograph& photograph) {
  auto* const codes = std::get_if<PictureCodes>(&read);
  std::visit([&](const auto& picture) { photograph.exif = picture.exif; }, read);
  if (codes && !isOfCamera(codes->color)) return false;
  if (codes)
    photograph.codes = std::move(codes->codes);
  else
    photograph.light = std::move(std::get<PictureFractions>(read).codes);
  photograph.is_clipped_at_1 = !codes;
  std::visit(
      [&](auto& picture) {
        photograph.color = std::move(picture.color);
        photograph.oddities = std::move(picture.oddities);
      },
      read);
  return true;
}

}  // namespace

Result<Photograph> readPhotograph(const std::filesystem::path& path, const std::string& layer) {
  Photograph photograph{.name = path.string(), .codes = {}, .light = {}};
  MIRRORBALL_TRY(bytes, readImageFile(path));
  if (holdsCodes(bytes) && layer.empty()) {
    MIRRORBALL_TRY(read, withName(photograph.name, decodeCodesOrFractions(bytes)));
    if (takeCodes(std::move(read), photograph)) return photograph;
  }
  MIRRORBALL_TRY(decoded, withName(photograph.name, decodeImage(bytes, {.layer = layer})));
  if (const NonFinite bad = findNonFinite(decoded.image); bad.count > 0)
    return fail(ErrorCode::non_finite, photograph.name + ": " + textOf(bad));
  photograph.light = std::move(decoded.image);
  photograph.oddities = withOtherLayer(std::move(decoded.oddities), decoded.layer_guess);
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
