// The files that come out: formats, alpha, turntables, and the same bytes every time.

#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class OutputTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    if (!IsSkipped()) write("smooth.exr", smoothPanorama());
  }
};

TEST_F(OutputTest, RenderAloneDrawsTheShowcase) {
  ASSERT_EQ(Program({.arguments = {"render"}, .folder = path("")}).wait().exit_code, 0);
  EXPECT_THAT(files(), ElementsAre("mirrorball.png", "smooth.exr"));
  const Image picture = image("mirrorball.png");
  EXPECT_EQ(picture.width(), 1280);
  EXPECT_EQ(picture.height(), 720);
  ASSERT_EQ(Program({.arguments = Arguments("render --size 96x54 -o alone.png").words, .folder = path("")}).wait().err,
            "mirrorball: note: --quality good chose --refraction auto --behind screen --occlusion vertex "
            "--self-reflection\n");
  succeed(
      "render showcase -e sunset --env-rotation 270 --proxy ground:2.5 --ground-roughness 0.3 --refraction auto "
      "--self-reflection --behind screen --camera 30,9 --size 96x54 -o told.png");
  EXPECT_TRUE(bytes("told.png") == bytes("alone.png"));
}

TEST_F(OutputTest, EveryFormatShowsTheSame) {
  const std::string shot = "render sphere --material gold -e smooth.exr --size 64x48 -o ";
  for (const char* file : {"a.exr", "a.hdr", "a.png", "a.jpg", "a.jpeg", "B.PNG"}) {
    succeed(shot + file);
    EXPECT_EQ(image(file).width(), 64) << file;
    EXPECT_EQ(image(file).height(), 48) << file;
  }
  EXPECT_TRUE(bytes("a.jpg") == bytes("a.jpeg"));
  EXPECT_TRUE(bytes("a.png") == bytes("B.PNG"));
  // RGBE keeps 8 bits of the greatest channel; this light is at most 2.
  const Image radiance = image("a.exr");
  const Image rgbe = image("a.hdr");
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_LT(glm::length(rgbAt(rgbe, x, y) - rgbAt(radiance, x, y)), 2.0f / 256.0f);
  // JPEG is lossy: 35 dB is what its usual quality leaves of a picture with edges.
  EXPECT_GT(psnrOnDisplay(image("a.jpg"), image("a.png"), [](int, int) { return true; }), 35.0);
}

// EXR holds light times coverage, PNG the colour itself beside its coverage: at an edge the same as in the middle.
TEST_F(OutputTest, AlphaIsPremultipliedInExrAndStraightInPng) {
  const std::string shot = "render sphere --material mirror -e white --size 64x64 --background transparent ";
  succeed(shot + "-o a.exr");
  succeed(shot + "--dither none -o a.png");
  const Image premultiplied = image("a.exr");
  const Image straight = image("a.png");
  ASSERT_EQ(premultiplied.channels(), 4);
  ASSERT_EQ(straight.channels(), 4);
  int partial = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::vec4 light = rgbaAt(premultiplied, x, y);
      const glm::vec4 color = rgbaAt(straight, x, y);
      EXPECT_NEAR(light.x, light.w, 1e-3f) << "radiance 1 times alpha";
      EXPECT_NEAR(color.w, light.w, 0.5f / 255.0f + 1e-4f);
      if (light.w <= 0.0f || light.w >= 1.0f) continue;
      ++partial;
      EXPECT_EQ(color.x, rgbaAt(straight, 32, 32).x) << "the colour of the middle";
    }
  EXPECT_GT(partial, 50);
}

TEST_F(OutputTest, AnOpaquePictureHasAlpha1) {
  succeed("render sphere -e white --size 16x16 -o a.png");
  succeed("render sphere -e white --size 16x16 -o a.exr");
  for (const char* file : {"a.png", "a.exr"})
    for (int x = 0; x < 16; ++x) EXPECT_EQ(rgbaAt(image(file), x, 0).w, 1.0f) << file;
}

TEST_F(OutputTest, ATurntableIsNumberedPicturesOnceRound) {
  const std::string shot = "render cube --material mirror -e smooth.exr --size 32x32 --camera 10,20,4";
  succeed(shot + " --frames 4 -o turn.png");
  EXPECT_THAT(files(), ElementsAre("smooth.exr", "turn_000.png", "turn_001.png", "turn_002.png", "turn_003.png"));
  for (const auto& [frame, azimuth] : {std::pair{"0", "10"}, {"1", "100"}, {"2", "190"}, {"3", "280"}}) {
    succeed("render cube --material mirror -e smooth.exr --size 32x32 -o still.png --camera " + std::string(azimuth) +
            ",20,4");
    EXPECT_TRUE(bytes("still.png") == bytes(std::string("turn_00") + frame + ".png")) << "frame " << frame;
  }
}

TEST_F(OutputTest, ATurntableTurnsWhatItIsTold) {
  const std::string shot = "render cube --material mirror -e smooth.exr --size 32x32 ";
  const std::string camera = "--camera 10,20,4";
  const auto isStill = [&](const std::string& turning, const std::string& still) {
    succeed(shot + camera + " --frames 4 -o turn.png --turn " + turning);
    succeed(withUsual(shot + "-o still.png " + still, {camera}));
    return bytes("turn_001.png") == bytes("still.png");
  };
  EXPECT_TRUE(isStill("camera", "--camera 100,20,4"));
  EXPECT_TRUE(isStill("environment", "--env-rotation 90"));
  EXPECT_TRUE(isStill("model", "--camera -80,20,4 --env-rotation -90"));
  // The environment stands still behind a turning model: corners of the picture show nothing else.
  for (const char* frame : {"turn_001.png", "turn_002.png", "turn_003.png"})
    EXPECT_LT(glm::length(rgbAt(image(frame), 0, 0) - rgbAt(image("turn_000.png"), 0, 0)), 0.01f) << frame;
}

