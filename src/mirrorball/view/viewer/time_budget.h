#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// How large a picture may be while something moves, so that each takes no longer than was asked for: it learns from
/// those that were drawn. Sides are whole, 3/4, 1/2, 3/8 or 1/4 of the window's, but no picture gets fewer pixels than
/// 640 × 360 for that reason, since little can be told in smaller ones.
class TimeBudget {
 public:
  /// frame_s   that a picture may take, above 0 [s]
  explicit TimeBudget(double frame_s = 0.016) : frame_s_(frame_s) {}

  /// The size for a window of that size.
  glm::ivec2 sizeFor(glm::ivec2 window_px) const;

  /// What a picture took.
  void drew(glm::ivec2 size_px, double seconds);

  /// Forgets what it has learnt: another scene or technique is shown.
  void forget() { seconds_per_pixel_ = 0.0; }

  double frameSeconds() const { return frame_s_; }

 private:
  double frame_s_;
  double seconds_per_pixel_ = 0.0;  ///< 0: not known
};

}  // namespace mirrorball
