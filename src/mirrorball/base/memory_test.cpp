#include "mirrorball/base/memory.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr std::uint64_t kGigabyte = std::uint64_t{1} << 30;

TEST(Memory, AmountsAreReadAsPeopleWriteThem) {
  EXPECT_EQ(parseBytes("1.5G").value(), kGigabyte * 3 / 2);
  EXPECT_EQ(parseBytes("2gb").value(), kGigabyte * 2);
  EXPECT_EQ(parseBytes("800M").value(), std::uint64_t{800} << 20);
  EXPECT_EQ(parseBytes("4096").value(), 4096u);
  for (const char* wrong : {"", "G", "-1G", "0", "1.5 G", "many", "1T", "1e40"})
    EXPECT_EQ(parseBytes(wrong).error().code, ErrorCode::usage) << wrong;
}

TEST(Memory, AmountsAreWrittenShort) {
  EXPECT_EQ(textOfBytes(kGigabyte * 3 / 2), "1.5 GB");
  EXPECT_EQ(textOfBytes(std::uint64_t{320} << 20), "320 MB");
  EXPECT_EQ(textOfBytes(12), "1 MB");
}

TEST(Memory, MoreThanTheLimitIsRefused) {
  const std::uint64_t usual = memoryLimit();
  EXPECT_GT(usual, std::uint64_t{64} << 20);
  setMemoryLimit(kGigabyte);
  EXPECT_TRUE(checkMemory(kGigabyte));
  const auto refused = checkMemory(kGigabyte * 2);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().message, "needs 2.0 GB of memory, and 1.0 GB may be used");
  EXPECT_EQ(refused.error().remedy, Remedy::raise_memory_or_shrink);
  setMemoryLimit(usual);
}

}  // namespace
}  // namespace mirrorball
