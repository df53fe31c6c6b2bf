#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/codec/color/display.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// All that is known of a pixel's paths, or of one half of them.
struct PixelSums {
  glm::dvec4 light{0.0};
  glm::dvec4 squares{0.0};
  glm::vec3 albedo{0.0f};
  glm::vec3 normal{0.0f};
  int paths = 0;
  int lost = 0;  ///< of these, those whose light was no number; they count as black
};

/// How many paths each pixel of a half of a film has after a pass.
struct PathCounts {
  int least = 1;
  int most = 1;
  /// Of each pixel, of which there are `scale` times as many between those two; empty: all have the least.
  std::vector<float> shares = {};
  float scale = 0.0f;

  int at(std::size_t pixel) const;
};

/// A pass over a picture: for each pixel what it adds.
class FilmPass {
 public:
  explicit FilmPass(glm::ivec2 size) : size_(size), sums_(std::size_t(size.x) * std::size_t(size.y)) {}

  glm::ivec2 size() const { return size_; }
  PixelSums& at(std::size_t pixel) { return sums_[pixel]; }
  const std::vector<PixelSums>& sums() const { return sums_; }

 private:
  glm::ivec2 size_;
  std::vector<PixelSums> sums_;
};

/// A path-traced picture so far: for each pixel the sum of its paths' light, and of its squares. It may have two halves
/// whose paths know nothing of each other; the picture is the mean of the two, however many paths each has.
class Film {
 public:
  /// halves   1 or 2
  /// page     radiance behind what does not cover it; nothing: the picture is transparent there
  Film(glm::ivec2 size, int halves, const std::optional<glm::vec3>& page);

  glm::ivec2 size() const { return size_; }
  /// Takes a pass over a half that is whole.
  ///
  /// counts   how many paths each pixel has now; those where the picture shows nothing count, and found nothing
  void addPass(const FilmPass& pass, int half, const PathCounts& counts);

  int pathsOf(std::size_t pixel, int half) const { return halves_[std::size_t(half)][pixel].paths; }
  /// Of all pixels, and of both halves.
  std::uint64_t paths() const;
  /// How many paths had no number as their light.
  std::uint64_t lost() const;

  /// The standard error of the picture as it is displayed, encoded, in the mean over its channels and those pixels that
  /// show something: as if the paths of a pixel were independent of each other, which makes it rather too high.
  float noise(const Display& display) const;

  /// The same of each pixel, of a picture that is this half alone.
  std::vector<float> errorsOf(int half, const Display& display) const;

  /// The mean of the paths: 4 channels.
  Image radiance() const;
  /// 3 channels each; the variance is that of the mean.
  Image albedo() const;
  Image normal() const;
  Image variance() const;

 private:
  template <int Channels, typename Value>
  Image imageOf(const Value& value) const;
  template <typename Value>
  auto meanOfHalves(std::size_t pixel, const Value& value) const;
  glm::dvec4 varianceAt(std::size_t pixel) const;

  glm::ivec2 size_;
  std::optional<glm::vec3> page_;
  std::vector<std::vector<PixelSums>> halves_;
  std::vector<bool> shows_;  // of each pixel, whether there is something to be seen, as not beside a disc
};

}  // namespace mirrorball
