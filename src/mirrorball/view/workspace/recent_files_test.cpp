#include "mirrorball/view/workspace/recent_files.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string fileNamed(const std::string& name) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << "x";
  return path;
}

TEST(RecentFiles, AreListedTheLastFirst) {
  const std::filesystem::path folder = ::testing::TempDir() + "recent_state";
  std::filesystem::remove_all(folder);
  const RecentFiles recent(folder / "deeper" / "recent.txt");
  EXPECT_THAT(recent.list(), IsEmpty());
  const std::string a = fileNamed("recent_a"), b = fileNamed("recent_b");
  recent.note(a);
  recent.note(b);
  EXPECT_THAT(recent.list(), ElementsAre(b, a));
  recent.note(a);
  EXPECT_THAT(recent.list(), ElementsAre(a, b)) << "once";
  recent.note("teapot");
  EXPECT_THAT(recent.list(), ElementsAre(a, b)) << "no file";
  std::filesystem::remove(a);
  EXPECT_THAT(recent.list(), ElementsAre(b));
  for (int i = 0; i < 30; ++i) recent.note(fileNamed("recent_" + std::to_string(i)));
  EXPECT_THAT(recent.list(), SizeIs(RecentFiles::kMost));
}

TEST(RecentFiles, KeepAWorkspaceBesideThem) {
  const std::filesystem::path folder = ::testing::TempDir() + "kept_state";
  std::filesystem::remove_all(folder);
  const RecentFiles recent(folder / "deeper" / "recent.txt");
  for (const char* model : {"teapot", "knot"}) {
    const auto path = recent.keep({.model = model});
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(loadWorkspace(*path)->model, model);
  }
}

}  // namespace
}  // namespace mirrorball
