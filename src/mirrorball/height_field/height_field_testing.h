#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// Heights in [0, 1) of which neighbours know nothing.
inline Image randomHeights(int width, int height, unsigned seed = 1) {
  std::mt19937 generator(seed);
  Image heights(width, height, 1);
  for (float& sample : heights.samples()) sample = static_cast<float>(generator() >> 8) / 16777216.0f;
  return heights;
}

/// Smooth hills in [0, 1] that tile: waves of up to `waves` periods over the map.
inline Image hills(int width, int height, int waves = 4) {
  Image heights(width, height, 1);
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width;
      const double v = (y + 0.5) / height;
      const double sum = std::sin(kTurn * (u + waves * v) + 1.0) + std::sin(kTurn * (waves * u - 2.0 * v)) +
                         std::cos(kTurn * (waves * v - u)) + std::sin(kTurn * 2.0 * u + 0.5);
      heights.texel(x, y)[0] = static_cast<float>(0.5 + 0.125 * sum);
    }
  return heights;
}

/// The height of a texel anywhere.
inline float heightAt(const Image& heights, int x, int y, MapEdges edges) {
  const auto within = [edges](int place, int length) {
    if (edges == MapEdges::clamped) return place < 0 ? 0 : place >= length ? length - 1 : place;
    return (place % length + length) % length;
  };
  return heights.texel(within(x, heights.width()), within(y, heights.height()))[0];
}

/// The surface that bilinear filtering shows, at a place in texels from the centre of the first one.
inline double surfaceAt(const Image& heights, double x, double y, MapEdges edges) {
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const double s = x - i;
  const double t = y - j;
  const auto at = [&](int column, int row) { return double(heightAt(heights, column, row, edges)); };
  return (1.0 - t) * ((1.0 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1.0 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

/// A map moved by so many texels, as a tiled one may be.
inline Image rolled(const Image& image, int right, int down) {
  Image moved(image.width(), image.height(), image.channels());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < image.channels(); ++c)
        moved.texel((x + right) % image.width(), (y + down) % image.height())[c] = image.texel(x, y)[c];
  return moved;
}

inline constexpr HeightDifference kAllDifferences[] = {HeightDifference::backward, HeightDifference::forward,
                                                       HeightDifference::central, HeightDifference::sobel};
inline constexpr MapEdges kAllEdges[] = {MapEdges::tiled, MapEdges::clamped};

}  // namespace mirrorball::testing
