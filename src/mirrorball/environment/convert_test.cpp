#include "mirrorball/environment/convert.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "mirrorball/environment/builtin.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/load.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::psnr;
using testing::smoothRadiance;

constexpr std::array kAll{Projection::equirect, Projection::sphere, Projection::angular, Projection::cube};

bool everywhere(glm::vec3) { return true; }
/// Beyond normals of r² = 0.9 a sphere map squeezes a tenth of the sphere, 4π/10 = 1.26 sr around −Z, into its rim.
bool beforeTheRim(glm::vec3 d) { return 1.0f - (d.z + 1.0f) / 2.0f < 0.9f; }

TEST(Convert, WhiteStaysExactlyWhite) {
  const Environment white = *builtinEnvironment("white");
  for (const Projection first : kAll)
    for (const Projection second : kAll) {
      const Environment between(*convert(white, first, 32));
      const EnvironmentMap map = *convert(between, second, 32);
      for (int face = 0; face < map.faces(); ++face)
        for (int y = 0; y < map.size(); ++y)
          for (int x = 0; x < map.face(face).width(); ++x) {
            const glm::vec4 texel = rgbaAt(map.face(face), x, y);
            const bool beside = texelSolidAngle(second, {map.face(face).width(), map.size()}, {x, y}) == 0.0f;
            EXPECT_NEAR(texel.x, beside ? 0.0f : 1.0f, 1e-6f) << nameOf(first) << " to " << nameOf(second);
            EXPECT_EQ(texel.w, beside ? 0.0f : 1.0f);
          }
    }
}

TEST(Convert, EveryProjectionShowsTheFunctionItself) {
  const Environment analytic(smoothRadiance, 256);
  for (const Projection projection : kAll) {
    const Environment map(*convert(analytic, projection, 256));
    const bool has_rim = projection == Projection::sphere;
    // What bilinear interpolation between 256 texels leaves of a function with curvature of about 1.
    EXPECT_GT(has_rim ? psnr(map, analytic, beforeTheRim) : psnr(map, analytic, everywhere), 70.0)
        << nameOf(projection);
  }
}

TEST(Convert, RoundTripsReturnTheOriginal) {
  const Environment original(*convert(Environment(smoothRadiance, 256), Projection::equirect, 256));
  const Environment cube(*convert(original, Projection::cube, 128));
  EXPECT_GT(psnr(Environment(*convert(cube, Projection::equirect, 256)), original, everywhere), 60.0);
  const Environment ball(*convert(original, Projection::sphere, 512));
  EXPECT_GT(psnr(Environment(*convert(ball, Projection::equirect, 256)), original, beforeTheRim), 60.0);
  const Environment probe(*convert(original, Projection::angular, 512));
  EXPECT_GT(psnr(Environment(*convert(probe, Projection::equirect, 256)), original, everywhere), 60.0);
}

// A real panorama has edges as sharp as its texels, which two resamplings soften: the floors are a decibel or two below
// what was measured, and far above what half a texel of shift would leave (about 24 dB).
TEST(Convert, RoundTripsOfARealPanorama) {
  const auto path = testing::sharedData("chinese_garden_1k.hdr");
  if (!path) GTEST_SKIP() << "chinese_garden_1k.hdr is not there";
  const LoadedEnvironment loaded = *loadEnvironment(path->string());
  const auto display = [](const Environment& environment) {
    return Environment([&environment](glm::vec3 d) { return glm::clamp(environment.radiance(d), 0.0f, 1.0f); }, 512);
  };
  const Environment& original = loaded.environment;
  const auto roundTrip = [&](Projection projection, int size) {
    const Environment there(*convert(original, projection, size));
    return Environment(*convert(there, Projection::equirect, 512));
  };
  const Environment through_cube = roundTrip(Projection::cube, 512);
  const double cube = psnr(display(through_cube), display(original), everywhere);
  EXPECT_GT(cube, 33.0);
  RecordProperty("psnr_cube_db", std::to_string(cube));
  const Environment through_ball = roundTrip(Projection::sphere, 1024);
  const double ball = psnr(display(through_ball), display(original), beforeTheRim);
  EXPECT_GT(ball, 30.0);
  RecordProperty("psnr_sphere_db", std::to_string(ball));
}

TEST(Convert, IsTheSameForAnyNumberOfThreads) {
  const Environment sky = *builtinEnvironment("sky");
  const EnvironmentMap many = *convert(sky, Projection::equirect, 64);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const EnvironmentMap single = *convert(sky, Projection::equirect, 64);
  EXPECT_TRUE(
      std::equal(many.face(0).samples().begin(), many.face(0).samples().end(), single.face(0).samples().begin()));
}

TEST(Convert, MinificationAveragesWhatATexelCovers) {
  // A checkerboard of single texels becomes grey when each target texel covers many of them; one tap would be 0 or 1.
  Image board(512, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) std::fill_n(board.texel(x, y), 3, static_cast<float>((x + y) % 2));
  const Environment source{EnvironmentMap(Projection::equirect, ImageSet(std::move(board)))};
  const EnvironmentMap small = *convert(source, Projection::equirect, 32);
  for (const float sample : small.face(0).samples()) EXPECT_NEAR(sample, 0.5f, 0.02f);
}

TEST(Convert, StopsWhenAskedTo) {
  const auto stopped = convert(*builtinEnvironment("uv"), Projection::cube, 64, {}, [](auto, auto) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
