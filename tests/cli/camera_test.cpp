// The camera's options: where it stands, how it looks, and how the environment is turned about it.

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

/// A cube that shows, by --mapping normal, in each side the face of `uv` that this side looks at.
class CameraCliTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    if (!IsSkipped()) succeed("convert uv --to cube --size 64 -o uv.exr");
  }

  /// Draws a picture of 64 × 64 pixels.
  Image draw(const std::string& options) const {
    succeed("render " + options + " -e uv.exr --size 64x64 -o picture.exr");
    return image("picture.exr");
  }
};

constexpr const char* kMarkedCube = "cube --material mirror --mapping normal --orthographic 1 ";

TEST_F(CameraCliTest, AzimuthAndElevationSayWhereItStands) {
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 0,0"), {0.5f, 0.5f}), "+Z");
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 90,0"), {0.5f, 0.5f}), "+X");
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 180,0"), {0.5f, 0.5f}), "-Z");
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera -90,0"), {0.5f, 0.5f}), "-X");
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 0,90"), {0.5f, 0.5f}), "+Y");
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 123,-90"), {0.5f, 0.5f}), "-Y");
}

TEST_F(CameraCliTest, EnvRotationTurnsPlusZTowardsPlusX) {
  EXPECT_EQ(uvFaceAt(draw("none --camera 270,0 --env-rotation 90"), {0.5f, 0.5f}), "+Z") << "looking along +X";
  EXPECT_EQ(uvFaceAt(draw("none --camera 90,0 --env-rotation 90"), {0.5f, 0.5f}), "-Z") << "looking along -X";
  EXPECT_EQ(uvFaceAt(draw("none --camera 0,-90 --env-rotation 90"), {0.5f, 0.5f}), "+Y") << "looking along +Y";
  EXPECT_EQ(uvFaceAt(draw(std::string(kMarkedCube) + "--camera 90,0 --env-rotation 90"), {0.5f, 0.5f}), "+Z")
      << "the model's +X side is turned with the background";
}

TEST_F(CameraCliTest, AParallelProjectionSeesOneDirectionBehindEverything) {
  const Image picture = draw("none --camera 180,0 --orthographic 3");
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_EQ(rgbAt(picture, 0, 0)[channel], rgbAt(picture, 63, 63)[channel]);
  EXPECT_EQ(uvFaceAt(picture, {0.0f, 0.0f}), "+Z");
}

TEST_F(CameraCliTest, AnOrthographicHeightOf2InscribesASphere) {
  const Image picture = draw("sphere --camera 40,20 --orthographic 2 --background transparent --samples 16");
  for (const glm::ivec2 edge : {glm::ivec2(32, 0), glm::ivec2(0, 32), glm::ivec2(63, 32), glm::ivec2(32, 63)})
    EXPECT_GT(rgbaAt(picture, edge.x, edge.y).w, 0.8f) << "the sphere touches the picture's edge";
  // The corner of the inscribed square: 45° along the circle, 9.4 pixels from the corner.
  EXPECT_EQ(rgbaAt(picture, 8, 8).w, 0.0f);
  EXPECT_EQ(rgbaAt(picture, 11, 11).w, 1.0f);
}

TEST_F(CameraCliTest, TheDefaultDistanceFramesTheModel) {
  for (const char* size : {"64x64", "96x48", "48x96"}) {
    succeed("render sphere -e uv.exr --background transparent -o framed.exr --size " + std::string(size));
    const Image picture = image("framed.exr");
    int covered = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const bool on_edge = x == 0 || y == 0 || x == picture.width() - 1 || y == picture.height() - 1;
        const float alpha = rgbaAt(picture, x, y).w;
        covered += alpha > 0.5f;
        EXPECT_TRUE(alpha == 0.0f || !on_edge) << size << " at " << x << ", " << y;
      }
    const int narrower = std::min(picture.width(), picture.height());
    // A disc that fills the narrower side covers π/4 of its square.
    EXPECT_GT(covered, 0.78f * 0.8f * static_cast<float>(narrower * narrower)) << size;
  }
}

/// The largest alpha at a picture's border.
float alphaAtBorder(const Image& picture) {
  float alpha = 0.0f;
  for (int x = 0; x < picture.width(); ++x)
    for (const int y : {0, picture.height() - 1}) alpha = std::max(alpha, rgbaAt(picture, x, y).w);
  for (int y = 0; y < picture.height(); ++y)
    for (const int x : {0, picture.width() - 1}) alpha = std::max(alpha, rgbaAt(picture, x, y).w);
  return alpha;
}

