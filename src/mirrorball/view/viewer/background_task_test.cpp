#include "mirrorball/view/viewer/background_task.h"

#include <memory>
#include <thread>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// What becomes of it, however long that takes.
template <typename Value>
Result<Value> waitedFor(BackgroundTask<Value>& task) {
  while (true) {
    if (auto result = task.take()) return *result;
    std::this_thread::yield();
  }
}

/// Goes on until it is told to stop.
Result<int> endless(const ProgressFunction& progress) {
  while (progress(1, 4)) std::this_thread::yield();
  return 1;
}

TEST(BackgroundTask, HandsItsResultOverOnce) {
  BackgroundTask<int> task;
  EXPECT_FALSE(task.take());
  task.begin([](const ProgressFunction&) { return Result<int>(5); });
  EXPECT_TRUE(task.isRunning());
  EXPECT_EQ(*waitedFor(task), 5);
  EXPECT_FALSE(task.isRunning());
  EXPECT_FALSE(task.take());
  task.begin([](const ProgressFunction&) -> Result<int> { return fail(ErrorCode::io, "no disk"); });
  EXPECT_EQ(waitedFor(task).error().message, "no disk");
}

TEST(BackgroundTask, TheLastWorkCountsAndThoseBeforeStop) {
  if (threadLimit() == 1) GTEST_SKIP() << "without threads nothing goes on beside";
  BackgroundTask<int> task;
  for (int i = 0; i < 10; ++i) task.begin(endless);
  while (task.share() == 0.0) std::this_thread::yield();
  EXPECT_EQ(task.share(), 0.25);
  task.begin([](const ProgressFunction&) { return Result<int>(7); });
  EXPECT_EQ(*waitedFor(task), 7);
  task.begin(endless);  // the end stops it
}

TEST(BackgroundTask, KeepsNothingThatIsNotAskedFor) {
  if (threadLimit() == 1) GTEST_SKIP() << "without threads nothing goes on beside";
  const auto value = std::make_shared<int>(3);
  BackgroundTask<std::shared_ptr<int>> task;
  task.begin([value](const ProgressFunction& progress) -> Result<std::shared_ptr<int>> {
    while (progress(0, 1)) std::this_thread::yield();
    return value;
  });
  task.cancel();
  while (value.use_count() > 1) {
    EXPECT_FALSE(task.take());
    std::this_thread::yield();
  }
}

}  // namespace
}  // namespace mirrorball
