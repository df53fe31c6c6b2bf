#include "mirrorball/view/viewer/file_watch.h"

#include <chrono>
#include <fstream>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(FileWatch, TellsOnceThatAFileWasWrittenAgain) {
  const std::string path = ::testing::TempDir() + "watched";
  std::ofstream(path) << "a";
  FileWatch watch;
  watch.watch({path, "nowhere"});
  EXPECT_FALSE(watch.hasChanged());
  const auto time = std::filesystem::last_write_time(path);
  std::filesystem::last_write_time(path, time + std::chrono::seconds(2));
  EXPECT_FALSE(watch.hasChanged()) << "it may still be written";
  EXPECT_TRUE(watch.hasChanged());
  EXPECT_FALSE(watch.hasChanged());
  std::filesystem::remove(path);
  EXPECT_FALSE(watch.hasChanged());
  EXPECT_FALSE(watch.hasChanged()) << "another may be on its way";
  std::ofstream(path) << "b";
  std::filesystem::last_write_time(path, time + std::chrono::seconds(4));
  EXPECT_FALSE(watch.hasChanged());
  EXPECT_TRUE(watch.hasChanged());
}

}  // namespace
}  // namespace mirrorball
