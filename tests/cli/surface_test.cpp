// What `mirrorball surface` writes and says.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A hill of 16-bit codes, grey, as text: 8 × 8, highest at (4, 4).
std::string hill() {
  std::string text = "P2 8 8 65535\n";
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) text += std::to_string(65535 - 4000 * (std::abs(x - 4) + std::abs(y - 4))) + "\n";
  return text;
}

class SurfaceTest : public CliTest {
 protected:
  void SetUp() override { write("hill.pgm", hill()); }
};

// Heights are 16-bit codes as they are, not sRGB: 8000 codes over two texels of 8 across.
TEST_F(SurfaceTest, SlopesAreOfTheCodesThemselves) {
  EXPECT_THAT(succeed("surface hill.pgm --to derivative --scale 0.5 -o slopes.exr"), IsEmpty());
  const Image slopes = image("slopes.exr");
  const float slope = 0.5f * 8.0f * 4000.0f / 65535.0f;
  EXPECT_NEAR(slopes.texel(2, 4)[0], slope, 1e-6f);
  EXPECT_EQ(slopes.texel(2, 4)[1], 0.0f);
  EXPECT_NEAR(slopes.texel(2, 4)[2], 0.0f, 1e-6f);
  EXPECT_NEAR(slopes.texel(2, 6)[2], -slope, 1e-6f);
}

TEST_F(SurfaceTest, NormalsInPngAreSharesWithGreenUpOrDown) {
  succeed("surface hill.pgm --scale 0.5 -o normal.png");
  succeed("surface hill.pgm --scale 0.5 --directx -o directx.png");
  succeed("surface hill.pgm --scale 0.5 -o normal.exr");
  const Image8 codes = decodeTexture(bytes("normal.png")).value();
  const Image8 flipped = decodeTexture(bytes("directx.png")).value();
  const Image normals = image("normal.exr");
  // Above the top of the hill the ground rises downwards: the normal leans up.
  EXPECT_GT(normals.texel(4, 2)[1], 0.2f);
  EXPECT_LT(normals.texel(2, 4)[0], -0.2f);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) {
        const float share = 0.5f + 0.5f * normals.texel(x, y)[c];
        ASSERT_EQ(codes.texel(x, y)[c], std::lround(255.0f * share));
        ASSERT_EQ(flipped.texel(x, y)[c], std::lround(255.0f * (c == 1 ? 1.0f - share : share)));
      }
}

TEST_F(SurfaceTest, HeightsComeBackAndTellTheirScale) {
  succeed("surface hill.pgm --scale 0.5 --difference forward -o normal.exr");
  const std::string told = succeed("surface normal.exr --to height --difference forward -o height.exr");
  EXPECT_THAT(told, ::testing::StartsWith("scale 0.24"));  // the hill is 8 · 4000 codes high, of 65535 at 0.5
  const Image heights = image("height.exr");
  EXPECT_NEAR(heights.texel(4, 4)[0], 1.0f, 1e-4f);
  EXPECT_NEAR(heights.texel(0, 0)[0], 0.0f, 1e-4f);
  EXPECT_NEAR(heights.texel(2, 4)[0], 0.75f, 1e-4f);
  EXPECT_THAT(succeed("surface normal.exr --to height --difference forward --scale 0.5 -o same.exr"), IsEmpty());
  EXPECT_THAT(succeed("surface weave --to height -o weave.png"), IsEmpty());
  EXPECT_NEAR(image("same.exr").texel(4, 4)[0], 8.0f * 4000.0f / 65535.0f, 1e-4f);
}

TEST_F(SurfaceTest, EightBitsWithGreenDownAreReadAsTheyAreWritten) {
  succeed("surface hill.pgm --scale 0.1 --directx -o directx.png");
  const std::string told = succeed("surface directx.png --to height --directx -o height.exr");
  EXPECT_NEAR(std::stof(told.substr(6)), 0.1f * 32000.0f / 65535.0f, 0.01f);
  EXPECT_GT(image("height.exr").texel(4, 4)[0], 0.95f);
}

TEST_F(SurfaceTest, APyramidIsATexturesMipLevels) {
  succeed("surface hill.pgm --to pyramid --edges clamped -o pyramid.ktx2");
  const ImageSet pyramid = texture("pyramid.ktx2");
  ASSERT_EQ(pyramid.levels(), 4);
  EXPECT_NEAR(pyramid.at(0, 0).texel(0, 0)[0], 1.0f - 6 * 4000.0f / 65535.0f, 1e-6f);
  EXPECT_EQ(pyramid.at(3, 0).texel(0, 0)[0], 1.0f);
  EXPECT_THAT(refuse(2, "surface hill.pgm --to pyramid -o pyramid.png"), HasSubstr(".ktx2"));
}

TEST_F(SurfaceTest, ConesAndOcclusionAreShares) {
  for (const std::string map : {"cone", "occlusion", "bent-normal", "cone --cones relaxed", "occlusion --azimuths 8"}) {
    succeed("surface hill.pgm --to " + map + " -o map.png");
    EXPECT_EQ(image("map.png").width(), 8) << map;
  }
  Image tower(8, 8, 1);
  tower.texel(4, 4)[0] = 1.0f;
  write("tower.exr", tower);
  succeed("surface tower.exr --to cone -o cone.exr");
  EXPECT_EQ(image("cone.exr").texel(4, 4)[0], 1.0f);
  EXPECT_NEAR(image("cone.exr").texel(2, 4)[0], std::sqrt(2.0f / 8.0f), 1e-6f);
}

