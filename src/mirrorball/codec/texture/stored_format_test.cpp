#include "mirrorball/codec/texture/stored_format.h"

#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/codec/color/shared_exponent.h"
#include "mirrorball/image/small_float.h"

namespace mirrorball {
namespace {

/// The specification's text, word by word, in double precision.
std::uint32_t sharedExponentBySpecification(glm::dvec3 color) {
  constexpr int kN = 9;
  constexpr int kB = 15;
  const double max_c = std::max({color.x, color.y, color.z});
  const double log2 = max_c > 0.0 ? std::floor(std::log2(max_c)) : -1000.0;
  const int exp_shared_p = static_cast<int>(std::max<double>(-kB - 1, log2)) + 1 + kB;
  const double max_s = std::floor(max_c / std::exp2(exp_shared_p - kB - kN) + 0.5);
  const int exp_shared = max_s == 512.0 ? exp_shared_p + 1 : exp_shared_p;
  const auto mantissa = [&](double c) {
    return static_cast<std::uint32_t>(std::floor(c / std::exp2(exp_shared - kB - kN) + 0.5));
  };
  return mantissa(color.x) | mantissa(color.y) << 9 | mantissa(color.z) << 18 |
         static_cast<std::uint32_t>(exp_shared) << 27;
}

TEST(SharedExponent, EncodesAsTheSpecificationSays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> exponent(-30.0f, 15.99f);
  for (int i = 0; i < 200000; ++i) {
    const glm::vec3 color(std::exp2(exponent(random)), std::exp2(exponent(random)), std::exp2(exponent(random)));
    ASSERT_EQ(sharedExponentFromColor(color), sharedExponentBySpecification(color))
        << color.x << " " << color.y << " " << color.z;
  }
}

/// Halves of the last bit, where rounding decides, and the floats beside them: at every exponent.
TEST(SharedExponent, RoundsHalvesUpAndCarries) {
  for (int exponent = -17; exponent < 16; ++exponent)
    for (int step = 0; step < 1024; ++step) {
      const float middle = std::ldexp(1.0f + static_cast<float>(step) / 1024.0f, exponent);
      for (const float value : {std::nextafter(middle, 0.0f), middle, std::nextafter(middle, 1e6f)})
        if (value <= kLargestSharedExponent) {
          const glm::vec3 color(value, value / 3.0f, 0.0f);
          ASSERT_EQ(sharedExponentFromColor(color), sharedExponentBySpecification(color)) << value;
        }
    }
  EXPECT_EQ(sharedExponentFromColor(glm::vec3(0.0f)), 0u);
  EXPECT_EQ(sharedExponentFromColor(glm::vec3(kLargestSharedExponent)), 0xffffffffu);
  // Just below ½ of the last bit: adding ½ in single precision would round up.
  EXPECT_EQ(sharedExponentFromColor({std::ldexp(0.49999997f, -24), 0.0f, 0.0f}), 0u);
}

/// Decoding is exact, and what has been decoded is encoded to the same value again: all mantissas of one channel at
/// every exponent.
TEST(SharedExponent, DecodesEveryMantissaAndExponent) {
  for (std::uint32_t exponent = 0; exponent < 32; ++exponent)
    for (std::uint32_t mantissa = 0; mantissa < 512; ++mantissa) {
      const std::uint32_t bits = exponent << 27 | mantissa << 18 | (511 - mantissa) << 9 | mantissa / 2;
      const glm::vec3 color = colorFromSharedExponent(bits);
      ASSERT_EQ(color.z, std::ldexp(static_cast<float>(mantissa), static_cast<int>(exponent) - 24));
      ASSERT_EQ(color.y, std::ldexp(static_cast<float>(511 - mantissa), static_cast<int>(exponent) - 24));
      ASSERT_EQ(color.x, std::ldexp(static_cast<float>(mantissa / 2), static_cast<int>(exponent) - 24));
      ASSERT_EQ(colorFromSharedExponent(sharedExponentFromColor(color)), color);
    }
}

Bytes packed(TexelFormat format, std::vector<float> samples, int channels) {
  Bytes bytes(samples.size() / std::size_t(channels) * blockSize(storedFormat(format)));
  EXPECT_TRUE(packTexels(format, samples, channels, 1, bytes));
  return bytes;
}

TEST(StoredFormat, EveryPackedFloatComesBack) {
  for (std::uint32_t code = 0; code < 2048; ++code) {
    // The blue code has one bit less.
    const std::uint32_t bits = code | (2047 - code) << 11 | code / 2 << 22;
    std::array<std::uint8_t, 4> bytes;
    std::memcpy(bytes.data(), &bits, 4);
    const Image image = *unpackTexels({SampleType::b10g11r11, 3}, bytes.data(), 4, 1, 1);
    const float* color = image.texel(0, 0);
    const float red = floatFromHalf(static_cast<std::uint16_t>(code << 4));
    EXPECT_TRUE(color[0] == red || (std::isnan(color[0]) && std::isnan(red))) << code;
    if (std::isnan(color[0]) || std::isnan(color[1]) || std::isnan(color[2])) continue;
    const Bytes again = packed(TexelFormat::b10g11r11, {color[0], color[1], color[2]}, 3);
    EXPECT_EQ(std::memcmp(again.data(), bytes.data(), 4), 0) << code;
  }
}

TEST(StoredFormat, GreyAndAlphaFindTheirPlaces) {
  // 1 is 3c00 as a half, 2 is 4000, ½ is 3800; the lower byte comes first.
  const Bytes grey{0x00, 0x40, 0x00, 0x40, 0x00, 0x40, 0x00, 0x3c};
  EXPECT_EQ(packed(TexelFormat::half, {2.0f}, 1), grey);
  EXPECT_EQ(packed(TexelFormat::half, {2.0f, 2.0f, 2.0f}, 3), grey);
  EXPECT_EQ(packed(TexelFormat::half, {2.0f, 2.0f, 2.0f, 0.5f}, 4),
            (Bytes{0x00, 0x40, 0x00, 0x40, 0x00, 0x40, 0x00, 0x38}));
  const Bytes red_and_green{0x00, 0x40, 0x00, 0x38};
  EXPECT_EQ(packed(TexelFormat::rg_half, {2.0f, 0.5f}, 2), red_and_green);
  EXPECT_EQ(packed(TexelFormat::rg_half, {2.0f, 0.5f, 1e9f}, 3), red_and_green);
  EXPECT_EQ(packed(TexelFormat::rg_half, {2.0f, 0.5f, 1.0f, 1.0f}, 4), red_and_green);
}

struct Stored {
  StoredFormat format;
  Bytes bytes;
  std::vector<float> light;
};

/// One texel of each kind that is read, by hand.
TEST(StoredFormat, DecodesEveryKind) {
  const float dark = formula::linearFromSrgb1(51.0f / 255.0f);
  const std::vector<Stored> kinds = {
      {{SampleType::unorm8, 1}, {51}, {0.2f}},
      {{SampleType::srgb8, 1}, {51}, {dark}},
      {{SampleType::unorm8, 2}, {51, 255}, {0.2f, 1.0f, 0.0f}},
      {{SampleType::unorm8, 3}, {51, 255, 0}, {0.2f, 1.0f, 0.0f}},
      {{SampleType::unorm8, 3, true}, {51, 255, 0}, {0.0f, 1.0f, 0.2f}},
      {{SampleType::srgb8, 4}, {51, 255, 0, 51}, {dark, 1.0f, 0.0f, 0.2f}},
      {{SampleType::srgb8, 4, true}, {51, 255, 0, 51}, {0.0f, 1.0f, dark, 0.2f}},
      {{SampleType::srgb8, 4, true, true}, {51, 255, 0, 51}, {0.0f, 1.0f, dark}},
      {{SampleType::unorm16, 3}, {0x33, 0x33, 0xff, 0xff, 0, 0}, {0.2f, 1.0f, 0.0f}},
      {{SampleType::half, 1}, {0x00, 0xc0}, {-2.0f}},
      {{SampleType::half, 2}, {0x00, 0xc0, 0x00, 0x3c}, {-2.0f, 1.0f, 0.0f}},
      {{SampleType::half, 3}, {0x00, 0xc0, 0x00, 0x3c, 0x01, 0x00}, {-2.0f, 1.0f, 0x1p-24f}},
      {{SampleType::float32, 1}, {0, 0, 0x80, 0x3f}, {1.0f}},
      // Red 1 is exponent 15 and mantissa 0 in 11 bits (3c0), green 2 is 400, blue ½ is 1c0 in 10 bits.
      {{SampleType::b10g11r11, 3}, {0xc0, 0x03, 0x20, 0x70}, {1.0f, 2.0f, 0.5f}},
      // The exponent 16 makes a mantissa's unit 2⁻⁸: 256, 128 and 64 are 1, ½ and ¼.
      {{SampleType::e5b9g9r9, 3}, {0x00, 0x01, 0x01, 0x81}, {1.0f, 0.5f, 0.25f}},
  };
  for (const Stored& kind : kinds) {
    ASSERT_EQ(kind.bytes.size(), blockSize(kind.format)) << formatName(kind.format);
    const Image image = *unpackTexels(kind.format, kind.bytes.data(), kind.bytes.size(), 1, 1);
    EXPECT_EQ(std::vector<float>(image.samples().begin(), image.samples().end()), kind.light)
        << formatName(kind.format);
  }
}

TEST(StoredFormat, IsNamedAsInVulkan) {
  EXPECT_EQ(formatName({SampleType::half, 4}), "r16g16b16a16 sfloat");
  EXPECT_EQ(formatName({SampleType::srgb8, 4, true, true}), "b8g8r8x8 srgb");
  EXPECT_EQ(formatName({SampleType::unorm16, 1}), "r16 unorm");
  EXPECT_EQ(formatName({SampleType::e5b9g9r9, 3}), "e5b9g9r9 ufloat");
}

}  // namespace
}  // namespace mirrorball
