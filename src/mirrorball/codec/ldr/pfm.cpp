#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/decimal_comma.h"
#include "mirrorball/codec/ldr/pnm.h"
#include "mirrorball/codec/ldr/pnm_header.h"

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

}  // namespace

bool isPfm(Span bytes) {
  return bytes.size() >= 3 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') &&
         (bytes[2] == ' ' || (bytes[2] >= '\t' && bytes[2] <= '\r'));
}

Result<DecodedImage> decodePfm(Span bytes) {
  constexpr std::uint32_t kMaxSide = 1u << 30;
  PnmWords words(bytes);
  words.skip(2);
  MIRRORBALL_TRY(width, words.number("the width", kMaxSide));
  MIRRORBALL_TRY(height, words.number("the height", kMaxSide));
  std::vector<std::string> oddities;
  MIRRORBALL_TRY(scale, readScale(words, oddities));
  const int channels = bytes[1] == 'F' ? 3 : 1;
  MIRRORBALL_TRY_VOID(checkDimensions(width, height));
  MIRRORBALL_TRY(has_cr_lf, words.endHeader(sizeof(float) * std::uint64_t(channels) * width * height));
  if (has_cr_lf) oddities.push_back(PnmWords::crLfText());
  MIRRORBALL_TRY_VOID(checkImageMemory(static_cast<int>(width), static_cast<int>(height), channels));
  const Span stored = bytes.subspan(words.position());
  if (stored.size() / sizeof(float) / std::size_t(channels) / width < height)
    return cannotHold(width, height, bytes.size());

  Image image = Image::withoutValues(static_cast<int>(width), static_cast<int>(height), channels);
  const std::uint8_t* from = stored.data();
  for (int y = image.height() - 1; y >= 0; --y)
    for (float& sample : image.row(y)) {
      sample = bitCast<float>(scale < 0.0f ? littleU32(from) : bigU32(from)) * std::abs(scale);
      from += sizeof(float);
    }
  std::string format = std::string("PFM, ") + (scale < 0.0f ? "little" : "big") + "-endian";
  if (std::abs(scale) != 1.0f) format += ", scaled by " + formatNumber(static_cast<double>(std::abs(scale)));
  DecodedImage decoded{std::move(image), {}, std::move(format), describeColor(kLinearLight, {}, channels)};
  decoded.oddities = std::move(oddities);
  return decoded;
}

}  // namespace mirrorball
