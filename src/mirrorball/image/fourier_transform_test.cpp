#include "mirrorball/image/fourier_transform.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using Complex = std::complex<float>;

class AnyLength : public ::testing::TestWithParam<int> {};

TEST_P(AnyLength, IsTheSumOfItsDefinition) {
  const int length = GetParam();
  std::vector<Complex> in;
  for (int n = 0; n < length; ++n) in.emplace_back(std::sin(1.7f * float(n * n)), std::cos(0.3f * float(n)));
  for (const bool is_inverse : {false, true}) {
    std::vector<Complex> out(in.size());
    FourierTransform(length, is_inverse).run(in, out);
    for (int k = 0; k < length; k += 1 + length / 40) {
      std::complex<double> sum(0.0);
      for (int n = 0; n < length; ++n) {
        const double turns = static_cast<double>(long{k} * n % length) / length;
        sum += std::complex<double>(in[std::size_t(n)]) *
               std::polar(1.0, (is_inverse ? 2.0 : -2.0) * std::numbers::pi * turns);
      }
      EXPECT_LT(std::abs(sum - std::complex<double>(out[std::size_t(k)])), 1e-6 * length) << k;
    }
  }
}

// Powers, what the library does itself, and primes and their products.
INSTANTIATE_TEST_SUITE_P(FourierTransform, AnyLength,
                         ::testing::Values(1, 2, 3, 4, 7, 13, 17, 30, 34, 127, 360, 1021, 1024, 1022));

TEST(QuickLength, IsTheNextEvenProductOf2And3And5) {
  EXPECT_EQ(quickLength(1), 2);
  EXPECT_EQ(quickLength(7), 8);
  EXPECT_EQ(quickLength(1026), 1080);
  EXPECT_EQ(quickLength(1080), 1080);
}

}  // namespace
}  // namespace mirrorball
