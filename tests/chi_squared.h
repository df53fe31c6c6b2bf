#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mirrorball::testing {

/// Pearson's chi-squared test of counts against their expectations, rare bins taken together. It fails a right sampler
/// once in a million; tests draw the same numbers each time.
///
/// what     is counted, for messages
inline void expectCounts(const std::vector<double>& counted, const std::vector<double>& expected,
                         const std::string& what) {
  constexpr double kRare = 8.0;
  double sum = 0.0;
  double rare_expected = 0.0;
  double rare_counted = 0.0;
  int bins = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] < kRare) {
      rare_expected += expected[i];
      rare_counted += counted[i];
      continue;
    }
    sum += (counted[i] - expected[i]) * (counted[i] - expected[i]) / expected[i];
    ++bins;
  }
  if (rare_expected > kRare) {
    sum += (rare_counted - rare_expected) * (rare_counted - rare_expected) / rare_expected;
    ++bins;
  } else {
    EXPECT_LE(rare_counted, 40.0) << what << ": where hardly any belong";
  }
  // Wilson and Hilferty 1931: the cube root of chi² over its degrees of freedom is nearly normal; 4.75 deviations.
  const double freedom = bins - 1;
  const double spread = 2.0 / (9.0 * freedom);
  const double deviations = (std::cbrt(sum / freedom) - (1.0 - spread)) / std::sqrt(spread);
  EXPECT_LT(deviations, 4.75) << what << ": chi² " << sum << " of " << freedom << " degrees of freedom";
}

}  // namespace mirrorball::testing
