#pragma once

#include <algorithm>
#include <cmath>

namespace mirrorball {

/// What the numbers of some channels of colours are, where a format has fractions and some programs write codes of
/// bytes: whole numbers up to 255 (three.js issue 23340, meshlab issue 186). Numbers that are not whole are fractions,
/// of which rounding and light leave some above 1.
class ChannelRange {
 public:
  static constexpr float kGreatestCode = 255.0f;

  /// Of NaN and infinity nothing is known.
  void add(float number) {
    // Codes that Draco has quantised as floats are not quite whole.
    constexpr float kNearlyWhole = 0.01f;
    if (!std::isfinite(number)) return;
    least_ = std::min(least_, number);
    greatest_ = std::max(greatest_, number);
    is_whole_ = is_whole_ && std::abs(number - std::round(number)) < kNearlyWhole;
  }

  /// A few whole numbers just above 1 are more likely light: as codes, all of it would be nearly black.
  bool isOfCodes() const {
    constexpr float kLeastOfGreatest = 16.0f;
    return is_whole_ && least_ >= 0.0f && greatest_ >= kLeastOfGreatest && greatest_ < kGreatestCode + 0.5f;
  }

  /// Whether it is beyond [0, 1] by more than rounding.
  bool isBeyond() const { return least_ < -kRounding || greatest_ > 1.0f + kRounding; }

  float least() const { return least_; }        ///< at most 0
  float greatest() const { return greatest_; }  ///< at least 0

 private:
  static constexpr float kRounding = 0.5f / kGreatestCode;

  float least_ = 0.0f;
  float greatest_ = 0.0f;
  bool is_whole_ = true;
};

}  // namespace mirrorball
