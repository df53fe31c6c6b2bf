#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/codec/color/dither.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Linear light of an encoded 8-bit picture of 1, 3 or 4 channels. A fourth channel is alpha, which
/// is not encoded.
Image linearFromPicture(const Image8& picture, const TransferCurve& curve = kSrgbCurve);

/// The same of 16-bit samples.
///
/// samples  width · height · channels, in the machine's byte order
Image linearFromSamples16(std::span<const std::uint16_t> samples, int width, int height, int channels,
                          const TransferCurve& curve = kSrgbCurve);

/// Encodes linear light to sRGB: clipped to [0, 1]; NaN becomes 0. A fourth channel, alpha, is rounded to the nearest
/// code.
///
/// channels how many of the image's channels the picture gets, from the first
Image8 pictureFromLinear(const Image& image, int channels, Dither dither = Dither::none);

/// The sRGB code nearest to `light` in encoded terms.
std::uint8_t srgb8FromLinear(float light);

}  // namespace mirrorball
