#include "mirrorball/base/linear_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

// The first pivot is 0 where the rows stand.
TEST(LinearSystem, IsSolvedWithRowsInAnyOrder) {
  // 2 y = 4, x + y + z = 6, 3 x - z = 0
  EXPECT_THAT(solved({{0, 2, 0, 4}, {1, 1, 1, 6}, {3, 0, -1, 0}}), ElementsAre(DoubleEq(1), DoubleEq(2), DoubleEq(3)));
}

}  // namespace
}  // namespace mirrorball
