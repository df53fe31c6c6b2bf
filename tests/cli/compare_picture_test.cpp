// compare: the heat map and the sheet.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// b.png is grey; a.png is brighter on its left half and darker on its right one.
class ComparePictureTest : public CliTest {
 protected:
  void SetUp() override {
    Image image(24, 16, 3, 0.2f);
    write("b.png", image);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x)
        for (int channel = 0; channel < 3; ++channel) image.texel(x, y)[channel] = x < 12 ? 0.4f : 0.1f;
    write("a.png", image);
  }

  Image8 picture(const std::string& name) const { return *decodeTexture(bytes(name)); }
};

TEST_F(ComparePictureTest, TheSignedMapIsRedAboveAndBlueBelow) {
  EXPECT_THAT(succeed("compare a.png b.png --heat-map map.png"), HasSubstr("full colour at a difference of 0.2"));
  const Image8 map = picture("map.png");
  ASSERT_EQ(map.width(), 24);
  ASSERT_EQ(map.height(), 16);
  EXPECT_GT(map.texel(3, 8)[0], map.texel(3, 8)[2] + 50) << "red";
  EXPECT_GT(map.texel(20, 8)[2], map.texel(20, 8)[0] + 50) << "blue";
  succeed("compare b.png a.png --heat-map other.png");
  EXPECT_GT(picture("other.png").texel(3, 8)[2], picture("other.png").texel(3, 8)[0] + 50) << "B is the reference";
  succeed("compare b.png b.png --heat-map equal.png");
  EXPECT_GT(picture("equal.png").texel(3, 8)[0], 235) << "nearly white where nothing differs";
}

TEST_F(ComparePictureTest, AScaleThatIsGivenIsKept) {
  EXPECT_THAT(succeed("compare a.png b.png --heat-map small.png --scale 0.05"), HasSubstr("at a difference of 0.05"));
  succeed("compare a.png b.png --heat-map large.png --scale 10");
  EXPECT_GT(picture("large.png").texel(3, 8)[2], picture("small.png").texel(3, 8)[2] + 100) << "hardly any colour";
}

TEST_F(ComparePictureTest, FlipsMapIsDarkWhereNothingIsSeen) {
  EXPECT_THAT(succeed("compare a.png b.png --heat-map map.png --map flip"), Not(HasSubstr("full colour")));
  EXPECT_GT(picture("map.png").texel(3, 8)[0], 60);
  succeed("compare b.png b.png --heat-map equal.png --map flip");
  EXPECT_LT(picture("equal.png").texel(3, 8)[0], 15);
}

TEST_F(ComparePictureTest, TheSheetHasAllThree) {
  succeed("compare a.png b.png --sheet sheet.png --heat-map map.jpg");
  EXPECT_THAT(files(), ElementsAre("a.png", "b.png", "map.jpg", "sheet.png"));
  const Image8 sheet = picture("sheet.png");
  EXPECT_GT(sheet.width(), 1320);
  const Image8 a = picture("a.png");
  const Image8 b = picture("b.png");
  const int y = 100;
  EXPECT_EQ(sheet.texel(30, y)[0], a.texel(0, 0)[0]);
  EXPECT_EQ(sheet.texel(500, y)[0], b.texel(0, 0)[0]);
  EXPECT_GT(sheet.texel(960, y)[0], sheet.texel(960, y)[2] + 50) << "the map";
}

TEST_F(ComparePictureTest, OutputsThatCannotBeAreRefusedFirst) {
  EXPECT_THAT(refuse(2, "compare a.png b.png --sheet sheet.exr"), HasSubstr(".png or .jpg"));
  EXPECT_THAT(refuse(2, "compare a.png b.png --sheet b.png"), HasSubstr("is the input itself"));
  EXPECT_THAT(refuse(2, "compare a.png b.png --sheet c.png --heat-map c.png"), HasSubstr("name two files"));
  EXPECT_THAT(refuse(2, "compare a.png b.png --sheet -.png"), HasSubstr("standard output has the numbers"));
  EXPECT_THAT(refuse(1, "compare a.png b.png --heat-map none/c.png"), HasSubstr("there is no folder none"));
}

TEST_F(ComparePictureTest, ABrokenThresholdStillLeavesTheSheet) {
  EXPECT_EQ(run("compare a.png b.png --threshold rmse=0 --sheet sheet.png").exit_code, 1);
  EXPECT_THAT(files(), ElementsAre("a.png", "b.png", "sheet.png"));
}

TEST_F(ComparePictureTest, CtrlCEndsItWithoutAFile) {
  write("large.exr", Image(3000, 2000, 3, 0.5f));
  Image dim(3000, 2000, 3, 0.25f);
  dim.texel(0, 0)[0] = 1e30f;  // a hundred exposures
  write("dim.exr", dim);
  Program program({.arguments = {"compare", "large.exr", "dim.exr", "--sheet", "sheet.png"}, .folder = path("")});
  program.waitUntilItCatchesInterrupts();
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(files(), ElementsAre("a.png", "b.png", "dim.exr", "large.exr"));
}

}  // namespace
}  // namespace mirrorball::testing
