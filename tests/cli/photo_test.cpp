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

TEST_F(PhotoTest, ADoubtfulBallIsToldWithTheWayOut) {
  // Two balls alike; a picture without any.
  Image balls(240, 120, 3, 0.05f);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 240; ++x)
      if (glm::length(glm::vec2(x % 120, y) + 0.5f - 60.0f) < 40.0f)
        std::fill_n(balls.texel(x, y), 3, y / 8 % 2 == x / 8 % 2 ? 0.3f : 0.6f);
  write("balls.png", balls);
  const Outcome outcome = run("photo balls.png --size 32 -o map.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(
      outcome.err,
      ContainsRegex("mirrorball: note: balls.png: this circle may not be the ball's \\(confidence [0-9]+ %; the "
                    "next likely one is about [0-9]+,60,40\\): .*--debug found.png.* --circle X,Y,R\n$"));
  EXPECT_THAT(run("photo balls.png --circle 60,60,40 --size 32 -o map.exr").err, Not(HasSubstr("may not be")));
  EXPECT_THAT(run("photo ball.png --circle 32,32,28 --second balls.png --second-rotation 90 --size 32 -o map.exr").err,
              HasSubstr(" with --second-circle X,Y,R"));
  write("wall.png", Image(200, 150, 3, 0.5f));
  const Outcome none = run("photo wall.png -o map.exr");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("wall.png: no mirror ball is found; give it with --circle X,Y,R in pixels\n"));
  EXPECT_THAT(run("photo ball.png --circle 32,32,28 --second wall.png --size 32 -o map.exr").err,
              HasSubstr("wall.png: no mirror ball is found; give it with --second-circle X,Y,R in pixels\n"));
}

// Before anything is read, and so with nothing told.
TEST_F(PhotoTest, AWrongCameraIsToldAtOnce) {
  EXPECT_THAT(refuse(2, line_ + "a.exr --distance 0.5"), HasSubstr("in radii of the ball, so more than 1"));
  EXPECT_THAT(refuse(2, line_ + "a.exr --distance 5 --fov 40"), HasSubstr("--distance and --fov say the same"));
}

}  // namespace
}  // namespace mirrorball::testing