// The sun goes once round the model, 15° above the horizon; at noon the camera is as near as without it.
TEST_F(CameraCliTest, TheFramingOfAModelThatStandsHoldsItsShadow) {
  const auto drawn = [&](const std::string& sky) {
    succeed("render teapot -e " + sky + " --stand --background transparent --samples 4 -o stands.exr --size 128x72");
    const Image picture = image("stands.exr");
    struct {
      float at_edge = 0.0f;
      int shaded = 0;
      int solid = 0;
    } found;
    found.at_edge = alphaAtBorder(picture);
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const float alpha = rgbaAt(picture, x, y).w;
        found.shaded += alpha > 0.3f && alpha < 0.99f;
        found.solid += alpha > 0.99f;
      }
    return found;
  };
  const auto noon = drawn("sky:elevation=80");
  for (const char* turn : {"0", "70", "140", "210", "280"}) {
    const auto low = drawn(std::string("sky:elevation=15 --env-rotation ") + turn);
    EXPECT_LT(low.at_edge, 0.15f) << turn;
    EXPECT_GT(low.shaded, 100) << turn;
    EXPECT_GT(low.solid, noon.solid / 8) << turn;
  }
  EXPECT_NEAR(noon.solid, drawn("white").solid, noon.solid / 50);
}

// A flat box throws the longest shadow when the light shines along its diagonal, not in the first picture.
TEST_F(CameraCliTest, ATurntablesFramingHoldsTheShadowOfAFlatBox) {
  write("box.obj", std::string("v -2 -.5 -.05\nv -2 -.5 .05\nv -2 .5 -.05\nv -2 .5 .05\nv 2 -.5 -.05\nv 2 -.5 .05\n"
                               "v 2 .5 -.05\nv 2 .5 .05\nf 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\n"
                               "f 2 6 8 4\n"));
  for (const char* turn : {"environment --camera 0,10", "model --camera 90,30", "camera --camera 90,30"}) {
    succeed(std::string("render box.obj -e sky:elevation=20,azimuth=0 --stand --background transparent --samples 4 "
                        "--size 96x72 --frames 8 -o box_%d.exr --turn ") +
            turn);
    for (int i = 0; i < 8; ++i)
      EXPECT_LT(alphaAtBorder(image("box_" + std::to_string(i) + ".exr")), 0.1f) << turn << " " << i;
  }
}

// A plane that lies in x and y stands upright when z is up.
TEST_F(CameraCliTest, UpSaysWhichAxisOfTheModelPointsUpwards) {
  const auto covered = [&](const std::string& up) {
    const Image picture = draw("plane --background transparent --camera 0,0,3 --samples 16 " + up);
    double sum = 0.0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) sum += double(rgbaAt(picture, x, y).w) / (64.0 * 64.0);
    return sum;
  };
  EXPECT_LT(covered(""), 0.05) << "from its edge";
  EXPECT_LT(covered("--up y"), 0.05);
  EXPECT_GT(covered("--up z"), 0.2);
  EXPECT_THAT(refuse(2, "render plane --up x -o a.png"), ::testing::HasSubstr("y"));
}

// A ball around it would leave a third of the picture's width empty.
TEST_F(CameraCliTest, ATeapotFillsThePicture) {
  for (const char* how : {"", " --orthographic", " --camera 120,-40", " --up z"}) {
    const Image picture = draw(std::string("teapot --background transparent") + how);
    glm::ivec2 min(64);
    glm::ivec2 max(-1);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        if (rgbaAt(picture, x, y).w > 0.0f) {
          min = glm::min(min, glm::ivec2(x, y));
          max = glm::max(max, glm::ivec2(x, y));
        }
    const glm::ivec2 extent = max - min + 1;
    // 15/16 of 64 pixels, and at each end a part of one.
    EXPECT_NEAR(std::max(extent.x, extent.y), 61, 1) << how;
    EXPECT_NEAR(min.x + max.x, 63, 1) << how;
    EXPECT_NEAR(min.y + max.y, 63, 1) << how;
  }
}

TEST_F(CameraCliTest, DistanceFieldOfViewAndTargetMoveTheModelInThePicture) {
  const auto coverage = [&](const std::string& options) {
    const Image picture = draw("sphere --background transparent --camera " + options);
    double sum = 0.0;
    double sum_x = 0.0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        sum += double(rgbaAt(picture, x, y).w);
        sum_x += double(rgbaAt(picture, x, y).w) * (x + 0.5) / 64.0;
      }
    return glm::dvec2(sum / (64.0 * 64.0), sum_x / sum);
  };
  // A ball of radius 1 at distance d shows a disc of radius tan(asin(1/d)), in a half height of tan(fov/2).
  const double pi = 3.14159265358979;
  const auto expected = [&](double distance, double fov_deg) {
    const double radius = std::tan(std::asin(1.0 / distance)) / std::tan(fov_deg * pi / 360.0);
    return pi * radius * radius / 4.0;
  };
  EXPECT_NEAR(coverage("0,0,4").x, expected(4.0, 35.0), 0.01);
  EXPECT_NEAR(coverage("0,0,8").x, expected(8.0, 35.0), 0.01);
  EXPECT_NEAR(coverage("0,0,4 --fov 60").x, expected(4.0, 60.0), 0.01);
  EXPECT_NEAR(coverage("0,0,8").y, 0.5, 0.01);
  EXPECT_LT(coverage("0,0,8 --target 0.5,0,0").y, 0.45) << "a camera on +Z that aims right of the model has it left";
}

}  // namespace
}  // namespace mirrorball::testing
