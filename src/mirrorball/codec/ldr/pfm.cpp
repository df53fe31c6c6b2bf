#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/decimal_comma.h"
#include "mirrorball/codec/ldr/pnm.h"
#include "mirrorball/codec/ldr/pnm_header.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// The number whose sign is the byte order, − for little-endian, and whose size is the samples' unit.
Result<float> readScale(PnmWords& words, std::vector<std::string>& oddities) {
  const std::string_view word = words.word();
  auto scale = parseNumber(word);
  if (!scale) {
    scale = parseDecimalComma(word);
    if (scale) oddities.emplace_back("its scale has a decimal comma: read as a point");
  }
  if (!scale || !std::isnormal(static_cast<float>(*scale)))
    return words.failure("the scale should be a number other than 0", word);
  return static_cast<float>(*scale);
}

/// Bytes of the letters that a file begins with: "PF", "Pf", or "PF4", which has alpha; 0 where it has others.
std::size_t signatureSize(Span bytes) {
  if (bytes.size() < 3 || bytes[0] != 'P' || (bytes[1] != 'F' && bytes[1] != 'f')) return 0;
  return bytes[1] == 'F' && bytes[2] == '4' ? 3 : 2;
}

}  // namespace

bool isPfm(Span bytes) {
  const std::size_t size = signatureSize(bytes);
  return size > 0 && bytes.size() > size && (bytes[size] == ' ' || (bytes[size] >= '\t' && bytes[size] <= '\r'));
}

Result<DecodedImage> decodePfm(Span bytes) {
  constexpr std::uint32_t kMaxSide = 1u << 30;
  PnmWords words(bytes);
  const std::size_t signature = signatureSize(bytes);
  words.skip(signature);
  MIRRORBALL_TRY(width, words.number("the width", kMaxSide));
  MIRRORBALL_TRY(height, words.number("the height", kMaxSide));
  std::vector<std::string> oddities;
  MIRRORBALL_TRY(scale, readScale(words, oddities));
  const int channels = signature == 3 ? 4 : bytes[1] == 'F' ? 3 : 1;
  MIRRORBALL_TRY_VOID(checkDimensions(width, height));
  const std::uint64_t row = sizeof(float) * std::uint64_t(channels) * width;
  MIRRORBALL_TRY(has_cr_lf, words.endHeader(row * height));
  if (has_cr_lf) oddities.push_back(PnmWords::crLfText());
  MIRRORBALL_TRY_VOID(checkImageMemory(static_cast<int>(width), static_cast<int>(height), channels));
  const Span stored = bytes.subspan(words.position());
  if (!mayBeLeftOf(row * height, stored.size())) return cannotHold(width, height, bytes.size());
  const auto rows = static_cast<int>(std::min<std::uint64_t>(stored.size() / row, height));
  if (rows == 0) return endsInFirstRow(bytes.size());

  Image image = Image::withoutValues(static_cast<int>(width), static_cast<int>(height), channels);
  const std::uint8_t* from = stored.data();
  for (int y = image.height() - 1; y >= image.height() - rows; --y)
    for (std::size_t i = 0; float& sample : image.row(y)) {
      const bool is_alpha = channels == 4 && i++ % 4 == 3;
      sample = bitCast<float>(scale < 0.0f ? littleU32(from) : bigU32(from)) * (is_alpha ? 1.0f : std::abs(scale));
      from += sizeof(float);
    }
  blackenMissingRows(image, rows, /*from_top=*/false, oddities);
  std::string format =
      std::string(channels == 4 ? "PFM with alpha, " : "PFM, ") + (scale < 0.0f ? "little" : "big") + "-endian";
  if (std::abs(scale) != 1.0f) format += ", scaled by " + formatNumber(static_cast<double>(std::abs(scale)));
  DecodedImage decoded{std::move(image), {}, std::move(format), describeColor(kLinearLight, {}, channels)};
  decoded.oddities = std::move(oddities);
  return decoded;
}

}  // namespace mirrorball
