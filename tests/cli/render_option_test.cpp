// The options of `render` that change how the environment is looked up and how light becomes a picture.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "formula/color.h"

namespace mirrorball::testing {
namespace {

constexpr int kSize = 65;  // odd, so that a pixel lies in the middle

/// The ball's normal at a pixel of an orthographic picture from +Z that it is inscribed in.
glm::vec3 normalAt(int x, int y) {
  const glm::vec2 p = (glm::vec2(x, y) + 0.5f) * (2.0f / kSize) - 1.0f;
  return {p.x, -p.y, std::sqrt(std::max(1.0f - glm::dot(p, p), 0.0f))};
}

class RenderOptionTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    if (!IsSkipped()) write("smooth.exr", smoothPanorama());
  }

  /// A sphere of a material in smooth light, seen from +Z in parallel projection and inscribed into the picture.
  Image drawBall(const std::string& options) const {
    succeed(withUsual("render sphere --camera 0,0 --size 65x65 " + options,
                      {"-e smooth.exr", "--orthographic 2", "--samples 1", "-o ball.exr"}));
    return image("ball.exr");
  }

  /// Expects the row in the middle of a picture to show, for each normal n there, what `expected(n)` says.
  template <typename Expected>
  static void expectRow(const Image& picture, Expected&& expected, const std::string& what, float tolerance = 0.02f) {
    for (int x = 2; x < kSize - 2; x += 4) {
      const glm::vec3 wanted = expected(normalAt(x, kSize / 2));
      // The panorama's texels are 0.1 rad wide, over which this light curves by about 0.005.
      EXPECT_LT(glm::length(rgbAt(picture, x, kSize / 2) - wanted), tolerance) << what << " at column " << x;
    }
  }
};

TEST_F(RenderOptionTest, MappingSaysWhatLooksTheMapUp) {
  const Environment room = environment("smooth.exr").environment;
  const auto reflected = [&](glm::vec3 n) { return room.radiance(glm::reflect(glm::vec3(0, 0, -1), n)); };
  const auto along_normal = [&](glm::vec3 n) { return room.radiance(n); };
  expectRow(drawBall("--material mirror"), reflected, "default");
  expectRow(drawBall("--material mirror --mapping reflection"), reflected, "reflection");
  expectRow(drawBall("--material mirror --mapping normal"), along_normal, "normal");
  // By texture coordinates ((1 + nx) / 2, (1 + ny) / 2) a ball shows the sphere map itself: its reflection. The map has
  // the panorama's 32 texels across, the outermost of them 0.3 rad wide.
  expectRow(drawBall("--material mirror --mapping sphere"), reflected, "sphere", 0.04f);
}

TEST_F(RenderOptionTest, TheSphereMappingKnowsTheNormalAlone) {
  // A side of a cube has one normal, and shows one texel of the sphere map; its reflection in perspective shows many.
  const std::string shot = "render cube -e smooth.exr --material mirror --camera 0,0,2 --size 33x33 -o side.exr";
  const auto range = [&](const std::string& mapping) {
    succeed(shot + " --mapping " + mapping);
    const Image side = image("side.exr");
    return glm::length(rgbAt(side, 13, 16) - rgbAt(side, 19, 16));
  };
  EXPECT_LT(range("sphere"), 1e-4f);
  EXPECT_LT(range("normal"), 1e-4f);
  EXPECT_GT(range("reflection"), 0.02f);
}

TEST_F(RenderOptionTest, ReflectingAtVerticesDiffersTheMoreTheCoarserTheMesh) {
  const auto difference = [&](const std::string& model) {
    const std::string shot = "render " + model + " -e smooth.exr --material mirror --camera 20,20 --size 64x64 -o ";
    succeed(shot + "fragment.exr --reflect-at fragment");
    succeed(shot + "vertex.exr --reflect-at vertex");
    return meanDifference(image("fragment.exr"), image("vertex.exr"));
  };
  const double coarse = difference("cube");
  const double fine = difference("sphere");
  EXPECT_GT(coarse, 10.0 * fine);
  EXPECT_GT(fine, 0.0);
}

