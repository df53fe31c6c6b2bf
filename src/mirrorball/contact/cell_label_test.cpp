#include "mirrorball/contact/cell_label.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using Names = std::vector<std::string>;

TEST(CellLabel, IsTheLastPartOfAPath) {
  EXPECT_THAT(cellLabels(Names{"maps/attic.hdr", "/a/b/hall.exr", "skybox/", "studio", "sky:elevation=20,turbidity=3"}),
              ElementsAre("attic.hdr", "hall.exr", "skybox", "studio", "sky:elevation=20,turbidity=3"));
}

TEST(CellLabel, FoldersTellFilesOfOneNameApart) {
  EXPECT_THAT(cellLabels(Names{"a/x/attic.hdr", "b/x/attic.hdr", "hall.hdr", "attic.hdr"}),
              ElementsAre("a/x/attic.hdr", "b/x/attic.hdr", "hall.hdr", "attic.hdr"));
  EXPECT_THAT(cellLabels(Names{"/m/garden/1k.hdr", "/m/sea/1k.hdr"}), ElementsAre("garden/1k.hdr", "sea/1k.hdr"));
}

TEST(CellLabel, OneFileTwiceHasOneName) {
  EXPECT_THAT(cellLabels(Names{"a/attic.hdr", "a/attic.hdr", "a/./attic.hdr"}),
              ElementsAre("attic.hdr", "attic.hdr", "attic.hdr"));
}

TEST(CellLabel, APathOfNoPartsIsItself) { EXPECT_THAT(cellLabels(Names{"/", "", "."}), ElementsAre("/", "", ".")); }

TEST(CellLabel, LongOnesLoseTheirMiddle) {
  EXPECT_EQ(shortenedInTheMiddle("attic.hdr", 9), "attic.hdr");
  EXPECT_EQ(shortenedInTheMiddle("a_very_long_name.hdr", 11), "a_ve....hdr");
  EXPECT_EQ(shortenedInTheMiddle("a_very_long_name.hdr", 12), "a_ve...e.hdr");
  EXPECT_EQ(shortenedInTheMiddle("a_very_long_name.hdr", 5), "a_ver");
  EXPECT_EQ(shortenedInTheMiddle("attic", 0), "");
}

}  // namespace
}  // namespace mirrorball
