#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace mirrorball {

/// The numbers that the paths of one pixel are made of: Sobol' points whose digits are scrambled at random (Owen 1995),
/// so that the error of a mean falls faster than that of independent numbers. Each call of `next` takes the next two
/// dimensions of the path's point; pairs of dimensions are made independent of each other by shuffling the order of the
/// points (padding: Burley 2020, "Practical hash-based Owen scrambling"). The points of a pixel are the same on every
/// machine and whatever is drawn beside it.
///
/// cost     50 ns a pair at most; measured
class SampleSequence {
 public:
  /// pixel    any number that tells the pixel from others
  /// index    of the path among those of the pixel; the first 2ⁿ of them are spread well for each n
  SampleSequence(std::uint32_t pixel, std::uint32_t index);

  /// Two numbers in [0, 1).
  glm::vec2 next();

  /// Numbers in [0, 1) that are independent of each other and of all of `next`: for decisions whose number is not known
  /// before they are made.
  float nextIndependent();

 private:
  std::uint32_t seed_;
  std::uint32_t index_;
  std::uint32_t reversed_index_;  // its binary digits in the other order
  std::uint32_t pair_ = 0;
  std::uint64_t random_ = 0;  // state of the independent numbers; 0: not begun
};

}  // namespace mirrorball
