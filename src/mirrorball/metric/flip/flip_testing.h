#pragma once

#include <algorithm>
#include <cstdint>

#include "mirrorball/image/image.h"

namespace mirrorball::testing {

// Pictures of whole numbers / 255, so that the published program could be given exactly the same ones: stripes, a ramp
// and noise in all three channels. They are linear light, as FLIP takes it.

/// 0 … 255, of which neighbours know nothing.
inline int noiseAt(int x, int y, int channel) {
  std::uint32_t hash = std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u ^ std::uint32_t(channel) * 83492791u;
  hash ^= hash >> 13;
  hash *= 0x5bd1e995u;
  hash ^= hash >> 15;
  return static_cast<int>(hash & 255u);
}

/// Noise on the left, stripes in the middle, a ramp on the right.
inline Image flipReference(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const int stripes = (x / 3 + y / 7) % 2 == 0 ? 200 - 30 * channel : 20 + 40 * channel;
        const int ramp = 255 * y / height;
        const int code = 3 * x < width ? noiseAt(x, y, channel) : (3 * x < 2 * width ? stripes : ramp);
        image.texel(x, y)[channel] = static_cast<float>(code) / 255.0f;
      }
  return image;
}

/// The same with less noise, stripes that moved by a pixel and a ramp with a tint and some bright points.
inline Image flipTest(int width, int height) {
  Image image = flipReference(width, height);
  const Image reference = image;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const int code = static_cast<int>(reference.texel(x, y)[channel] * 255.0f + 0.5f);
        const int moved = static_cast<int>(reference.texel(std::min(x + 1, width - 1), y)[channel] * 255.0f + 0.5f);
        const int tinted = x % 11 == 0 && y % 11 == 0 ? 255 : std::min(code + 24 * channel, 255);
        const int changed = 3 * x < width ? (3 * code + 128) / 4 : (3 * x < 2 * width ? moved : tinted);
        image.texel(x, y)[channel] = static_cast<float>(changed) / 255.0f;
      }
  return image;
}

/// The same as light: from left to right it grows by powers of 2, and one texel is a sun of 10⁵.
inline Image asLight(Image picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      for (int channel = 0; channel < 3; ++channel) {
        float& sample = picture.texel(x, y)[channel];
        sample = x == 9 && y == 5 ? 1e5f : sample * static_cast<float>(1 << (x % 64) / 8) / 4.0f;
      }
  return picture;
}

}  // namespace mirrorball::testing
