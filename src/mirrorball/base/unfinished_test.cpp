#include "mirrorball/base/unfinished.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class UnfinishedTest : public ::testing::Test {
 protected:
  UnfinishedTest() { fs::create_directories(folder_); }
  ~UnfinishedTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return fs::exists(path(name)); }
  void make(const std::string& name) const { ASSERT_TRUE(writeFile(path(name), {})); }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("unfinished_" + std::to_string(::getpid()));
};

TEST_F(UnfinishedTest, IsRemovedUnlessItIsKept) {
  {
    UnfinishedPath file(path("file"));
    make("file");
    UnfinishedPath folder(path("folder"));
    fs::create_directories(path("folder/in/it"));
    UnfinishedPath kept(path("kept"));
    make("kept");
    kept.keep();
    const UnfinishedPath owner(std::move(file));
    EXPECT_TRUE(file.empty());
    EXPECT_TRUE(exists("file"));
  }
  EXPECT_FALSE(exists("file"));
  EXPECT_FALSE(exists("folder"));
  EXPECT_TRUE(exists("kept"));
}

TEST_F(UnfinishedTest, IsFinishedUnderItsName) {
  UnfinishedPath file(path("file.part"));
  make("file.part");
  EXPECT_TRUE(file.finishAs(path("file")));
  EXPECT_TRUE(file.empty());
  EXPECT_TRUE(exists("file"));
  EXPECT_FALSE(exists("file.part"));

  UnfinishedPath other(path("other.part"));
  make("other.part");
  EXPECT_FALSE(other.finishAs(path("none/other")));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(exists("other.part"));
}

TEST_F(UnfinishedTest, OfAFolderThatIsNotKeptWhatOthersPutThereStays) {
  {
    const UnfinishedFolder folder({path("new/out"), path("new")});
    fs::create_directories(path("new/out"));
    make("new/out/own");
    std::ofstream(path("new/out/others")) << "finished";
  }
  EXPECT_FALSE(exists("new/out/own"));
  EXPECT_TRUE(exists("new/out/others"));
  fs::remove(path("new/out/others"));
  {
    const UnfinishedFolder again({path("new/out/"), path("new")});
    make("new/out/../out/own");
  }
  EXPECT_FALSE(exists("new"));
}

TEST_F(UnfinishedTest, AFolderThatIsKeptStays) {
  UnfinishedFolder folder({path("kept")});
  fs::create_directories(path("kept"));
  make("kept/own");
  folder.keep();
  EXPECT_TRUE(folder.empty());
  const UnfinishedFolder none({});
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(exists("kept/own"));
}

#if GTEST_HAS_DEATH_TEST  // a browser has no processes
// In a process of its own, which ends with it: nothing can be finished afterwards.
TEST_F(UnfinishedTest, AllIsRemovedAtOnceByAProgramThatEnds) {
  const auto end = [&] {
    const auto begun = FileWriter::create(path("begun"));
    auto finished = FileWriter::create(path("finished"));
    const UnfinishedPath folder(path("folder"));
    fs::create_directories(path("folder/in/it"));
    const UnfinishedFolder set({path("set")});
    fs::create_directories(path("set"));
    make("set/own");
    const bool done = begun && finished && finished->commit();
    removeUnfinished();
    std::_Exit(done && exists("finished") ? 7 : 1);
  };
  EXPECT_EXIT(end(), ::testing::ExitedWithCode(7), "");
  EXPECT_TRUE(exists("finished"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "only that is left";
}
#endif

}  // namespace
}  // namespace mirrorball
