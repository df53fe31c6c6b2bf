#include "mirrorball/base/memory.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "test_data.h"

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
  EXPECT_EQ(refused.error().fix_hint, FixHint::raise_memory_or_shrink);
  setMemoryLimit(usual);
}

/// 100 bytes may be used while it lives.
class Limit {
 public:
  Limit() { setMemoryLimit(100); }
  ~Limit() { setMemoryLimit(usual_); }

 private:
  std::uint64_t usual_ = memoryLimit();
};

TEST(MemoryBudget, GivesAsMuchAsTheLimit) {
  const Limit limit;
  MemoryBudget budget;
  EXPECT_TRUE(budget.take(60));
  EXPECT_EQ(budget.take(41).error().code, ErrorCode::too_large);
  EXPECT_EQ(budget.take(UINT64_MAX).error().code, ErrorCode::too_large);
  EXPECT_TRUE(budget.take(40)) << "what was refused is not taken";
  EXPECT_EQ(budget.taken(), 100u);
  budget.giveBack(60);
  EXPECT_TRUE(budget.take(60));
}

TEST(MemoryBudget, IsWhatAShareOfAThreadAsks) {
  const Limit limit;
  MemoryBudget budget;
  ASSERT_TRUE(budget.take(50));
  {
    MemoryShare share(budget);
    EXPECT_TRUE(checkMemory(30));
    EXPECT_TRUE(checkMemory(20)) << "of what is taken already";
    EXPECT_EQ(budget.taken(), 80u);
    EXPECT_FALSE(checkMemory(51));
    {
      MemoryShare inner(budget);
      EXPECT_FALSE(checkMemory(21));
      EXPECT_TRUE(checkMemory(20));
    }
    EXPECT_EQ(budget.taken(), 80u) << "given back";
    EXPECT_TRUE(share.keep(10));
  }
  EXPECT_EQ(budget.taken(), 60u) << "but what is kept";
  EXPECT_TRUE(checkMemory(100)) << "and the thread has none any more";
}

#if GTEST_IS_THREADSAFE  // a browser has no threads
TEST(MemoryBudget, IsNoMatterOfOtherThreads) {
  const Limit limit;
  MemoryBudget budget;
  const MemoryShare share(budget);
  EXPECT_TRUE(checkMemory(30));
  std::thread([] { EXPECT_TRUE(checkMemory(100)); }).join();
}

TEST(MemoryBudget, IsNotExceededByManyThreads) {
  const Limit limit;
  MemoryBudget budget;
  std::atomic<int> taken = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 1000; ++k) taken += budget.take(1) ? 1 : 0;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(taken, 100);
}
#endif

#if GTEST_IS_THREADSAFE  // browsers have no such limits
TEST(AddressSpace, IsBoundedWhereTheProcessIs) {
  if (testing::isSanitized()) GTEST_SKIP() << "the address sanitizer has taken more addresses than the bound";
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &usual), 0);
  if (usual.rlim_cur != RLIM_INFINITY) GTEST_SKIP() << "the tests themselves are bounded";
  EXPECT_EQ(addressSpaceLeft(), UINT64_MAX);
  constexpr std::uint64_t kBound = std::uint64_t{1} << 40;
  const rlimit bounded{kBound, usual.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &bounded), 0);
  const std::uint64_t left = addressSpaceLeft();
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &usual), 0);
  EXPECT_LT(left, kBound);
}
#endif

}  // namespace
}  // namespace mirrorball