TEST_F(SurfaceTest, NormalsGoToTheAxesOfAMeshAndBack) {
  succeed("surface hill.pgm --scale 0.2 -o normal.exr");
  succeed("surface normal.exr --to object-normal --model cube -o object.exr");
  succeed("surface object.exr --to tangent-normal --model cube -o tangent.exr");
  const Image before = image("normal.exr"), object = image("object.exr"), after = image("tangent.exr");
  float turned = 0.0f;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      EXPECT_LT(glm::distance(rgbAt(after, x, y), rgbAt(before, x, y)), 1e-5f);
      turned = std::max(turned, glm::distance(rgbAt(object, x, y), rgbAt(before, x, y)));
    }
  EXPECT_GT(turned, 1.0f);

  // Green down, of the map in tangent space alone.
  succeed("surface hill.pgm --scale 0.2 --directx -o down.exr");
  succeed("surface down.exr --to object-normal --directx --model cube -o same.exr");
  EXPECT_EQ(bytes("same.exr"), bytes("object.exr"));

  EXPECT_THAT(refuse(2, "surface normal.exr --to object-normal -o a.exr"), HasSubstr("--model"));
  EXPECT_THAT(refuse(2, "surface hill.pgm --model cube -o a.exr"), HasSubstr("--model"));
  EXPECT_THAT(refuse(2, "surface normal.exr --to object-normal --model cube --edges clamped -o a.exr"),
              HasSubstr("--edges"));
  EXPECT_THAT(refuse(1, "surface hill.pgm --to object-normal --model cube -o a.exr"), HasSubstr("is grey"));
  EXPECT_THAT(refuse(1, "surface normal.exr --to object-normal --model cub -o a.exr"), HasSubstr("cube"));
  write("bare.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_THAT(refuse(1, "surface normal.exr --to object-normal --model bare.obj -o a.exr"),
              HasSubstr("bare.obj: has no texture coordinates"));
  write("long.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 99999 0\nvt 0 1\nf 1/1 2/2 3/3\n"));
  EXPECT_THAT(refuse(1, "surface normal.exr --to object-normal --model long.obj -o a.exr"),
              HasSubstr("long.obj: a triangle reaches over"));
}

TEST_F(SurfaceTest, SaysWhatWasLost) {
  const Outcome outcome = run("surface hill.pgm --to derivative --scale 10 -o slopes.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: slopes.png: "));
  Image colored(4, 4, 3, 0.5f);
  colored.texel(1, 1)[2] = 0.0f;
  write("colored.exr", colored);
  EXPECT_THAT(run("surface colored.exr -o normal.png").err, HasSubstr("red channel"));
}

TEST_F(SurfaceTest, PassesThroughPipes) {
  EXPECT_EQ(succeed("surface - -o -.png", {.input = bytes("hill.pgm")}), [&] {
    succeed("surface hill.pgm -o file.png");
    const Bytes file = bytes("file.png");
    return std::string(file.begin(), file.end());
  }());
}

TEST_F(SurfaceTest, RefusesWithOneLine) {
  EXPECT_THAT(refuse(2, "surface"), HasSubstr("height map"));
  EXPECT_THAT(refuse(2, "surface hill.pgm"), HasSubstr("-o"));
  EXPECT_THAT(refuse(2, "surface hill.pgm -o normal.jpg"), HasSubstr(".png"));
  EXPECT_THAT(refuse(2, "surface hill.pgm --to cone --scale 2 -o cone.png"), HasSubstr("--scale"));
  EXPECT_THAT(refuse(2, "surface hill.pgm --azimuths 16 -o normal.png"), HasSubstr("--azimuths"));
  EXPECT_THAT(refuse(2, "surface hill.pgm --to bump -o normal.png"), HasSubstr("derivative"));
  EXPECT_THAT(refuse(1, "surface hill.pgm -o nowhere/normal.png"), HasSubstr("nowhere"));
  EXPECT_THAT(refuse(1, "surface hill.pgm --to height -o height.exr"), HasSubstr("hill.pgm: is grey"));
  EXPECT_THAT(refuse(1, "surface absent.png -o normal.png"), HasSubstr("absent.png"));
  Image bad(8, 4, 1);
  bad.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  write("bad.exr", bad);
  EXPECT_THAT(refuse(1, "surface bad.exr -o normal.png"),
              HasSubstr("bad.exr: 1 texel is NaN or infinite, the first at (3, 1)"));
  write("large.exr", Image(512, 512, 1));
  EXPECT_THAT(refuse(1, "surface large.exr --max-memory 2M -o normal.png"),
              AllOf(HasSubstr("raise --max-memory"), Not(HasSubstr("--size"))));
  Image down(2, 2, 3, -1.0f);
  for (std::size_t red = 0; red < down.samples().size(); red += 3) down.samples()[red] = -0.5f;
  write("down.exr", down);
  EXPECT_THAT(refuse(1, "surface down.exr --to height -o height.exr"), HasSubstr("(0, 0) does not point out"));
  EXPECT_THAT(refuse(1, "surface down.exr --to height --scale 0 -o height.exr"), HasSubstr("scale of 0"));
}

}  // namespace
}  // namespace mirrorball::testing
