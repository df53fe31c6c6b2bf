#include "mirrorball/base/part_file.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class PartFileTest : public ::testing::Test {
 protected:
  PartFileTest() { fs::create_directories(folder_); }
  ~PartFileTest() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("part_file_" + std::to_string(::getpid()));
};

TEST_F(PartFileTest, EachHasANameOfItsOwn) {
  const auto one = makePart(folder_);
  const auto other = makePart(folder_);
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->path.path(), other->path.path());
  for (const auto* part : {&*one, &*other}) {
    EXPECT_TRUE(fs::exists(part->path.path())) << "one removed the other";
    EXPECT_TRUE(isPartName(fs::path(part->path.path()).filename()));
  }
  EXPECT_FALSE(makePart(folder_ / "none"));
}

TEST_F(PartFileTest, OnlyTheirNamesAreTheirs) {
  EXPECT_TRUE(isPartName(".mirrorball-0123456789abcdef.part"));
  for (const char* other : {".mirrorball-0123456789abcde.part", ".mirrorball-0123456789abcdeg.part",
                            "mirrorball-0123456789abcdef.part", ".mirrorball-0123456789abcdef.parts", ".part", ""})
    EXPECT_FALSE(isPartName(other)) << other;
}

#if GTEST_HAS_DEATH_TEST  // a browser has no processes, threads or pipes
// A run that is killed leaves its part; the next one in that folder removes it, and that of no run that goes on.
TEST_F(PartFileTest, OfAKilledRunIsRemovedByTheNext) {
  const auto beside = makePart(folder_);
  ASSERT_TRUE(beside);
  const pid_t killed = ::fork();
  if (killed == 0) {
    const auto writer = FileWriter::create(folder_ / "picture");
    if (writer) ::raise(SIGKILL);
    std::_Exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(killed, &status, 0), killed);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(files(), 2u) << "the killed run's, and the one beside it";
  ASSERT_TRUE(writeFile(folder_ / "picture", Bytes{1}));
  EXPECT_EQ(files(), 2u) << "the picture, and the one beside it";
  EXPECT_TRUE(fs::exists(beside->path.path()));
}

// What only has such a name is not ours: pipes and links to other files stay.
TEST_F(PartFileTest, WhatIsNoFileStays) {
  const std::string pipe = folder_ / ".mirrorball-0123456789abcdef.part";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::ofstream(folder_ / "mine") << "mine";
  const fs::path link = folder_ / ".mirrorball-0123456789abcdee.part";
  fs::create_symlink("mine", link);
  ASSERT_TRUE(writeFile(folder_ / "picture", Bytes{1}));
  EXPECT_TRUE(fs::exists(pipe));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::exists(folder_ / "mine"));
}

// Each looks for abandoned parts while the others make theirs.
TEST_F(PartFileTest, ManyAtATimeDoNotRemoveEachOthers) {
  std::atomic<int> written = 0;
  std::vector<std::thread> writers;
  for (int thread = 0; thread < 8; ++thread)
    writers.emplace_back([&, thread] {
      for (int i = 0; i < 50; ++i)
        if (writeFile(folder_ / (std::to_string(thread) + "_" + std::to_string(i)), Bytes{1})) ++written;
    });
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(written, 400);
  EXPECT_EQ(files(), 400u);
}
#endif

}  // namespace
}  // namespace mirrorball
