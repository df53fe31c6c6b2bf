#include "mirrorball/codec/color/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/bit_cast.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerPiece = 32;

float lightOf(float sample, const TransferCurve& curve) {
  if (!curve.power) return formula::linearFromSrgb1(sample);
  return static_cast<float>(std::pow(static_cast<double>(sample), *curve.power));
}

/// Linear light of every code of `Bits` bits.
template <int Bits>
std::vector<float> decodeTable(const TransferCurve& curve) {
  constexpr std::size_t kCodes = std::size_t{1} << Bits;
  std::vector<float> light(kCodes);
  for (std::size_t code = 0; code < kCodes; ++code)
    light[code] = lightOf(static_cast<float>(code) / static_cast<float>(kCodes - 1), curve);
  return light;
}

template <int Bits, typename Code>
Image decode(std::span<const Code> samples, int width, int height, int channels, const TransferCurve& curve) {
  Image image = Image::withoutValues(width, height, channels);
  static const std::vector<float> srgb = decodeTable<Bits>(kSrgbCurve);
  const std::vector<float> of_power = curve.power ? decodeTable<Bits>(curve) : std::vector<float>();
  const std::vector<float>& table = curve.power ? of_power : srgb;
  constexpr float kLargest = static_cast<float>((1 << Bits) - 1);
  const std::size_t row_length = std::size_t(width) * std::size_t(channels);
  parallelFor(std::size_t(height), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * row_length; i < end * row_length; ++i) image.samples()[i] = table[samples[i]];
    if (channels < 4) return;
    for (std::size_t i = begin * row_length + 3; i < end * row_length; i += 4)
      image.samples()[i] = static_cast<float>(samples[i]) / kLargest;
  });
  return image;
}

/// Finds the code of a light without a power function. The codes' boundaries (of a dither level with the threshold t,
/// the lights that encode to k + 1 − t; t = ½ rounds to the nearest code) ascend, so the code is how many of them lie
/// at or below the light. A table over the light's exponent and its first 7 mantissa bits has the least code of all
/// levels for the lower end of such an interval. The interval spans less than one code (near white, where it is widest
/// in codes, 255/2.4/128 = 0.83), and the levels differ by less than one, so at most two steps follow.
class Encoder {
 public:
  /// thresholds  ascending
  explicit Encoder(const std::vector<float>& thresholds) : boundaries_(thresholds.size()) {
    for (std::size_t level = 0; level < thresholds.size(); ++level)
      for (std::size_t k = 0; k < boundaries_[level].size(); ++k)
        boundaries_[level][k] = formula::linearFromSrgb1((static_cast<float>(k) + 1.0f - thresholds[level]) / 255.0f);
    const Boundaries& highest = boundaries_.front();
    for (std::size_t interval = 0; interval < least_codes_.size(); ++interval) {
      const float lower = bitCast<float>(static_cast<std::uint32_t>((interval + kFirstInterval) << kDroppedBits));
      const auto above = std::upper_bound(highest.begin(), highest.end(), lower);
      least_codes_[interval] = static_cast<std::uint8_t>(above - highest.begin());
    }
  }

  std::uint8_t encode(float light, std::size_t level) const {
    if (!(light >= kSmallest)) return 0;  // so that NaN becomes 0
    if (light >= 1.0f) return 255;
    const std::size_t interval = (bitCast<std::uint32_t>(light) >> kDroppedBits) - kFirstInterval;
    std::uint8_t code = least_codes_[interval];
    while (code < 255 && light >= boundaries_[level][code]) ++code;
    return code;
  }

 private:
  static constexpr int kDroppedBits = 23 - 7;
  static constexpr float kSmallest = 0x1p-19f;  // below the first boundary of all levels, 1/128/255/12.92 = 2.4e-6
  static constexpr std::uint32_t kFirstInterval = bitCast<std::uint32_t>(kSmallest) >> kDroppedBits;
  static constexpr std::size_t kIntervals = (bitCast<std::uint32_t>(1.0f) >> kDroppedBits) - kFirstInterval;
  using Boundaries = std::array<float, 255>;

  std::vector<Boundaries> boundaries_;  ///< of each level
  std::array<std::uint8_t, kIntervals> least_codes_;
};

const Encoder& nearestEncoder() {
  static const Encoder instance({0.5f});
  return instance;
}

const Encoder& ditheringEncoder() {
  static const Encoder instance([] {
    std::vector<float> thresholds;
    for (int level = 0; level < formula::kDitherLevels; ++level) thresholds.push_back(formula::ditherThreshold(level));
    return thresholds;
  }());
  return instance;
}

std::uint8_t alpha8(float alpha) {
  if (!(alpha > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::min(alpha, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

Image linearFromPicture(const Image8& picture, const TransferCurve& curve) {
  return decode<8>(picture.samples(), picture.width(), picture.height(), picture.channels(), curve);
}

Image linearFromSamples16(std::span<const std::uint16_t> samples, int width, int height, int channels,
                          const TransferCurve& curve) {
  return decode<16>(samples, width, height, channels, curve);
}

Image8 pictureFromLinear(const Image& image, int channels, Dither dither) {
  Image8 picture(image.width(), image.height(), channels);
  const bool dithers = dither == Dither::pattern;
  const Encoder& encoder = dithers ? ditheringEncoder() : nearestEncoder();
  parallelFor(std::size_t(image.height()), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < image.width(); ++x) {
        const float* light = image.texel(x, static_cast<int>(y));
        std::uint8_t* code = picture.texel(x, static_cast<int>(y));
        const auto level = dithers ? std::size_t(formula::ditherLevel({x, static_cast<int>(y)})) : 0;
        for (int c = 0; c < channels; ++c) code[c] = c == 3 ? alpha8(light[c]) : encoder.encode(light[c], level);
      }
  });
  return picture;
}

std::uint8_t srgb8FromLinear(float light) { return nearestEncoder().encode(light, 0); }

}  // namespace mirrorball
