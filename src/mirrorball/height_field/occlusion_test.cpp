#include "mirrorball/height_field/occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/relief.h"
#include "mirrorball/height_field/height_field_testing.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

using testing::hills;
using testing::kAllEdges;
using testing::randomHeights;
using testing::surfaceAt;

constexpr double kPi = std::numbers::pi;

/// What a texel sees, ray by ray: rays of even solid angle, each followed over the surface.
///
/// steps    for each row or column of texels that a ray crosses
/// returns  the mean direction times the share of an even sky's irradiance, and the share
glm::dvec4 seenByRays(const Image& heights, const HeightFieldSettings& settings, glm::ivec2 texel, int steps) {
  constexpr int kAzimuths = 96;
  constexpr int kElevations = 64;
  const glm::dvec3 normal(rgbAt(normalsFromHeights(heights, settings).value(), texel.x, texel.y));
  const double per_texel = double(settings.scale) * heights.width();
  const double height = surfaceAt(heights, texel.x, texel.y, settings.edges);
  const int reach = std::max(heights.width(), heights.height());
  glm::dvec4 sum(0.0);
  for (int i = 0; i < kAzimuths; ++i) {
    const double azimuth = 2.0 * kPi * (i + 0.5) / kAzimuths;
    double horizon = 0.0;
    const double step = 1.0 / (steps * std::max(std::abs(std::cos(azimuth)), std::abs(std::sin(azimuth))));
    for (double way = step; way < reach; way += step) {
      const glm::dvec2 place(texel.x + way * std::cos(azimuth), texel.y - way * std::sin(azimuth));
      if (settings.edges == MapEdges::clamped &&
          (place.x < 0.0 || place.x > heights.width() - 1.0 || place.y < 0.0 || place.y > heights.height() - 1.0))
        break;
      horizon = std::max(horizon, per_texel * (surfaceAt(heights, place.x, place.y, settings.edges) - height) / way);
    }
    for (int j = 0; j < kElevations; ++j) {
      const double z = (j + 0.5) / kElevations;
      const double across = std::sqrt(1.0 - z * z);
      const glm::dvec3 direction(across * std::cos(azimuth), across * std::sin(azimuth), z);
      const double cosine = glm::dot(direction, normal);
      if (cosine <= 0.0 || z < horizon * across) continue;
      const double part = 2.0 * cosine / (kAzimuths * kElevations);
      sum += part * glm::dvec4(direction, 1.0);
    }
  }
  return sum;
}

void expectRaysToAgree(const Image& heights, MapEdges edges, int steps, float tolerance) {
  const HeightFieldSettings settings{.edges = edges, .scale = 0.15f};
  const Occlusion found = occlusionOf(heights, settings, 64).value();
  for (int y = 1; y < heights.height(); y += 7)
    for (int x = 2; x < heights.width(); x += 6) {
      const glm::dvec4 seen = seenByRays(heights, settings, {x, y}, steps);
      EXPECT_NEAR(found.visible.texel(x, y)[0], seen.w, tolerance) << x << ", " << y << ", edges " << int(edges);
      const glm::dvec3 bent = glm::normalize(glm::dvec3(seen));
      EXPECT_GE(glm::dot(bent, glm::dvec3(rgbAt(found.bent_normals, x, y))), std::cos(0.06)) << x << ", " << y;
    }
}

// Noise is compared with what is seen from row to row, since between them its bilinear surface is another.
TEST(Occlusion, IsWhatRaysSee) {
  for (const MapEdges edges : kAllEdges) {
    expectRaysToAgree(hills(32, 24, 3), edges, 8, 0.015f);
    expectRaysToAgree(randomHeights(16, 20), edges, 1, 0.015f);
  }
}