TEST_F(OutputTest, ATurntablesNumbersStandWhereTheNameHasThem) {
  const std::string shot = "render none -e white --size 8x8 --frames 2 -o ";
  for (const char* output : {"a_%04d.png", "b##.png", "c_%d_end.png", "d#.png"}) succeed(shot + output);
  EXPECT_THAT(files(), ElementsAre("a_0000.png", "a_0001.png", "b00.png", "b01.png", "c_0_end.png", "c_1_end.png",
                                   "d#_000.png", "d#_001.png", "smooth.exr"));
  EXPECT_THAT(refuse(2, shot + "%d_####.png"), HasSubstr("2 places"));
  for (const std::string output : {"%04d.png", "e_####.exr"}) {
    const Outcome one = run("render none -e white --size 8x8 -o " + output);
    EXPECT_EQ(one.exit_code, 0);
    EXPECT_EQ(one.err, "mirrorball: note: " + output +
                           ": is one picture under that very name; --frames N makes several, with numbers in their "
                           "names\n");
    EXPECT_THAT(files(), Contains(output));
  }
}

// Each for itself they would be framed by what is seen then, and the model would shrink and grow while it turns.
TEST_F(OutputTest, AllPicturesOfATurntableHaveOneFraming) {
  const std::string shot = "render teapot -e white --size 64x48 --background transparent --orthographic ";
  succeed(shot + "--camera 0,0 --frames 5 -o turn.exr");
  const auto rowsOf = [&](const std::string& file) {
    const Image picture = image(file);
    std::vector<int> rows;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x)
        if (rgbaAt(picture, x, y).w > 0.0f && (rows.empty() || rows.back() != y)) rows.push_back(y);
    return rows;
  };
  const std::vector<int> first = rowsOf("turn_000.exr");
  for (const char* other : {"turn_001.exr", "turn_002.exr", "turn_003.exr", "turn_004.exr"})
    EXPECT_EQ(rowsOf(other), first) << other;
  succeed(shot + "-o still.exr --camera 72,0");
  EXPECT_GT(rowsOf("still.exr").size(), first.size()) << "seen from this side it is narrower than the whole turn";
}

TEST_F(OutputTest, AnOutputThatWasThereIsReplaced) {
  write("out.exr", std::string("something else"));
  succeed("convert smooth.exr --to sphere --size 16 -o out.exr");
  EXPECT_EQ(image("out.exr").width(), 16);
  std::filesystem::create_directory(path("folder"));
  succeed("convert smooth.exr --to sphere --size 16 -o folder/out.exr");
  EXPECT_THAT(files(), ElementsAre("folder/", "folder/out.exr", "out.exr", "smooth.exr"));
}

TEST_F(OutputTest, ConvertKeepsTheInputsDetailUnlessToldASize) {
  succeed("convert smooth.exr --to cube --layout hstrip -o strip.exr");
  EXPECT_EQ(image("strip.exr").height(), 16) << "half of a panorama's height";
  succeed("convert smooth.exr --to sphere -o ball.exr");
  EXPECT_EQ(image("ball.exr").height(), 32);
  succeed("convert smooth.exr --to cube --layout hstrip --size 10 -o strip.exr");
  EXPECT_EQ(image("strip.exr").height(), 10);
}

/// Expects the same bytes from two runs, and from one core and from all.
void expectTheSameAgain(const std::function<void(const std::string& output, Start how)>& make,
                        const std::function<Bytes(const std::string&)>& bytes) {
  make("all", {});
  make("again", {});
  make("one", {.cores = 1});
  EXPECT_TRUE(bytes("all") == bytes("again")) << "another run gives another file";
  EXPECT_TRUE(bytes("all") == bytes("one")) << "one core gives another file";
}

TEST_F(OutputTest, ALinkIsWrittenThrough) {
  write("far.exr", std::string("old"));
  std::filesystem::create_symlink("far.exr", path("near.exr"));
  std::filesystem::create_symlink("/dev/null", path("nothing.exr"));
  for (const std::string output : {"near.exr", "nothing.exr"}) {
    succeed("convert smooth.exr --to sphere --size 8 -o " + output);
    EXPECT_TRUE(std::filesystem::is_symlink(path(output))) << output;
  }
  EXPECT_EQ(image("far.exr").width(), 8);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

// Takes seconds: fifteen runs, five of them on one core.
TEST_F(OutputTest, EveryRunGivesTheSameBytes) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is one core only";
  const std::vector<std::pair<std::string, std::string>> commands{
      {"convert sky:elevation=10 --to sphere --size 64", ".exr"},
      {"convert smooth.exr --to sphere --size 128", ".hdr"},
      {"convert smooth.exr --to angular --size 128", ".png"},
      {"render showcase -e smooth.exr --size 96x64", ".png"},
      {"render showcase -e sky --size 96x64", ".exr"}};
  for (const auto& each : commands) {
    const auto& command = each.first;
    const auto& extension = each.second;
    SCOPED_TRACE(command);
    expectTheSameAgain(
        [&](const std::string& output, Start how) { succeed(command + " -o " + output + extension, std::move(how)); },
        [&](const std::string& output) { return bytes(output + extension); });
  }
}

}  // namespace
}  // namespace mirrorball::testing
