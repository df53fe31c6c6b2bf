#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/bc6h/bc6h.h"
#include "mirrorball/codec/half_blocks/block_bits.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr.h"

namespace mirrorball::testing {

/// A kind of compressed blocks of half floats.
struct HalfBlockCodec {
  const char* name;
  TexelFormat format;
  const char* in_files;      ///< as `info` names it
  std::uint32_t vk_format;   ///< in KTX 2
  std::uint8_t color_model;  ///< of its data format descriptor
  bool (*encode)(std::span<const float> samples, int channels, int width, std::span<std::uint8_t> bytes);
  void (*decode_row)(const std::uint8_t* bytes, int begin, Image& image);
};

inline constexpr HalfBlockCodec kBc6hCodec{
    "bc6h",
    TexelFormat::bc6h,
    "bc6h ufloat",
    143,
    133,
    encodeBc6h,
    [](const std::uint8_t* bytes, int begin, Image& image) { decodeBc6hRow(bytes, false, begin, image); }};
inline constexpr HalfBlockCodec kUastcHdrCodec{
    "uastc_hdr",
    TexelFormat::uastc_hdr,
    "uastc hdr 4x4",
    1000066000,
    167,
    encodeUastcHdr,
    [](const std::uint8_t* bytes, int begin, Image& image) { EXPECT_EQ(decodeUastcHdrRow(bytes, begin, image), -1); }};

inline std::size_t halfBlockBytes(const Image& image) {
  return std::size_t((image.width() + 3) / 4) * std::size_t((image.height() + 3) / 4) * kHalfBlockSize;
}

inline Bytes encodedBlocks(const HalfBlockCodec& codec, const Image& image) {
  Bytes bytes(halfBlockBytes(image));
  EXPECT_TRUE(codec.encode(image.samples(), image.channels(), image.width(), bytes));
  return bytes;
}

inline Image throughBlocks(const HalfBlockCodec& codec, const Image& image) {
  const Bytes bytes = encodedBlocks(codec, image);
  Image decoded(image.width(), image.height(), 3);
  const std::size_t row = std::size_t((image.width() + 3) / 4) * kHalfBlockSize;
  for (int y = 0; y < image.height(); y += 4) codec.decode_row(bytes.data() + std::size_t(y / 4) * row, y, decoded);
  return decoded;
}

/// The greatest difference of a channel, as a share of its texel's brightest one.
inline float maxHalfError(const Image& found, const Image& expected) {
  float max = 0.0f;
  for (int y = 0; y < expected.height(); ++y)
    for (int x = 0; x < expected.width(); ++x) {
      const glm::vec3 light = rgbAt(expected, x, y);
      const glm::vec3 off = glm::abs(rgbAt(found, x, y) - light);
      max = std::max(max, std::max({off.x, off.y, off.z}) / std::max({light.x, light.y, light.z, 1e-4f}));
    }
  return max;
}

/// Light of many powers of two, of which neighbours know nothing.
inline Image octaveNoise(int width, int height, int channels = 3) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> exponent(-6.0f, 6.0f);
  Image image(width, height, channels);
  for (float& sample : image.samples()) sample = std::exp2(exponent(random));
  return image;
}

/// Red, green and blue rise from 0.5 at different rates, by a few percent a texel.
inline Image colorRamp(int width, int height, int channels = 3) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.texel(x, y)[c] = 0.5f * std::exp2(0.02f * static_cast<float>(x + 2 * y) + 0.3f * static_cast<float>(c));
  return image;
}

}  // namespace mirrorball::testing
