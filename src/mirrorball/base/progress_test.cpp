#include "mirrorball/base/progress.h"

#include <numeric>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(Progress, PartsTellTheStepsOfTheWhole) {
  std::vector<std::pair<std::size_t, std::size_t>> told;
  const ProgressFunction whole = [&](std::size_t done, std::size_t total) {
    told.emplace_back(done, total);
    return done < 100;
  };
  const ProgressFunction part = partOf(whole, 40, 60, 100);
  EXPECT_TRUE(part(0, 0));
  EXPECT_TRUE(part(1, 3));
  EXPECT_FALSE(part(3, 3));
  EXPECT_THAT(told, ElementsAre(Pair(40, 100), Pair(60, 100), Pair(100, 100)));
  EXPECT_FALSE(partOf({}, 0, 1, 2));
}

TEST(Progress, ACounterCountsTheStepsOfAllThreadsInOrder) {
  std::vector<std::size_t> counted;
  const ProgressFunction progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 100u);
    counted.push_back(done);
    return true;
  };
  ProgressCounter counter(progress, 100);
  parallelFor(100, 1, [&](std::size_t, std::size_t) { counter.advance(); });
  std::vector<std::size_t> each(100);
  std::iota(each.begin(), each.end(), 1);
  EXPECT_EQ(counted, each);
  EXPECT_FALSE(counter.stopped());
  EXPECT_TRUE(counter.result());
}

TEST(Progress, ACounterStaysStopped) {
  const ProgressFunction once = [](std::size_t done, std::size_t) { return done != 2; };
  ProgressCounter counter(once, 3);
  for (int step = 0; step < 3; ++step) counter.advance();
  EXPECT_TRUE(counter.stopped());
  EXPECT_EQ(counter.result().error().code, ErrorCode::interrupted);
  const ProgressFunction nothing;
  ProgressCounter unasked(nothing, 1);
  unasked.advance();
  EXPECT_FALSE(unasked.stopped());
}

}  // namespace
}  // namespace mirrorball
