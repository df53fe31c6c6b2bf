// --centre, --rotate and --filter: where light goes, and what is seen between texels.

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball::testing {
namespace {

std::string textOf(glm::vec3 v) {
  std::ostringstream text;
  text << v.x << ',' << v.y << ',' << v.z;
  return text.str();
}

class ConvertRotationTest : public CliTest {
 protected:
  void SetUp() override { write("map.exr", smoothPanorama()); }

  /// Expects a map to have at one direction the light that map.exr has at another. Twice interpolated, that smooth
  /// light is off by about 1e-3.
  void expectMoved(const std::string& file, glm::vec3 from, glm::vec3 to) const {
    const glm::vec3 before = environment("map.exr").environment.radiance(glm::normalize(from));
    const glm::vec3 after = environment(file).environment.radiance(glm::normalize(to));
    EXPECT_LT(glm::length(after - before), 4e-3f) << file << ": " << textOf(from) << " to " << textOf(to);
  }
};

TEST_F(ConvertRotationTest, CentrePutsADirectionInTheMiddle) {
  for (const glm::vec3 centre : {glm::vec3(1, 0, 0), {0, 0, -1}, {0, 1, 0}, {-0.84f, 0.23f, 0.49f}, {3, -4, 0}}) {
    for (const std::string to : {"equirect", "cube", "sphere"}) {
      succeed("convert map.exr --to " + to + " --size 64 -o centred.exr --centre " + textOf(centre));
      expectMoved("centred.exr", centre, {0, 0, 1});
      // Of a sphere map that is the rim, where a texel spans much.
      if (to != "sphere") expectMoved("centred.exr", -centre, {0, 0, -1});
    }
  }
}

// What info prints of the middle is what it printed of the direction: to the 1e-3 of two interpolations.
TEST_F(ConvertRotationTest, InfoFindsTheLightWhereItWasBrought) {
  const auto radiance = [&](const std::string& arguments) {
    const std::string said = succeed("info " + arguments);
    std::istringstream numbers(said.substr(said.find("radiance") + 8));
    glm::vec3 light(-1.0f);
    numbers >> light.x >> light.y >> light.z;
    return light;
  };
  succeed("convert map.exr --to equirect --size 64 -o centred.exr --centre -0.84,0.23,0.49");
  const glm::vec3 before = radiance("map.exr --direction -0.84,0.23,0.49");
  EXPECT_GT(before.x, 0.1f);
  EXPECT_LT(glm::length(radiance("centred.exr --direction 0,0,1") - before), 4e-3f);
  EXPECT_EQ(radiance("map.exr --direction -0.84e-30,0.23e-30,0.49e-30"), before) << "lengths do not matter";
  succeed("convert map.exr --centre -0.84e25,0.23e25,0.49e25 -o far.exr");
  EXPECT_LT(glm::length(radiance("far.exr --direction 0,0,1") - before), 4e-3f);
  EXPECT_GT(glm::length(radiance("centred.exr --direction -0.84,0.23,0.49") - before), 0.1f);
}

TEST_F(ConvertRotationTest, CentreLeavesUpUp) {
  const std::array<std::pair<const char*, const char*>, 4> kCentres{
      {{"1,0,0", "+X"}, {"-1,0,0", "-X"}, {"0,0,-1", "-Z"}, {"0,0,2", "+Z"}}};
  for (const auto& [centre, face] : kCentres) {
    succeed("convert uv --to equirect --size 256 -o uv.exr --centre " + std::string(centre));
    const Image map = image("uv.exr");
    EXPECT_EQ(uvFaceAt(map, {0.5f, 0.5f}), face);
    EXPECT_EQ(uvFaceAt(map, {0.5f, 0.0f}), "+Y");
    EXPECT_EQ(orientationOfName(map, {0.375f, 0.25f}, {0.25f, 0.5f}), "upright") << face;
  }
  // What was 45° above +Z stands in the middle, and what was above it still is.
  succeed("convert map.exr --to equirect --size 64 -o tilted.exr --centre 0,1,1");
  expectMoved("tilted.exr", {0, 1, -1}, {0, 1, 0});
  expectMoved("tilted.exr", {1, 0, 0}, {1, 0, 0});
}

TEST_F(ConvertRotationTest, EachAngleTurnsAboutItsAxis) {
  succeed("convert map.exr --to equirect --size 64 -o yaw.exr --rotate 90");
  expectMoved("yaw.exr", {0, 0, 1}, {1, 0, 0});
  expectMoved("yaw.exr", {1, 0, 0}, {0, 0, -1});
  expectMoved("yaw.exr", {0, 1, 0}, {0, 1, 0});
  succeed("convert map.exr --to equirect --size 64 -o pitch.exr --rotate 0,90");
  expectMoved("pitch.exr", {0, 1, 0}, {0, 0, 1});
  expectMoved("pitch.exr", {1, 0, 0}, {1, 0, 0});
  succeed("convert map.exr --to equirect --size 64 -o roll.exr --rotate 0,0,90");
  expectMoved("roll.exr", {1, 0, 0}, {0, 1, 0});
  expectMoved("roll.exr", {0, 0, 1}, {0, 0, 1});
  // 30° of yaw: cos 30° along +Z, sin 30° towards +X.
  succeed("convert map.exr --to equirect --size 64 -o part.exr --rotate 30");
  expectMoved("part.exr", {0, 0, 1}, {0.5f, 0, 0.8660f});
}

// Roll takes +Y to -X, which pitch leaves, and yaw takes to +Z; the other orders of turns by 90° lead elsewhere.
TEST_F(ConvertRotationTest, RollComesFirstThenPitchThenYawAllAfterCentre) {
  succeed("convert map.exr --to cube --size 32 -o turned.exr --rotate 90,90,90");
  expectMoved("turned.exr", {0, 1, 0}, {0, 0, 1});
  expectMoved("turned.exr", {1, 0, 0}, {1, 0, 0});
  expectMoved("turned.exr", {0, 0, 1}, {0, -1, 0});
  succeed("convert map.exr --to cube --size 32 -o both.exr --centre 0,1,0 --rotate 90");
  expectMoved("both.exr", {0, 1, 0}, {1, 0, 0});
}

TEST_F(ConvertRotationTest, ATurnAndItsInverseMeetAgain) {
  succeed("convert map.exr --to equirect --size 128 -o there.exr --rotate 40");
  succeed("convert there.exr --to equirect --size 32 -o back.exr --rotate -40");
  EXPECT_LT(maxDifference(image("back.exr"), image("map.exr")), 4e-3);
  EXPECT_GT(maxDifference(image("there.exr"), image("map.exr")), 0.1);
}

// Between the texels of smooth light, bilinear's error falls with the square of their distance and Catmull-Rom's with
// its fourth power at the places halfway.
TEST_F(ConvertRotationTest, BicubicIsTheUsualFilterAndTheMoreExactOne) {
  const std::string finer = "convert map.exr --to equirect --size 128 -o ";
  succeed(finer + "usual.exr");
  succeed(finer + "bicubic.exr --filter bicubic");
  succeed(finer + "bilinear.exr --filter bilinear");
  EXPECT_TRUE(bytes("usual.exr") == bytes("bicubic.exr"));
  const Environment exact(smoothRadiance, 128);
  const auto everywhere = [](glm::vec3) { return true; };
  const double bicubic = testing::psnr(environment("bicubic.exr").environment, exact, everywhere);
  const double bilinear = testing::psnr(environment("bilinear.exr").environment, exact, everywhere);
  RecordProperty("bicubic_db", std::to_string(bicubic));
  RecordProperty("bilinear_db", std::to_string(bilinear));
  EXPECT_GT(bicubic, bilinear + 10.0);
}

// A lone bright texel: bilinear's hat is 3/4 high a quarter of a texel beside the centre, Catmull-Rom's bell higher.
TEST_F(ConvertRotationTest, BilinearIsTheHatAndBicubicTheBell) {
  // Of so little contrast that the cubic is not held back.
  Image panorama(64, 32, 3, 0.25f);
  std::fill_n(panorama.texel(40, 16), 3, 1.0f);
  write("spot.exr", panorama);
  const auto lookUp = [&](const std::string& filter) {
    succeed("convert spot.exr --to equirect --size 64 -o " + filter + ".exr --filter " + filter);
    // Texel 80 of 128 has its centre at 40.25 of 64, a quarter left of that of texel 40; row 32 likewise above 16's.
    return rgbAt(image(filter + ".exr"), 80, 32).x;
  };
  EXPECT_NEAR(lookUp("bilinear"), 0.25f + 0.75f * 0.75f * 0.75f, 1e-4f);
  // (1.5 t − 2.5) t² + 1 at t = ¼, across and down.
  EXPECT_NEAR(lookUp("bicubic"), 0.25f + 0.75f * 0.8671875f * 0.8671875f, 1e-4f);
}

TEST_F(ConvertRotationTest, WhereTheOutputIsCoarserTheFilterDoesNotMatter) {
  for (const std::string filter : {"bilinear", "bicubic"})
    succeed("convert map.exr --to equirect --size 8 -o " + filter + ".exr --filter " + filter);
  EXPECT_TRUE(bytes("bilinear.exr") == bytes("bicubic.exr"));
}

}  // namespace
}  // namespace mirrorball::testing
