// The light around a point of a scene, as a map in any form.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class CaptureTest : public RenderCliTest {
 protected:
  /// A scene of six squares that face the origin from distance 1, each of half a unit and in its own colour: +X red, −X
  /// cyan, +Y green, −Y magenta, +Z blue, −Z yellow, as `uv` has them.
  void writeSquares() const {
    const std::vector<std::pair<std::string, glm::vec3>> colors{{"1 0 0", {1, 0, 0}}, {"0 1 1", {-1, 0, 0}},
                                                                {"0 1 0", {0, 1, 0}}, {"1 0 1", {0, -1, 0}},
                                                                {"0 0 1", {0, 0, 1}}, {"1 1 0", {0, 0, -1}}};
    std::string model = "mtllib squares.mtl\n";
    std::string materials;
    int vertices = 0;
    for (const auto& [color, axis] : colors) {
      const std::string name = "m" + std::to_string(vertices);
      materials += "newmtl " + name + "\nKd 0 0 0\nKs 0 0 0\nKe " + color + "\n";
      model += "usemtl " + name + "\n";
      const glm::vec3 across = glm::vec3(axis.y, axis.z, axis.x) / 4.0f;
      const glm::vec3 up = glm::cross(axis, across);
      for (const glm::vec3 corner : {axis - across - up, axis - across + up, axis + across + up, axis + across - up})
        model +=
            "v " + std::to_string(corner.x) + " " + std::to_string(corner.y) + " " + std::to_string(corner.z) + "\n";
      model += "f";
      for (int i = 1; i <= 4; ++i) model += " " + std::to_string(vertices + i);
      model += "\n";
      vertices += 4;
    }
    write("squares.obj", model);
    write("squares.mtl", materials);
  }

  /// The same squares around a mirror ball of 1/1000 of their distance.
  void writeSquaresAroundBall() const {
    writeSquares();
    const Bytes squares = bytes("squares.obj"), materials = bytes("squares.mtl");
    constexpr int kRings = 48, kSectors = 96;
    std::string model(squares.begin(), squares.end());
    model += "usemtl mirror\n";
    for (int ring = 0; ring <= kRings; ++ring)
      for (int sector = 0; sector < kSectors; ++sector) {
        const float polar = std::numbers::pi_v<float> * float(ring) / kRings;
        const float azimuth = 2.0f * std::numbers::pi_v<float> * float(sector) / kSectors;
        const glm::vec3 n(std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth));
        const auto text = [](glm::vec3 v) {
          return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        };
        model += "v " + text(0.001f * n) + "vn " + text(n);
      }
    for (int ring = 0; ring < kRings; ++ring)
      for (int sector = 0; sector < kSectors; ++sector) {
        model += "f";
        for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1)}) {
          const int index = (ring + corner.x) * kSectors + (sector + corner.y) % kSectors + 1;
          model += " " + std::to_string(24 + index) + "//" + std::to_string(index);
        }
        model += "\n";
      }
    write("around_ball.obj", model);
    write("squares.mtl",
          std::string(materials.begin(), materials.end()) + "newmtl mirror\nKd 1 1 1\nPm 1\nPr 0.000001\n");
  }
};

// Both go through half floats and a cube, the one on the GPU: a shift of half a texel would leave less than 40 dB.
TEST_F(CaptureTest, OfNothingIsWhatConvertMakes) {
  write("map.exr", smoothPanorama());
  for (const std::string form : {"equirect --size 64", "cube --size 32", "cube --size 32 --layout vcross --as-seen",
                                 "equirect --size 64 --for blender", "octahedral --size 64", "eac --size 32"}) {
    succeed("capture none -e map.exr --at 3,2,1 -o captured.exr --to " + form);
    succeed("convert map.exr -o converted.exr --to " + form);
    const Image captured = image("captured.exr");
    const Image converted = image("converted.exr");
    EXPECT_LT(meanDifference(captured, converted), 2e-3) << form;
    EXPECT_LT(maxDifference(captured, converted), 2e-2) << form;
  }
}

TEST_F(CaptureTest, TheSkyKeepsItsSun) {
  succeed("capture none -e sky --at 0,0,0 --to equirect --size 128 --samples 16 -o captured.exr");
  succeed("convert sky --to equirect --size 128 -o converted.exr");
  const auto meanOf = [&](const char* name) {
    const LoadedEnvironment map = environment(name);
    double sum = 0.0;
    const Image& face = map.environment.map()->face(0);
    for (int y = 0; y < face.height(); ++y)
      for (int x = 0; x < face.width(); ++x)
        sum += double(rgbAt(face, x, y).y) *
               double(texelSolidAngle(Projection::equirect, {face.width(), face.height()}, {x, y}));
    return sum;
  };
  EXPECT_NEAR(meanOf("captured.exr") / meanOf("converted.exr"), 1.0, 0.05);
}

