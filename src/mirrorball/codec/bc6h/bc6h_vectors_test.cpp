// What needs Highway's list of the processor's vector instructions, which a browser's build has one of.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/bc6h/bc6h.h"
#include "mirrorball/codec/bc6h/bc6h_block.h"

namespace mirrorball {
namespace {

/// Each set of vector instructions that the processor has gives the same bytes.
TEST(Bc6hVectors, EveryProcessorWritesTheSameBytes) {
  constexpr int kWidth = 96;
  constexpr int kHeight = 64;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> exponent(-6.0f, 6.0f);
  Image image(kWidth, kHeight, 3);
  for (float& sample : image.samples()) sample = std::exp2(exponent(random));
  const auto written = [&] {
    Bytes bytes(std::size_t(kWidth / 4) * std::size_t(kHeight / 4) * kBc6hBlockSize);
    EXPECT_TRUE(encodeBc6h(image.samples(), 3, kWidth, bytes));
    return bytes;
  };
  const Bytes expected = written();
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    EXPECT_TRUE(written() == expected) << hwy::TargetName(target);
    hwy::SetSupportedTargetsForTest(0);
  }
}

}  // namespace
}  // namespace mirrorball
