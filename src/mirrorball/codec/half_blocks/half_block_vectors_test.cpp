// What needs Highway's list of the processor's vector instructions, which a browser's build has one of.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "mirrorball/codec/half_blocks/half_blocks_testing.h"

namespace mirrorball {
namespace {

/// Each set of vector instructions that the processor has gives the same bytes.
TEST(HalfBlockVectors, EveryProcessorWritesTheSameBytes) {
  const Image image = testing::octaveNoise(96, 64);
  for (const testing::HalfBlockCodec& codec : {testing::kBc6hCodec, testing::kUastcHdrCodec}) {
    const Bytes expected = testing::encodedBlocks(codec, image);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      EXPECT_TRUE(testing::encodedBlocks(codec, image) == expected) << codec.name << ", " << hwy::TargetName(target);
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

}  // namespace
}  // namespace mirrorball
