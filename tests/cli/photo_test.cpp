// What photo says, and where.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A picture of a ball: dim, with a white and a black square in its middle.
class PhotoTest : public CliTest {
 protected:
  PhotoTest() {
    Image ball(64, 64, 3, 0.05f);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        if (glm::length(glm::vec2(x, y) + 0.5f - 32.0f) < 28.0f) std::fill_n(ball.texel(x, y), 3, 0.3f);
    for (int y = 30; y < 34; ++y) {
      for (int x = 20; x < 26; ++x) std::fill_n(ball.texel(x, y), 3, 1.0f);
      for (int x = 40; x < 45; ++x) std::fill_n(ball.texel(x, y), 3, 0.0f);
    }
    write("ball.png", ball);
  }

  const std::string line_ = "photo ball.png --circle 32,32,28 --size 32 -o ";
};

TEST_F(PhotoTest, LightThatIsNotRecordedIsToldInPlainWords) {
  const Outcome outcome = run(line_ + "map.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("mirrorball: note: 24 pixels are white: light there is brighter than recorded; add a "
                        "shorter exposure\n"));
  EXPECT_THAT(outcome.out, AllOf(StartsWith("light      one photograph, response assumed sRGB"),
                                 HasSubstr("\nball       circle 32.00,32.00,28.00 px, as given\n"),
                                 ContainsRegex("\nfilled     [0-9.]+ sr")));
}

TEST_F(PhotoTest, ToStandardOutputGoesTheMapAndNothingElse) {
  run(line_ + "map.exr");
  const Outcome outcome = run(line_ + "-.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(Bytes(outcome.out.begin(), outcome.out.end()) == bytes("map.exr"));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("light      one photograph"), HasSubstr("note: ")));
  const Outcome quiet = run(line_ + "other.exr --quiet");
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_TRUE(bytes("other.exr") == bytes("map.exr"));
  EXPECT_EQ(run("photo - --circle 32,32,28 --size 32 -o piped.exr", {.input = bytes("ball.png")}).exit_code, 0);
  EXPECT_TRUE(bytes("piped.exr") == bytes("map.exr"));
  EXPECT_THAT(refuse(2, "photo ball.png map2.exr"), HasSubstr("say -o map2.exr"));
}

// Before anything is read, and so with nothing told.
TEST_F(PhotoTest, AWrongCameraIsToldAtOnce) {
  EXPECT_THAT(refuse(2, line_ + "a.exr --distance 0.5"), HasSubstr("in radii of the ball, so more than 1"));
  EXPECT_THAT(refuse(2, line_ + "a.exr --distance 5 --fov 40"), HasSubstr("--distance and --fov say the same"));
}

}  // namespace
}  // namespace mirrorball::testing
