#include "mirrorball/base/parallel.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(ParallelFor, VisitsEveryItemOnce) {
  for (const std::size_t count : {0u, 1u, 7u, 8u, 1000u}) {
    std::vector<int> visits(count);
    parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), std::size_t{0}), count);
    for (const int times : visits) EXPECT_EQ(times, 1);
  }
}

}  // namespace
}  // namespace mirrorball
