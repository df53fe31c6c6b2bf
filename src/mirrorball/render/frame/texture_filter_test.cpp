// How textures and the mirrored environment are read between texels, and what mip levels are good for.

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/material/set_parameter.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

constexpr std::array kEveryFilter{TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear,
                                  TextureFilter::anisotropic};

/// White and without reflection: in white light it shows its base colour.
Scene stripedPlane() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.specular = 0.0f;
  Scene scene = meshScene(planeMesh(), material);
  EXPECT_TRUE(setParameter(scene, "base_color_map=stripes"));
  return scene;
}

Scene mirrorBall(float perceptual_roughness = 0.0f) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  return meshScene(sphereMesh(), material);
}

/// Meridians, black and white.
Environment meridians() {
  return Environment([](glm::vec3 d) { return glm::vec3(std::sin(60.0f * std::atan2(d.x, d.z)) > 0.0f ? 1.0f : 0.0f); },
                     256);
}

class FilteredFrameTest : public gl::GlTest {
 protected:
  static Image drawn(Scene scene, const Environment& environment, FrameSettings settings, TextureFilter filter) {
    settings.texture_filter = filter;
    auto renderer = testing::rendererOf(std::move(scene), environment, *testing::prepareOnce(environment));
    EXPECT_TRUE(renderer);
    auto image = renderer->renderRadiance(settings);
    EXPECT_TRUE(image);
    return std::move(*image);
  }

  static FrameSettings seenFrom(float azimuth, float elevation, int samples) {
    FrameSettings settings{.size = {96, 64}, .background = BackgroundKind::transparent, .samples = samples};
    testing::aim(settings, azimuth, elevation);
    return settings;
  }

  /// Over all channels.
  static double rootMeanSquare(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.samples().size(); ++i) sum += std::pow(double(a.samples()[i] - b.samples()[i]), 2.0);
    return std::sqrt(sum / static_cast<double>(a.samples().size()));
  }
};
MIRRORBALL_WITH_BOTH_APIS(FilteredFrameTest);

// At one sample a pixel each filter is nearer to the mean over the pixel than the one before.
TEST_P(FilteredFrameTest, EachFilterIsNearerToTheTruthOnAPlaneAtGrazing) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 8);
  const Image truth = drawn(stripedPlane(), white, seenFrom(20, 8, 256), TextureFilter::bilinear);
  std::array<double, 4> errors{};
  for (std::size_t i = 0; i < 4; ++i)
    errors[i] = rootMeanSquare(drawn(stripedPlane(), white, seenFrom(20, 8, 1), kEveryFilter[i]), truth);
  EXPECT_LE(errors[1], errors[0]);
  EXPECT_LT(errors[2], 0.75 * errors[1]);
  EXPECT_LT(errors[3], 0.75 * errors[2]);
}

// Sixteen samples that each saw the whole pixel would blur it as much as one does.
TEST_P(FilteredFrameTest, ASampleSeesItsPartOfThePixel) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 8);
  const Image truth = drawn(stripedPlane(), white, seenFrom(20, 30, 256), TextureFilter::bilinear);
  const auto errorOf = [&](int samples) {
    return rootMeanSquare(drawn(stripedPlane(), white, seenFrom(20, 30, samples), TextureFilter::trilinear), truth);
  };
  EXPECT_LT(errorOf(16), 0.5 * errorOf(1));
}

TEST_P(FilteredFrameTest, MipLevelsAreNearerToTheTruthInAMirror) {
  const Environment lines = meridians();
  const Image truth = drawn(mirrorBall(), lines, seenFrom(0, 0, 256), TextureFilter::bilinear);
  std::array<double, 4> errors{};
  for (std::size_t i = 0; i < 4; ++i)
    errors[i] = rootMeanSquare(drawn(mirrorBall(), lines, seenFrom(0, 0, 1), kEveryFilter[i]), truth);
  EXPECT_LT(errors[2], 0.75 * errors[1]);
  EXPECT_LE(errors[3], errors[2]);
}

// A cube sampler and the flat picture of it find the same texel, but for those on its edges.
TEST_P(FilteredFrameTest, NearestShowsSingleTexelsOfTheEnvironment) {
  const Environment lines = meridians();
  FrameSettings near = seenFrom(0, 0, 1);
  near.camera.fov_deg = 10.0f;
  near.camera.distance = 3.0f;
  const auto ends = [&](LightLookUp look_up, TextureFilter filter) {
    near.look_up = look_up;
    const Image image = drawn(mirrorBall(), lines, near, filter);
    int between = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (const float light = rgbAt(image, x, y).x; light > 0.02f && light < 0.98f) ++between;
    return between;
  };
  for (const LightLookUp look_up : {LightLookUp::cube, LightLookUp::flat}) {
    const int smooth = ends(look_up, TextureFilter::bilinear);
    EXPECT_LT(ends(look_up, TextureFilter::nearest), smooth) << static_cast<int>(look_up);
  }
}

