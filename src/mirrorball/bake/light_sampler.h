#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// A direction that light comes from, and how likely it was to be chosen.
struct LightSample {
  glm::vec3 direction{0.0f};  ///< unit
  float pdf = 0.0f;           ///< density [1/sr]; 0: there is none
  bool is_weighed = true;     ///< against other ways to choose the direction; else it counts as the only one
};

/// Chooses directions as often as the environment is bright there (importance sampling), so that a sun of 10⁵ over half
/// a degree is found by nearly every path. Between the texels of an equal-area map, all of one solid angle, the choice
/// is by the luminance that the map has in each, and within a texel it is uniform; the density is exact for whatever
/// the environment's light is between them.
class LightSampler {
 public:
  /// More texels make the choice hardly better.
  static constexpr int kMaxSize = 2048;

  /// environment   finite, not negative
  /// max_size      of the map's side, in texels
  /// errors        too_large; interrupted
  /// cost          that of a conversion to some 1024² texels, and 4 bytes for each, 0.5 KB for each row
  static Result<LightSampler> make(const Environment& environment, const ProgressFunction& progress = {},
                                   int max_size = kMaxSize);

  /// A direction for two uniform numbers; near numbers give near directions.
  LightSample sample(glm::vec2 u) const;

  /// The density with which `sample` returns directions around that one [1/sr].
  float pdf(glm::vec3 direction) const;

  /// Of the environment's light, over all directions.
  float meanLuminance() const { return mean_luminance_; }

 private:
  int stepOf(std::size_t table, float& u) const;
  float densityOf(int x, int y) const;

  int size_ = 0;
  float mean_luminance_ = 0.0f;
  // Tables of running sums, `size_` each: first that of each row's columns, the share of the row's light up to the end
  // of each; then that of all rows.
  std::vector<float> sums_;
  std::vector<std::uint16_t> guides_;  // of each table, where to begin looking
};

}  // namespace mirrorball
