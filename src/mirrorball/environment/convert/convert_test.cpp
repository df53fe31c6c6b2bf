#include "mirrorball/environment/convert/convert.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::fluxOf;
using testing::kEveryProjection;
using testing::psnr;
using testing::smoothRadiance;
using testing::waves;

bool everywhere(glm::vec3) { return true; }
/// Beyond normals of r² = 0.9 a sphere map squeezes a tenth of the sphere, 4π/10 = 1.26 sr around −Z, into its rim.
bool beforeTheRim(glm::vec3 d) { return 1.0f - (d.z + 1.0f) / 2.0f < 0.9f; }

TEST(Convert, WhiteStaysExactlyWhite) {
  const Environment white = *builtinEnvironment("white");
  for (const Projection first : kEveryProjection) {
    if (first == Projection::hemioctahedral) continue;  // the other half is black
    for (const Projection second : kEveryProjection) {
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
}

TEST(Convert, EveryProjectionShowsTheFunctionItself) {
  const Environment analytic(smoothRadiance, 256);
  for (const Projection projection : kEveryProjection) {
    const Environment map(*convert(analytic, projection, 256));
    const bool has_rim = projection == Projection::sphere || projection == Projection::ball;
    const bool is_near = projection == Projection::ballFrom(1.5f);  // hides z < −0.75
    const auto seen = [&](glm::vec3 d) {
      return covers(projection, d) && (!has_rim || beforeTheRim(d)) && (!is_near || d.z > -0.5f);
    };
    // What bilinear interpolation between 256 texels leaves of a function with curvature of about 1.
    EXPECT_GT(psnr(map, analytic, seen), 70.0) << textOf(projection);
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
  const testing::OneThread one;
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

/// Root of the mean squared difference from `light` at the texel centres.
double rmsError(const EnvironmentMap& map, glm::vec3 (*light)(glm::vec3)) {
  double sum = 0.0;
  for (int face = 0; face < map.faces(); ++face)
    for (int y = 0; y < map.size(); ++y)
      for (int x = 0; x < map.face(face).width(); ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(map.face(face).width(), map.size());
        const double difference = rgbAt(map.face(face), x, y).x - light(directionAt(map.projection(), {face, uv})).x;
        sum += difference * difference;
      }
  return std::sqrt(sum / (double(map.faces()) * double(map.face(0).texelCount())));
}

// The waves are 17 texels of the panorama long, for which bilinear interpolation leaves 2e-3 and a cubic spline without
// an error of its own 2e-5.
TEST(Convert, IsExactOnABandLimitedPanorama) {
  const Environment panorama(*convert(Environment(waves, 512), Projection::equirect, 512));
  EXPECT_LT(rmsError(*convert(panorama, Projection::cube, 256), waves), 1.5e-4);
  EXPECT_GT(rmsError(*convert(panorama, Projection::cube, 256, {.interpolation = Interpolation::bilinear}), waves),
            1e-3);
}

/// A panorama, black but for a sun of half a degree and 10⁵.
EnvironmentMap sunlit(glm::vec3 towards, int height) {
  const glm::ivec2 extent(2 * height, height);
  Image image(extent.x, extent.y, 3);
  const glm::ivec2 middle(positionOf(Projection::equirect, towards).uv * glm::vec2(extent));
  for (int y = middle.y - 16; y < middle.y + 16; ++y)
    for (int x = middle.x - 16; x < middle.x + 16; ++x) {
      const glm::vec3 d = directionAt(Projection::equirect, {0, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent)});
      if (glm::length(d - towards) < 0.00436f) std::fill_n(image.texel(x, y), 3, 1e5f);
    }
  return EnvironmentMap(Projection::equirect, ImageSet(std::move(image)));
}

// One bilinear tap is off by 105 %, root mean square.
TEST(Convert, ASmallSunKeepsItsFlux) {
  double sum = 0.0;
  constexpr int kShifts = 8;
  for (int i = 0; i < kShifts; ++i) {
    // Shifts of up to a texel of the cube, 2 / 128 rad, near the middle of a face and towards its corner.
    const float shift = static_cast<float>(i) / kShifts * (2.0f / 128.0f);
    const glm::vec3 towards =
        glm::normalize(glm::vec3(0.1f * static_cast<float>(i) + shift, 0.3f + 0.7f * shift, 1.0f));
    const EnvironmentMap source = sunlit(towards, 2048);
    const double ratio = fluxOf(*convert(Environment(source), Projection::cube, 128)) / fluxOf(source);
    sum += (ratio - 1.0) * (ratio - 1.0);
  }
  EXPECT_LT(std::sqrt(sum / kShifts), 0.01);
}

// A single look-up at each texel's centre is off by up to 17 %; sharp_light_test has all projections and ratios.
TEST(Convert, ASmallSunKeepsItsFluxNearOneToOne) {
  const EnvironmentMap source = sunlit(glm::normalize(glm::vec3(0.31f, 0.42f, 0.85f)), 512);
  const glm::mat3 turned = turnedBy(0.4f, 0.3f, 0.2f);
  for (const int size : {190, 256, 300})
    EXPECT_NEAR(fluxOf(*convert(Environment(source), Projection::cube, size)) / fluxOf(source), 1.0, 0.01) << size;
  for (const int size : {400, 512, 600})
    EXPECT_NEAR(fluxOf(*convert(Environment(source), Projection::equirect, size, {.source_from_target = turned})) /
                    fluxOf(source),
                1.0, 0.01)
        << size;
}

// Where a face ends, the last tile of 32 × 16 texels is so narrow that the sun is much of it: 2 % if that counts.
TEST(Convert, ASunAtTheEndOfAFaceKeepsItsFlux) {
  for (const auto& [face, texel] : {std::pair(35, 32.3f), std::pair(36, 34.8f), std::pair(40, 37.6f)}) {
    const float place = (texel - 32.0f) / static_cast<float>(face - 32);
    const glm::vec3 towards =
        directionAt(Projection::cube, {4, {texel / static_cast<float>(face), 0.4f + 0.1f * place}});
    const auto light = [&](glm::vec3 d) { return glm::vec3(glm::dot(d, towards) > std::cos(0.08f) ? 1e5f : 1.0f); };
    const EnvironmentMap source = *convert(Environment(light, 1), Projection::equirect, 2 * face);
    EXPECT_NEAR(fluxOf(*convert(Environment(source), Projection::cube, face)) / fluxOf(source), 1.0, 0.005) << face;
  }
}

// Down to where a texel of the target covers many of the source; accuracy_test has every pair of projections.
TEST(Convert, TotalFluxIsKeptBySmallMapsToo) {
  const EnvironmentMap panorama = *convert(Environment(smoothRadiance, 128), Projection::equirect, 128);
  for (const Projection projection : {Projection::equirect, Projection::sphere, Projection::angular, Projection::cube,
                                      Projection::eac, Projection::octahedral, Projection::equal_area})
    for (const int size : {32, 64, 128}) {
      const double flux = fluxOf(*convert(Environment(panorama), projection, size));
      // The disc of the sphere map leaves out the corners of the texels on its rim: 2 / size of its area.
      const double allowed = projection == Projection::sphere || projection == Projection::angular ? 0.02 : 0.001;
      EXPECT_NEAR(flux / fluxOf(panorama), 1.0, allowed) << nameOf(projection) << size;
    }
}

TEST(Convert, TurnsTheLight) {
  // A quarter turn that brings the source's +X to the target's +Z.
  const glm::mat3 source_from_target(glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0));
  const Environment turned(
      *convert(*builtinEnvironment("uv"), Projection::cube, 64, {.source_from_target = source_from_target}));
  const Environment uv = *builtinEnvironment("uv");
  EXPECT_LT(
      glm::length(turned.radiance({0.1f, 0.2f, 1.0f}) - uv.radiance(glm::normalize(glm::vec3(1.0f, 0.2f, -0.1f)))),
      0.05f);
}

TEST(Convert, StopsWhenAskedTo) {
  const auto stopped = convert(*builtinEnvironment("uv"), Projection::cube, 64, {}, [](auto, auto) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