TEST_F(CaptureTest, EachSquareOfASceneIsSeenInItsDirection) {
  writeSquares();
  succeed("capture squares.obj --at 0,0,0 --background 0,0,0 --to cube --layout faces --size 33 -o room.exr");
  const std::vector<std::pair<const char*, const char*>> expected{{"px", "+X"}, {"nx", "-X"}, {"py", "+Y"},
                                                                  {"ny", "-Y"}, {"pz", "+Z"}, {"nz", "-Z"}};
  for (const auto& [suffix, name] : expected) {
    const Image face = image(std::string("room_") + suffix + ".exr");
    EXPECT_EQ(uvFaceAt(face, {0.5f, 0.5f}), name);
    EXPECT_EQ(uvFaceAt(face, {0.1f, 0.1f}), "black") << name;
  }
}

// The squares' tips are seen from beside the middle: +Z's, at (0, 0, 1), from (0.5, 0, 0) towards (−0.5, 0, 1), which
// is halfway from the middle of +Z to its edge with −X. Its image has +X on the right.
TEST_F(CaptureTest, FromAnotherPlaceThingsAreSeenElsewhere) {
  writeSquares();
  succeed("capture squares.obj --at 0.5,0,0 --background 0,0,0 --to cube --layout faces --size 64 -o room.exr");
  const Image front = image("room_pz.exr");
  EXPECT_EQ(uvFaceAt(front, {0.25f, 0.5f}), "+Z");
  EXPECT_EQ(uvFaceAt(front, {0.75f, 0.5f}), "black");
  // +X is twice as near: half as far from the middle, its square fills half of the face.
  const Image right = image("room_px.exr");
  EXPECT_EQ(uvFaceAt(right, {0.28f, 0.5f}), "+X");
  EXPECT_EQ(uvFaceAt(right, {0.2f, 0.5f}), "black");
}

// The knot's radius is 1, so that the camera's distance is in units of the world. Both take the mean of 8 samples, the
// one with its rows the other way round, which differs along edges.
TEST_F(CaptureTest, AFaceAsSeenIsThePictureOfACameraThere) {
  struct View {
    const char* camera;
    const char* at;
    const char* face;
  };
  for (const View& view : {View{"0,0,1.2", "0,0,1.2", "nz"}, View{"90,0,1.2", "1.2,0,0", "nx"},
                           View{"180,0,1.2", "0,0,-1.2", "pz"}, View{"270,0,1.2", "-1.2,0,0", "px"},
                           View{"180,90,1.2", "0,1.2,0", "ny"}, View{"180,-90,1.2", "0,-1.2,0", "py"}}) {
    const std::string knot = "knot -e white --set base_color=1,0,0 --samples 8";
    succeed("render " + knot + " --fov 90 --size 64x64 -o picture.exr --camera " + view.camera);
    succeed("capture " + knot + " --to cube --size 64 --layout faces --as-seen -o room.exr --at " + view.at);
    const Image picture = image("picture.exr");
    const Image face = image(std::string("room_") + view.face + ".exr");
    double sum = 0.0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) sum += double(glm::length(rgbAt(picture, x, y) - rgbAt(face, x, y)));
    EXPECT_LT(sum / (64 * 64), 0.02) << view.face;
  }
}

TEST_F(CaptureTest, WithoutAWordATextureIsACubeAndAPictureAPanorama) {
  succeed("capture none -e white --at 0,0,0 -o probe.ktx2");
  EXPECT_EQ(texture("probe.ktx2").faces(), 6);
  EXPECT_EQ(texture("probe.ktx2").at(0, 0).width(), 256);
  succeed("capture none -e white --at 0,0,0 -o probe.exr");
  EXPECT_EQ(image("probe.exr").width(), 1024);
  EXPECT_EQ(image("probe.exr").height(), 512);
  succeed("capture none -e white --at 0,0,0 --size 16 --mips -o mips.ktx2");
  EXPECT_EQ(texture("mips.ktx2").levels(), 5);
}

TEST_F(CaptureTest, IsLinearLightWhateverItsBrightness) {
  succeed(
      "capture sphere --set base_color=1 --set specular=0 -e white --env-intensity 1000 --at 0,0,5 --size 16 -o "
      "probe.exr");
  const Image probe = image("probe.exr");
  for (const float sample : probe.samples()) ASSERT_NEAR(sample, 1000.0f, 1.0f);
}

