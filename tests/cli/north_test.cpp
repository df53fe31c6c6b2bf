// info --north and convert --mark-north, by the compass heading that a panorama's file states.

#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/photo_sphere_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A grey panorama of 512 × 256 as a camera writes it, with a heading.
class NorthTest : public CliTest {
 protected:
  NorthTest() {
    write("plain.jpg", Image(512, 256, 3, 0.2f));
    writeSphere("pano.jpg", "GPano:PoseHeadingDegrees=\"90\"");
  }

  void writeSphere(const std::string& name, const std::string& attributes) const {
    write(name, asPhotoSphere(bytes("plain.jpg"), attributes));
  }

  /// The brightest texel of a row, and how many are brighter than the grey.
  static std::pair<int, int> brightIn(const Image& image, int y) {
    int brightest = 0, count = 0;
    for (int x = 0; x < image.width(); ++x) {
      if (image.texel(x, y)[0] > image.texel(brightest, y)[0]) brightest = x;
      if (image.texel(x, y)[0] > 0.3f) ++count;
    }
    return {brightest, count};
  }
};

// Who looks east has north on the left, a quarter of the panorama away from its middle.
TEST_F(NorthTest, InfoStatesWhereNorthIs) {
  EXPECT_THAT(succeed("info pano.jpg"),
              HasSubstr("\n  north        1 0 0, column 128 of 512 (GPano:PoseHeadingDegrees 90)\n"));
  EXPECT_EQ(succeed("info --north pano.jpg"),
            "  north        1 0 0, column 128 of 512 (GPano:PoseHeadingDegrees 90)\n");
  EXPECT_THAT(succeed("info plain.jpg"), Not(HasSubstr("north")));
  writeSphere("tilted.jpg", "GPano:PoseHeadingDegrees='270' GPano:PosePitchDegrees='4' GPano:PoseRollDegrees='-2.5'");
  const Outcome level = run("info --north tilted.jpg");
  EXPECT_THAT(level.out, HasSubstr("  north        -1 0 0, column 384 of 512 (GPano:PoseHeadingDegrees 270, pitch 4, "
                                   "roll -2.5)"));
  EXPECT_THAT(level.err, HasSubstr("levelled"));
  // The camera is rolled counter-clockwise: what is on its right is seen lower.
  EXPECT_THAT(succeed("info --north --from equirect:level=no tilted.jpg"),
              HasSubstr("  north        -0.99905 -0.043619 0, column 384 of 512"));
  EXPECT_THAT(succeed("info --north --direction 0,0,1 pano.jpg"), AllOf(StartsWith("direction "), HasSubstr("north")));
}

TEST_F(NorthTest, ProgramsGetTheSame) {
  const nlohmann::json north = nlohmann::json::parse(succeed("info --json pano.jpg"))["north"];
  EXPECT_NEAR(north["direction"][0].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(north["up"][1].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(north["column"].get<double>(), 128.0, 1e-2);
  EXPECT_EQ(north["heading"], 90.0);
  EXPECT_EQ(north["is_magnetic"], false);
  EXPECT_EQ(north["source"], "GPano:PoseHeadingDegrees");
  EXPECT_FALSE(nlohmann::json::parse(succeed("info --json plain.jpg")).contains("north"));
}

TEST_F(NorthTest, WithoutAHeadingThatIsSaid) {
  const std::string line =
      "plain.jpg: states no compass heading; looked for GPano:PoseHeadingDegrees in XMP, GPSImgDirection in EXIF";
  EXPECT_THAT(refuse(1, "info --north plain.jpg"), HasSubstr(line));
  EXPECT_THAT(refuse(1, "convert --mark-north plain.jpg -o out.png"), HasSubstr(line));
  EXPECT_THAT(refuse(1, "convert --mark-north sky --to cube -o out.png"), HasSubstr("states no compass heading"));
  EXPECT_THAT(refuse(1, "info --north --from octahedral pano.jpg"), HasSubstr("pano.jpg: "));
  EXPECT_THAT(refuse(1, "info --north sky"), HasSubstr("is a function of the direction"));
  const Outcome many = run("info --north pano.jpg plain.jpg");
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_THAT(many.out, HasSubstr("pano.jpg\n  north "));
}

TEST_F(NorthTest, AWrongHeadingIsNamedAndNothingElseFails) {
  writeSphere("wrong.jpg", "GPano:PoseHeadingDegrees='20' GPano:PosePitchDegrees='200'");
  const std::string line = "wrong.jpg: its GPano:PosePitchDegrees is '200', which is not a number from -90 to 90";
  EXPECT_THAT(refuse(1, "info --north wrong.jpg"), HasSubstr(line));
  EXPECT_THAT(refuse(1, "convert --mark-north wrong.jpg -o out.png"), HasSubstr(line));
  const Outcome outcome = run("info wrong.jpg");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: " + line));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("size         512x256"), Not(HasSubstr("north "))));
}

TEST_F(NorthTest, TheMarkIsWhereNorthIs) {
  succeed("convert --mark-north pano.jpg -o marked.exr");
  const Image marked = image("marked.exr");
  const auto [column, count] = brightIn(marked, 128);
  EXPECT_NEAR(column, 128, 1);
  EXPECT_GE(count, 1);
  EXPECT_LE(count, 3);
  EXPECT_EQ(brightIn(marked, 40).second, 0);
  succeed("convert pano.jpg -o plain.exr");
  EXPECT_EQ(marked.texel(300, 128)[1], image("plain.exr").texel(300, 128)[1]) << "the rest stays";
}

TEST_F(NorthTest, TheMarkGoesAlongIntoEveryForm) {
  succeed("convert --mark-north pano.jpg --centre 1,0,0 -o centred.exr");
  EXPECT_NEAR(brightIn(image("centred.exr"), 128).first, 256, 1);
  succeed("convert --mark-north pano.jpg --to cube --size 128 -o cube.ktx2");
  const ImageSet cube = texture("cube.ktx2");
  EXPECT_GT(texelTowards(cube, 0, {1.0f, -0.02f, 0.0f}).x, 0.4f);
  EXPECT_NEAR(texelTowards(cube, 0, {-1.0f, -0.02f, 0.0f}).x, 0.2f, 0.02f);
  succeed("convert --mark-north pano.jpg --to octahedral --size 256 -o octahedral.exr");
  EXPECT_GT(environment("octahedral.exr").environment.radiance({1.0f, 0.0f, 0.0f}).x, 0.4f);
  succeed("convert --mark-north pano.jpg --extension png -o folder/");
  EXPECT_EQ(image("folder/pano.png").width(), 512);
}

}  // namespace
}  // namespace mirrorball::testing