TEST(Occlusion, FewAzimuthsAreNear) {
  const Image heights = hills(40, 40, 2);
  const Occlusion best = occlusionOf(heights, {.scale = 0.2f}, 64).value();
  for (const int azimuths : {8, 16, 32}) {
    const Occlusion found = occlusionOf(heights, {.scale = 0.2f}, azimuths).value();
    for (std::size_t i = 0; i < best.visible.samples().size(); ++i)
      ASSERT_NEAR(found.visible.samples()[i], best.visible.samples()[i], 0.3f / float(azimuths));
  }
}

// A slice's closed form against sums over its angles.
TEST(Occlusion, ASliceIsItsIntegral) {
  for (const float slope : {-1.5f, 0.0f, 0.4f, 3.0f})
    for (const glm::vec2 normal : {glm::vec2(0.0f, 1.0f), {0.6f, 0.8f}, {-0.5f, 0.7f}}) {
      const double limit = std::max(double(slope), double(-normal.x / normal.y));
      const double end = std::atan2(1.0, limit);
      constexpr int kSteps = 20000;
      glm::dvec3 sum(0.0);
      for (int i = 0; i < kSteps; ++i) {
        const double angle = end * (i + 0.5) / kSteps;
        const double weight =
            (normal.y * std::cos(angle) + normal.x * std::sin(angle)) * std::sin(angle) * end / kSteps;
        sum += weight * glm::dvec3(std::sin(angle), std::cos(angle), 1.0);
      }
      const glm::vec3 closed = formula::visibleSlice(normal.x, normal.y, slope);
      EXPECT_LE(glm::distance(glm::dvec3(closed), sum), 1e-5) << slope;
    }
}

TEST(Occlusion, KnownPlacesSeeWhatTheyShould) {
  const Occlusion flat = occlusionOf(Image(8, 5, 1, 3.0f), {}, 8).value();
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_NEAR(flat.visible.samples()[i], 1.0f, 1e-6f);
    EXPECT_NEAR(flat.bent_normals.samples()[3 * i + 2], 1.0f, 1e-6f);
  }
  // A high and long wall to the right hides half of the sky, but for half of the slices along it, and bends the normal
  // to the left.
  Image wall(16, 512, 1);
  for (int y = 0; y < 512; ++y) wall.texel(15, y)[0] = 1e4f;
  const Occlusion beside = occlusionOf(wall, {.edges = MapEdges::clamped}, 64).value();
  EXPECT_NEAR(beside.visible.texel(8, 256)[0], 0.5f, 0.021f);
  EXPECT_LT(beside.bent_normals.texel(8, 256)[0], -0.3f);
}

// How far beyond a tile the view goes depends on the place in it; so far away hardly anything is high.
TEST(Occlusion, ATiledMapHasNoSeam) {
  const Image heights = randomHeights(20, 28);
  const Image moved = occlusionOf(testing::rolled(heights, 11, 5), {.scale = 0.2f}).value().visible;
  const Image visible = testing::rolled(occlusionOf(heights, {.scale = 0.2f}).value().visible, 11, 5);
  for (std::size_t i = 0; i < visible.samples().size(); ++i)
    ASSERT_NEAR(moved.samples()[i], visible.samples()[i], 1e-3f);
}

TEST(Occlusion, TakesTheSmallestMapsAndRefusesBadOnes) {
  for (const MapEdges edges : kAllEdges)
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 9}, {9, 1}, {2, 2}})
      for (const int azimuths : {8, 64}) {
        const Occlusion found = occlusionOf(randomHeights(size.x, size.y), {.edges = edges}, azimuths).value();
        EXPECT_THAT(found.visible.samples(),
                    ::testing::Each(::testing::AllOf(::testing::Gt(0.0f), ::testing::Le(1.0f))));
      }
  Image heights(8, 4, 1);
  heights.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(occlusionOf(heights).error().message, "1 texel is NaN or infinite, the first at (3, 1)");
  heights.texel(3, 1)[0] = 1e30f;
  EXPECT_EQ(occlusionOf(heights).error().code, ErrorCode::out_of_range);
  const auto stopped = occlusionOf(Image(16, 16, 1), {}, 8, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