// The file can go where the environment came from.
TEST_F(CaptureTest, ACaptureServesAsAnEnvironment) {
  succeed("capture showcase --at 0,1,2 --size 32 --to cube -o probe.ktx2");
  succeed("render sphere -e probe.ktx2 --material mirror --size 32x32 -o ball.png");
  EXPECT_EQ(image("ball.png").width(), 32);
}

TEST_F(CaptureTest, WhatIsMissingOrWrongIsTold) {
  const std::string start = "capture none -e white --at 0,0,0 -o out.exr ";
  EXPECT_THAT(refuse(2, "capture none -e white -o out.exr"), HasSubstr("--at X,Y,Z"));
  EXPECT_THAT(refuse(2, "capture none -e white --at 0,0,0"), HasSubstr("-o FILE"));
  for (const std::string at : {"1,2", "1,2,3,4", "nan,0,0", "0,inf,0", "0,0,1e30", "here"})
    EXPECT_THAT(refuse(2, "capture none -e white -o out.exr --at " + at),
                AllOf(HasSubstr("--at"), HasSubstr("3 numbers")));
  EXPECT_THAT(refuse(2, start + "--near -1"), HasSubstr("--near"));
  EXPECT_THAT(refuse(2, start + "--to bowl"), AllOf(HasSubstr("'bowl'"), HasSubstr("equirect, sphere")));
  EXPECT_THAT(refuse(2, start + "--size 40000"), HasSubstr("0 … 32768"));
  EXPECT_THAT(refuse(2, start + "--background transparent"), HasSubstr("--background 0,0,0"));
  EXPECT_THAT(refuse(2, start + "--mapping sphere"), HasSubstr("reflection, normal"));
  EXPECT_THAT(refuse(2, start + "--layout faces"), HasSubstr("for cubes"));
  EXPECT_THAT(refuse(2, start + "--material glas"), HasSubstr("did you mean 'glass'?"));
  EXPECT_THAT(refuse(2, "capture none -e white --at 0,0,0 -o out.tga"), HasSubstr(".hdr or .exr"));
  EXPECT_THAT(refuse(1, "capture none -e white --at 0,0,0 -o none/out.exr"), HasSubstr("there is no folder none"));
  EXPECT_THAT(refuse(1, "capture nothing -e white --at 0,0,0 -o out.exr"), HasSubstr("'nothing'"));
  EXPECT_THAT(refuse(1, start + "--to cube --size 32768"), HasSubstr("--max-memory"));
}

// Whoever takes centimetres for metres gets a map of the environment alone.
TEST_F(CaptureTest, APlaceFarOutsideOfTheSceneIsNoted) {
  const Outcome far = run("capture torus -e white --at 0,500,0 --size 8 -o out.exr");
  EXPECT_EQ(far.exit_code, 0);
  EXPECT_THAT(far.err, AllOf(HasSubstr("mirrorball: note: 0,500,0 is far outside of the scene"),
                             HasSubstr("within 1 units of 0,0,0")));
  succeed("capture torus -e white --at 0,9,0 --size 8 -o out.exr");
  succeed("capture none -e white --at 0,500,0 --size 8 -o out.exr");
}

TEST_F(CaptureTest, HasNoOptionOfAPictureOrItsCamera) {
  const std::string help = succeed("capture --help all");
  for (const char* option : {"--camera", "--fov", "--frames", "--turn ", "--resolve", "--orthographic", "--target"})
    EXPECT_THAT(help, Not(HasSubstr(option)));
  for (const char* option : {"--samples", "--background", "--material", "--set", "--env-rotation", "--layout", "--mips",
                             "--exposure", "--tone-map", "--gain-map", "--primaries"})
    EXPECT_THAT(help, HasSubstr(option));
}

TEST_F(CaptureTest, APictureHoldsItsLightInAGainMapAndIsWhatConvertMakes) {
  const std::string start = "capture none -e white --env-intensity 20 --at 0,0,0 --size 16 ";
  succeed(start + "-o probe.exr");
  succeed(start + "--gain-map --tone-map aces --exposure -1 -o probe.jpg");
  succeed("convert probe.exr --gain-map --tone-map aces --exposure -1 -o converted.jpg");
  EXPECT_TRUE(bytes("probe.jpg") == bytes("converted.jpg"));
  EXPECT_NEAR(image("probe.jpg").texel(3, 3)[1], 10.0f, 0.3f);
  EXPECT_THAT(refuse(2, start + "--gain-map -o a.png"), HasSubstr("write .jpg"));
  EXPECT_THAT(refuse(2, start + "--tone-map aces -o a.exr"), HasSubstr("holds light as it is"));
  succeed(start + "--primaries p3 -o wide.exr");
  EXPECT_NEAR(image("wide.exr").texel(3, 3)[0], 20.0f, 1e-3f);
}

