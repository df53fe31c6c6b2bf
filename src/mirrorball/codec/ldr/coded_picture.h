#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture of integers as its file holds it: 1 (grey), 3 or 4 channels, alpha straight, 8 or 16 bits a sample.
using CodedPicture = std::variant<Image8, ImageOf<std::uint16_t>>;

/// Refuses a picture whose samples, as codes and as light at the same time, would take more memory than may be used.
///
/// sample_bytes  of a code
/// errors        too_large
Result<void> checkPictureMemory(int width, int height, int channels, int sample_bytes);

/// The error for a file too small for the size that it says it has.
tl::unexpected<Error> cannotHold(long long width, long long height, std::size_t bytes);

/// Linear light of the codes, with Rec.709's primaries.
Image lightOf(const CodedPicture& picture, const CodedColor& color = {});

/// The codes as shares of the greatest one.
Image sharesOf(const CodedPicture& picture);

/// The codes as a texture has them: RGBA of 8 bits, 16 rounded to the nearest; alpha 255 where the picture has none.
Image8 textureOf(CodedPicture picture);

/// Divides the colours by alpha, of a picture that holds them multiplied by it; where alpha is 0, they stay.
void makeStraight(CodedPicture& picture);

/// A code from 0 to `max` as the nearest from 0 to `new_max`.
inline std::uint32_t rescaledCode(std::uint32_t code, std::uint32_t max, std::uint32_t new_max) {
  return static_cast<std::uint32_t>((std::uint64_t{code} * new_max + max / 2) / max);
}

}  // namespace mirrorball