// Two pixels of a triangle of a cube's side show one place of the environment.
TEST_F(RenderOptionTest, ReflectingAtTrianglesShowsOnePlaceEach) {
  succeed("render cube -e smooth.exr --material mirror --camera 0,0,2 --size 33x33 --reflect-at triangle -o tiles.exr");
  const Image side = image("tiles.exr");
  EXPECT_LT(glm::length(rgbAt(side, 20, 9) - rgbAt(side, 23, 12)), 1e-4f);
  EXPECT_LT(glm::length(rgbAt(side, 9, 20) - rgbAt(side, 12, 23)), 1e-4f);
  EXPECT_GT(glm::length(rgbAt(side, 22, 10) - rgbAt(side, 10, 22)), 0.02f) << "the other triangle";
}

// OpenGL's sphere map holds the reflected ray, and is right with perspective too.
TEST_F(RenderOptionTest, CoordinatesGeneratedForASphereMapShowTheReflection) {
  const std::string shot = "render sphere -e smooth.exr --material mirror --camera 20,20 --size 64x64 -o ";
  succeed(shot + "reflected.exr");
  succeed(shot + "generated.exr --texgen sphere");
  succeed(shot + "by_normal.exr --mapping sphere");
  const Image reflected = image("reflected.exr");
  EXPECT_LT(meanDifference(image("generated.exr"), reflected), 2e-3);
  EXPECT_GT(meanDifference(image("by_normal.exr"), reflected), 1e-2);
  succeed(shot + "matrix.exr --texture-matrix 0,0,-1,0,0,1,0,0,1,0,0,0,0,0,0,1 --background transparent");
  succeed(shot + "turned.exr --env-rotation 90 --background transparent");
  EXPECT_LT(meanDifference(image("matrix.exr"), image("turned.exr")), 1e-4);
}

TEST_F(RenderOptionTest, AProjectorNeedsALight) {
  EXPECT_THAT(refuse(2, "render sphere --texgen light -o out.png"), ::testing::HasSubstr("add --light X,Y,Z,R,G,B"));
}

TEST_F(RenderOptionTest, LookUpsInAFlatPictureAreThoseOfTheCube) {
  const std::string shot = "render sphere -e smooth.exr --material mirror --size 64x64 -o ";
  succeed(shot + "cube.exr");
  succeed(shot + "flat.exr --lookup flat");
  succeed(shot + "nearest.exr --lookup flat-nearest");
  const double flat = meanDifference(image("cube.exr"), image("flat.exr"));
  EXPECT_LT(flat, 1e-3);
  EXPECT_GT(meanDifference(image("cube.exr"), image("nearest.exr")), 2.0 * flat);
}

// Black glass in white light shows its reflectance: 0.04 at normal incidence for index 1.5, and so on by each law.
TEST_F(RenderOptionTest, FresnelSaysHowReflectionGrowsTowardsTheRim) {
  const std::string glass =
      "-e white --set base_color=0 --set perceptual_roughness=0 --set ior=1.5 "
      "--set fresnel_offset=0.1 --set fresnel_scale=0.8 --set fresnel_power=2 --set f82_tint=0.5 --fresnel ";
  const auto exact = [](glm::vec3 n) {
    const float sine = std::sqrt(1.0f - n.z * n.z) / 1.5f;
    const float inside = std::sqrt(1.0f - sine * sine);
    const float s = (n.z - 1.5f * inside) / (n.z + 1.5f * inside);
    const float p = (1.5f * n.z - inside) / (1.5f * n.z + inside);
    return glm::vec3((s * s + p * p) / 2.0f);
  };
  expectRow(drawBall(glass + "exact"), exact, "exact");
  expectRow(drawBall(glass + "material"), exact, "the material's own");
  expectRow(
      drawBall(glass + "schlick"), [](glm::vec3 n) { return glm::vec3(0.04f + 0.96f * std::pow(1.0f - n.z, 5.0f)); },
      "Schlick");
  expectRow(
      drawBall(glass + "empirical"), [](glm::vec3 n) { return glm::vec3(0.1f + 0.8f * std::pow(1.0f - n.z, 2.0f)); },
      "empirical");
  const auto f82 = [](glm::vec3 n) {
    const auto schlick = [](float cosine) { return 0.04f + 0.96f * std::pow(1.0f - cosine, 5.0f); };
    const float dip = n.z * std::pow(1.0f - n.z, 6.0f) / (std::pow(6.0f / 7.0f, 6.0f) / 7.0f);
    return glm::vec3(schlick(n.z) - 0.5f * schlick(1.0f / 7.0f) * dip);
  };
  expectRow(drawBall(glass + "f82"), f82, "F82");
}