TEST_F(CaptureTest, WhatIsReadIsNotOverwritten) {
  write("map.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "capture none -e map.exr --at 0,0,0 -o map.exr"), HasSubstr("is the input itself"));
  write("room_px.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "capture none -e room_px.exr --from equirect --at 0,0,0 --to cube --layout faces -o room.exr"),
              HasSubstr("is the input itself"));
}

TEST_F(CaptureTest, ASurfaceNearerThanNearIsNotSeen) {
  const std::string beside =
      "capture plane -e white --set base_color=0 --set specular=0 --at 0,0.01,0 --to cube --size 8 ";
  succeed(beside + "-o seen.exr");
  succeed(beside + "--near 0.02 -o cut.exr");
  // The cross has −Y below +Z.
  EXPECT_EQ(uvFaceAt(image("seen.exr"), {0.375f, 5.0f / 6.0f}), "black");
  EXPECT_EQ(rgbAt(image("cut.exr"), 12, 20), glm::vec3(1.0f));
}

TEST_F(CaptureTest, MipLevelsAreShownOnASheet) {
  const std::string line = "capture plane -e white --at 0,1,0 --to cube --size 8 -o out.png ";
  succeed(line + "--mips");
  EXPECT_EQ(image("out.png").width(), 33 + 16);
  succeed(line + "--level 2");
  EXPECT_EQ(image("out.png").width(), 8);
  EXPECT_THAT(refuse(2, line + "--level 4"), HasSubstr("the last is 3"));
}

TEST_F(CaptureTest, CtrlCLeavesNothing) {
  for (const std::string form : {"cube --layout faces", "equirect"}) {
    const std::string line = "capture knot --at 0,0,2 --size 512 --samples 4096 -o out.exr --to " + form;
    Program program({.arguments = Arguments(line).words, .folder = path("")});
    program.waitUntilItCatchesInterrupts();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
    EXPECT_THAT(outcome.err, HasSubstr("mirrorball: interrupted"));  // after what the quality has chosen
    EXPECT_THAT(files(), IsEmpty()) << form;
  }
}

// The lecture's second way to a sphere map: a scene is traced, not drawn.
TEST_F(CaptureTest, TheReferenceCapturesTheSame) {
  writeSquares();
  write("map.exr", smoothPanorama());
  for (const std::string form : {"sphere --size 96", "cube --size 32"}) {
    const std::string line = "capture squares.obj -e map.exr --at 0.2,0.1,-0.1 --samples 64 --to " + form + " -o ";
    succeed(line + "drawn.exr");
    run(line + "traced.exr --reference");
    const Image drawn = image("drawn.exr"), traced = image("traced.exr");
    ASSERT_EQ(drawn.width(), traced.width());
    EXPECT_GT(psnrOnDisplay(drawn, traced, [](int, int) { return true; }), 30.0) << form;
  }
}

TEST_F(CaptureTest, TheReferenceHasTheBackgroundBehindTheScene) {
  for (const std::string form : {"equirect --size 16", "sphere --size 16"}) {
    const std::string line =
        "capture sphere -e white --at 0,0,3 --background 1,0.25,0 --samples 16 --to " + form + " -o ";
    succeed(line + "drawn.exr");
    run(line + "traced.exr --reference");
    const Image drawn = image("drawn.exr"), traced = image("traced.exr");
    EXPECT_LT(meanDifference(drawn, traced), 0.01) << form;
  }
}

// And a third one: a mirror ball that is small beside its scene is rendered, and its picture unwrapped.
TEST_F(CaptureTest, APictureOfASmallMirrorBallIsTheSameMap) {
  writeSquaresAroundBall();
  write("map.exr", smoothPanorama());
  // The model's radius is √(1 + 2/16), and the picture is 1.1 times as high as the ball.
  run("render around_ball.obj -e map.exr --reference --samples 64 --size 192x192 --target 0,0,0 --camera 0,0,0.2 "
      "--orthographic 0.002074185 -o ball.exr");
  run("photo ball.exr --circle 96,96,87.2727 --to equirect --size 64 -o photographed.exr");
  run("capture squares.obj -e map.exr --at 0,0,0 --reference --samples 64 --to equirect --size 64 -o traced.exr");
  const Image photographed = image("photographed.exr"), traced = image("traced.exr");
  const auto isBeforeBall = [&](int x, int y) {
    const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(traced.width(), traced.height());
    return directionAt(Projection::equirect, {0, uv}).z > -0.7f;
  };
  EXPECT_GT(psnrOnDisplay(photographed, traced, isBeforeBall), 25.0);
}

}  // namespace
}  // namespace mirrorball::testing
