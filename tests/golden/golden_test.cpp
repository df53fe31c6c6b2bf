// The pictures that the program makes are those in tests/golden/pictures, which someone has looked at. That they are
// right as well is held by truth_test.cpp.
//
// After a change that is meant to be seen, one command makes them anew, and counts these tests as skipped:
//
//     MIRRORBALL_UPDATE_GOLDEN=1 ./test -L golden
//
// Look at every picture that git then calls changed before you keep it. What the pictures are is in cases.cpp, and with
// each tolerance the reason for it.

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "golden/cases.h"
#include "golden/golden_picture.h"
#include "golden/made_picture.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::golden {
namespace {

namespace fs = std::filesystem;

class Golden : public ::testing::TestWithParam<Case> {};

TEST_P(Golden, PictureIsMadeAgain) {
  const Case& golden_case = GetParam();
  if (needsGl(golden_case)) {
    MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  }
  const Result<Bytes> file = pictureMadeBy(commandOf(golden_case));
  ASSERT_TRUE(file) << file.error().message;
  if (isUpdating()) {
    const fs::path path = goldenPath(golden_case.name);
    const Result<void> written = writeFile(path, *file);
    ASSERT_TRUE(written) << written.error().message;
    GTEST_SKIP() << "not compared: wrote " << path.string();
  }
  const Result<Image8> now = decodeTexture(*file);
  ASSERT_TRUE(now) << now.error().message;
  EXPECT_TRUE(matchesGolden(goldenPath(golden_case.name), *now, *golden_case.tolerance, MIRRORBALL_GOLDEN_FAILURES));
}
INSTANTIATE_TEST_SUITE_P(Program, Golden, ::testing::ValuesIn(cases().begin(), cases().end()), caseName);

TEST(GoldenPictures, BelongToACaseAndAreSmall) {
  if (isUpdating()) GTEST_SKIP() << "the golden pictures are being made";
  std::set<std::string> wanted;
  for (const Case& golden_case : cases()) wanted.insert(golden_case.name + std::string(".png"));
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(goldenPath("any").parent_path())) {
    EXPECT_TRUE(wanted.contains(entry.path().filename().string())) << entry.path() << " belongs to no case";
    bytes += entry.file_size();
  }
  EXPECT_LE(bytes, 750'000u) << "every clone carries these pictures, and every version of them";
}

}  // namespace
}  // namespace mirrorball::golden
