#include "mirrorball/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <utility>
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

// Results are gathered by piece: which items a piece has may not depend on threads.
TEST(ParallelFor, CutsTheSamePiecesWithAnyNumberOfThreads) {
  std::mutex mutex;
  std::set<std::pair<std::size_t, std::size_t>> pieces;
  parallelFor(10, 4, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    pieces.emplace(begin, end);
  });
  EXPECT_EQ(pieces, (std::set<std::pair<std::size_t, std::size_t>>{{0, 4}, {4, 8}, {8, 10}}));
}

// The last of this file: the limit is the whole process's. Where there are no threads it is 1.
TEST(ParallelFor, KeepsToItsLimitOfThreads) {
  EXPECT_GE(threadLimit(), 1);
  for (const int limit : {1, 2}) {
    setThreadLimit(limit);
    EXPECT_LE(threadLimit(), limit);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    std::atomic<int> now = 0;
    std::atomic<int> max = 0;
    parallelFor(64, 1, [&](std::size_t, std::size_t) {
      max = std::max(max.load(), ++now);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      --now;
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    EXPECT_LE(max, limit);
    if (limit == 1) {
      EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
    }
  }
}

}  // namespace
}  // namespace mirrorball