// Within its outline, beside many samples that read no mip levels. Levels of the prefiltered chain, taken for those of
// a map, once blurred it as if it were matt, to 26 dB with 40 pixels.
TEST_P(FilteredFrameTest, ASmallPolishedBallIsNotSmeared) {
  const Environment studio = testing::coarseBuiltin("studio");
  for (const auto& [side, least] : {std::pair(40, 44.0), std::pair(80, 50.0)}) {
    FrameSettings settings = seenFrom(30, 15, 64);
    settings.size = {side, side};
    settings.camera.orthographic_height = 2.0f;
    const Image truth = drawn(mirrorBall(0.1f), studio, settings, TextureFilter::bilinear);
    settings.samples = 4;
    const Image image = drawn(mirrorBall(0.1f), studio, settings, TextureFilter::trilinear);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const glm::vec2 p = (glm::vec2(x, y) + 0.5f) * 2.0f / float(side) - 1.0f;
        if (glm::length(p) > 1.0f - 4.0f / float(side)) continue;
        const auto shown = [&](const Image& of) { return rgbAt(of, x, y).y / (1.0f + rgbAt(of, x, y).y); };
        sum += std::pow(double(shown(image) - shown(truth)), 2.0);
        ++count;
      }
    EXPECT_GT(-10.0 * std::log10(sum / count), least) << side << " pixels";
  }
}

// In light that is alike on the left and on the right, with one sample in the middle of each pixel, a ball is alike on
// both sides: no lobe of its row looks at one side of a pixel alone. So it does not hop where samples are added.
TEST_P(FilteredFrameTest, OneSampleOfAPolishedBallLooksAtBothSidesOfAPixel) {
  const Environment alike(
      [](glm::vec3 d) { return glm::vec3(std::cos(12.0f * std::atan2(d.x, d.z)) > 0.0f ? 1.0f : 0.0f); }, 256);
  constexpr int kSide = 40;
  FrameSettings settings = seenFrom(0, 0, 1);
  settings.size = {kSide, kSide};
  settings.camera.orthographic_height = 2.0f;
  const Image image = drawn(mirrorBall(0.1f), alike, settings, TextureFilter::trilinear);
  double difference = 0.0;
  double contrast = 0.0;
  for (int y = 4; y < kSide - 4; ++y)
    for (int x = 4; x < kSide / 2; ++x) {
      const float left = rgbAt(image, x, y).y;
      difference += std::pow(double(left - rgbAt(image, kSide - 1 - x, y).y), 2.0);
      contrast += std::pow(double(left - rgbAt(image, x + 1, y).y), 2.0);
    }
  EXPECT_LT(difference, 1e-3 * contrast);
}

TEST_P(FilteredFrameTest, TheBlurOfRoughSurfacesStays) {
  const Environment lines = meridians();
  const Image usual = drawn(mirrorBall(0.7f), lines, seenFrom(0, 0, 4), TextureFilter::trilinear);
  for (const TextureFilter filter : kEveryFilter)
    EXPECT_LT(rootMeanSquare(drawn(mirrorBall(0.7f), lines, seenFrom(0, 0, 4), filter), usual), 1e-3)
        << static_cast<int>(filter);
}

TEST_P(FilteredFrameTest, EveryFilterIsWhiteInTheFurnace) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 8);
  for (const TextureFilter filter : kEveryFilter)
    for (const LightLookUp look_up : {LightLookUp::cube, LightLookUp::flat}) {
      FrameSettings settings = seenFrom(20, 30, 2);
      settings.look_up = look_up;
      testing::expectFurnaceWhite(drawn(mirrorBall(0.3f), white, settings, filter), "filter");
      testing::expectFurnaceWhite(drawn(mirrorBall(), white, settings, filter), "filter, mirror");
    }
}

// What is drawn with one filter leaves no trace in what is drawn next.
TEST_P(FilteredFrameTest, ARendererTakesAnyFilterAfterAnyOther) {
  const Environment lines = meridians();
  auto renderer = testing::rendererOf(stripedPlane(), lines, *testing::prepareOnce(lines));
  ASSERT_TRUE(renderer);
  FrameSettings settings = seenFrom(20, 30, 1);
  const auto first = renderer->renderRadiance(settings);
  ASSERT_TRUE(first);
  for (const TextureFilter filter : kEveryFilter) {
    settings.texture_filter = filter;
    const auto other = renderer->renderRadiance(settings);
    ASSERT_TRUE(other);
    EXPECT_EQ(rootMeanSquare(*other, *first) == 0.0, filter == TextureFilter::trilinear) << static_cast<int>(filter);
    settings.texture_filter = TextureFilter::trilinear;
    const auto again = renderer->renderRadiance(settings);
    ASSERT_TRUE(again);
    EXPECT_EQ(rootMeanSquare(*again, *first), 0.0);
  }
}

}  // namespace
}  // namespace mirrorball