TEST_F(RenderOptionTest, ALightLightsTheSideThatItStandsOn) {
  const std::string chalk = "--env-intensity 0 --set specular=0 --set base_color=0.5 ";
  EXPECT_EQ(maxDifference(drawBall(chalk + "--background 0"), drawBall(chalk + "--background 0,0,0")), 0.0);
  const Image right = drawBall(chalk + "--light 1000,0,0,2,1,0");
  EXPECT_EQ(rgbAt(right, 10, 32), glm::vec3(0.0f));
  // Lambert: base_color · colour · cos θ, the light being along +X.
  EXPECT_LT(glm::length(rgbAt(right, 55, 32) - 0.5f * glm::vec3(2, 1, 0) * normalAt(55, 32).x), 0.01f);
  const Image both = drawBall(chalk + "--light 1000,0,0,2,1,0 --light -1000,0,0,0,0,4");
  EXPECT_GT(rgbAt(both, 10, 32).z, 1.0f);
  EXPECT_EQ(rgbAt(both, 55, 32), rgbAt(right, 55, 32));
}

TEST_F(RenderOptionTest, EnvIntensityScalesAllOfTheLight) {
  const Image one = drawBall("--set base_color=0.5");
  const Image three = drawBall("--set base_color=0.5 --env-intensity 3");
  for (std::size_t i = 0; i < one.samples().size(); ++i)
    EXPECT_NEAR(three.samples()[i], (i % 4 == 3 ? 1.0f : 3.0f) * one.samples()[i], 1e-3f * three.samples()[i]);
}

// In the middle of a matt bowl under a white sky: E = s + ρ (1 − s) E, of which it shows ρ E.
TEST_F(RenderOptionTest, OcclusionIsWhatABowlSeesOfItself) {
  const auto middle = [&](const std::string& options) {
    succeed(
        "render bowl -e white --camera 0,90 --size 33x33 --samples 1 --set base_color=0.5 --set specular=0 "
        "--set occlusion_strength=0 -o bowl.exr " +
        options);
    return rgbAt(image("bowl.exr"), 16, 16).x;
  };
  EXPECT_NEAR(middle(""), 0.5f, 0.002f);
  const float expected = 0.5f * 0.4f / (1.0f - 0.5f * (1.0f - 0.4f));
  EXPECT_NEAR(middle("--occlusion vertex"), expected, 0.025f);
  EXPECT_NEAR(middle("--self-reflection"), expected, 0.025f);
}

TEST_F(RenderOptionTest, TheBackgroundIsWhatItIsToldToBe) {
  const auto corner = [&](const std::string& background) {
    return rgbaAt(drawBall("--background " + background), 0, 0);
  };
  const Environment room = environment("smooth.exr").environment;
  const glm::vec3 sharp = room.radiance({0, 0, -1});
  EXPECT_LT(glm::length(glm::vec3(corner("env")) - sharp), 0.02f);
  EXPECT_EQ(corner("transparent"), glm::vec4(0.0f));
  EXPECT_EQ(corner("0.25,0.5,4"), glm::vec4(0.25f, 0.5f, 4.0f, 1.0f));
  // sRGB's 0x80 is 0.21586 of linear light (IEC 61966-2-1).
  EXPECT_LT(glm::length(corner("#ff8000") - glm::vec4(1.0f, 0.21586f, 0.0f, 1.0f)), 1e-4f);
  EXPECT_EQ(corner("blur").w, 1.0f);
}

