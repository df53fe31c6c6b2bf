#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/codec/color/display.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// All that is known of a pixel's paths.
struct PixelSums {
  glm::dvec4 light{0.0};
  glm::dvec3 squares{0.0};
  glm::vec3 albedo{0.0f};
  glm::vec3 normal{0.0f};
  int paths = 0;  ///< fewer than the film's where the picture shows nothing
  int lost = 0;   ///< of these, those whose light was no number; they count as black
};

/// A path-traced picture so far: for each pixel the sum of its paths' light, and of its squares.
class Film {
 public:
  explicit Film(glm::ivec2 size) : size_(size), sums_(std::size_t(size.x) * std::size_t(size.y)) {}

  glm::ivec2 size() const { return size_; }
  int samples() const { return samples_; }
  PixelSums& at(int x, int y) { return sums_[std::size_t(y) * std::size_t(size_.x) + std::size_t(x)]; }

  /// Takes a pass of so many paths a pixel that is whole.
  void addPass(const Film& pass, int count);

  /// The standard error of the picture as it is displayed, encoded, in the mean over its channels and those pixels that
  /// show something: as if the paths of a pixel were independent of each other, which makes it rather too high.
  float noise(const Display& display) const;

  /// How many paths had no number as their light.
  std::uint64_t lost() const;

  /// The mean of the paths: 4 channels.
  Image radiance() const;
  /// 3 channels each; the variance is that of the mean.
  Image albedo() const;
  Image normal() const;
  Image variance() const;

 private:
  template <int Channels, typename Value>
  Image imageOf(const Value& value) const;

  glm::ivec2 size_;
  std::vector<PixelSums> sums_;
  int samples_ = 0;
};

}  // namespace mirrorball