TEST_F(RenderOptionTest, ABlurredBackgroundIsSmootherThanASharpOne) {
  succeed("convert uv --to cube --size 64 -o uv.exr");
  const auto contrast = [&](const std::string& background) {
    succeed("render none -e uv.exr --camera 180,0 --fov 90 --size 64x64 -o back.exr --background " + background);
    const Image back = image("back.exr");
    double squares = 0.0;
    for (int y = 0; y < 64; ++y)
      for (int x = 1; x < 64; ++x) {
        const glm::vec3 step = rgbAt(back, x, y) - rgbAt(back, x - 1, y);
        squares += double(glm::dot(step, step));
      }
    return squares;
  };
  EXPECT_LT(contrast("blur"), contrast("env") / 4.0);
}

TEST_F(RenderOptionTest, ToneMapAndExposureAreTheFormulasOfTheRadiance) {
  const Image radiance = drawBall("--material gold");
  const char* const curves[] = {"agx", "aces", "neutral", "reinhard", "linear"};
  for (int curve = 0; curve < 5; ++curve) {
    succeed(
        "render sphere -e smooth.exr --camera 0,0 --orthographic 2 --size 65x65 --samples 1 --material gold "
        "--exposure 0.5 -o ball.png --tone-map " +
        std::string(curves[curve]));
    const Image picture = image("ball.png");
    for (int y = 0; y < kSize; y += 3)
      for (int x = 0; x < kSize; x += 3) {
        const glm::vec4 shown = formula::displayed(rgbaAt(radiance, x, y), std::exp2(0.5f), curve);
        const glm::vec3 encoded = formula::srgbFromLinear(rgbAt(picture, x, y));
        // A step of 8 bits: the GPU rounds what it computes.
        EXPECT_LT(glm::length(encoded - glm::vec3(shown)), 1.8f / 255.0f) << curves[curve];
      }
  }
}

TEST_F(RenderOptionTest, MoreSamplesGiveEdgesMoreSteps) {
  const auto levels = [&](const std::string& samples) {
    succeed("render sphere -e white --size 64x64 --background transparent -o edge.exr --samples " + samples);
    std::set<float> alphas;
    const Image edge = image("edge.exr");
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) alphas.insert(rgbaAt(edge, x, y).w);
    return alphas.size();
  };
  EXPECT_EQ(levels("1"), 2u);
  EXPECT_EQ(levels("4"), 5u);
  EXPECT_GT(levels("16"), 10u);
}

// However many samples there are, their middle is the pixel's: the disc's centre of mass is the picture's middle. A
// fiftieth of a pixel is what the steps of a disc's edge leave.
TEST_F(RenderOptionTest, SamplesDoNotMoveThePicture) {
  for (const std::string samples : {"1", "2", "3", "4", "8", "16"}) {
    const Image ball = drawBall("--background transparent --orthographic 2.5 --samples " + samples);
    glm::dvec2 sum(0.0);
    double coverage = 0.0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double alpha = rgbaAt(ball, x, y).w;
        sum += alpha * (glm::dvec2(x, y) + 0.5);
        coverage += alpha;
      }
    EXPECT_NEAR(sum.x / coverage, kSize / 2.0, 0.02) << samples << " samples";
    EXPECT_NEAR(sum.y / coverage, kSize / 2.0, 0.02) << samples << " samples";
  }
}

TEST_F(RenderOptionTest, ReliefOfASurfaceWithoutHeightsIsTold) {
  const std::string line = "render plane -e white --size 8x8 --samples 1 -o plane.png --relief ";
  EXPECT_THAT(run(line + "exact").err, ::testing::HasSubstr("no surface has heights"));
  EXPECT_THAT(run(line + "bump").err, ::testing::Not(::testing::HasSubstr("heights")));
  EXPECT_THAT(run(line + "parallax --set height=waves").err, ::testing::Not(::testing::HasSubstr("heights")));
}

TEST_F(RenderOptionTest, NegativeLightIsTold) {
  Image map(64, 32, 3, 1.0f);
  map.texel(3, 3)[1] = -100.0f;
  write("negative.exr", map);
  EXPECT_EQ(run("render none -e negative.exr --size 8x8 --no-cache -o out.png").err,
            "mirrorball: note: negative.exr: 1 value is negative, no light or a colour beyond Rec.709; taken as 0\n");
}

}  // namespace
}  // namespace mirrorball::testing
