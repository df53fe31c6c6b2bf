// Suns and sharp steps: what a smooth curve between texels would ring beside. Everything in 32-bit floats.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using testing::kEveryProjection;

constexpr float kSun = 1e5f;
constexpr int kSmall = 32;  ///< a panorama's height; other maps are as fine
constexpr int kLarge = 96;

struct LightRange {
  float min;
  float max;
};

/// Of the texels that a map shows.
LightRange rangeOf(const EnvironmentMap& map) {
  LightRange range{1e30f, -1e30f};
  const glm::ivec2 extent = map.extent();
  for (int face = 0; face < map.faces(); ++face)
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x) {
        if (!covers(map.projection(), (glm::vec2(x, y) + 0.5f) / glm::vec2(extent))) continue;
        const glm::vec3 light = rgbAt(map.face(face), x, y);
        range.min = std::min({range.min, light.x, light.y, light.z});
        range.max = std::max({range.max, light.x, light.y, light.z});
      }
  return range;
}

bool isGrey(const EnvironmentMap& map) {
  for (int face = 0; face < map.faces(); ++face)
    for (int y = 0; y < map.extent().y; ++y)
      for (int x = 0; x < map.extent().x; ++x)
        if (const glm::vec3 light = rgbAt(map.face(face), x, y); light.x != light.y || light.y != light.z) return false;
  return true;
}

int sizeOf(Projection projection, int height) { return equivalentSize(Projection::equirect, height, projection); }

EnvironmentMap white(Projection projection, int height) {
  return *convert(Environment([](glm::vec3) { return glm::vec3(1.0f); }, 1), projection, sizeOf(projection, height));
}

void setLight(EnvironmentMap& map, int face, int x, int y, float light) {
  std::fill_n(map.face(face).texel(x, y), 3, light);
}

/// A square of texels of a sun on light of 1.
struct Sun {
  glm::ivec2 first;  ///< texel of image 0
  int side;

  std::string text() const {
    return "a sun of " + std::to_string(side) + "² texels at " + std::to_string(first.x) + ", " +
           std::to_string(first.y);
  }
};

EnvironmentMap mapOf(Projection projection, int height, const Sun& sun) {
  EnvironmentMap map = white(projection, height);
  for (int y = 0; y < sun.side; ++y)
    for (int x = 0; x < sun.side; ++x) setLight(map, 0, sun.first.x + x, sun.first.y + y, kSun);
  return map;
}

/// Within an image, at the middle of its edge, and in its corner where that is no part of a disc.
std::vector<Sun> suns(Projection projection, int height) {
  const glm::ivec2 extent = imageSize(projection, sizeOf(projection, height));
  std::vector<Sun> suns;
  for (const int side : {1, 2}) {
    suns.push_back({{extent.x / 3, extent.y * 2 / 5}, side});
    suns.push_back({{hasDisc(projection) ? 1 : 0, extent.y / 2 - 1}, side});
    if (!hasDisc(projection)) suns.push_back({{0, 0}, side});
  }
  return suns;
}

/// Light of 1 in one half of all directions and of another value in the other.
std::vector<EnvironmentMap> steps(Projection projection, float light) {
  std::vector<EnvironmentMap> maps;
  for (const glm::vec3 normal : {glm::vec3(0.1f, 0.9f, 0.2f), glm::vec3(-0.4f, 0.5f, 0.6f)}) {
    EnvironmentMap map = white(projection, kSmall);
    for (int face = 0; face < map.faces(); ++face)
      for (int y = 0; y < map.extent().y; ++y)
        for (int x = 0; x < map.extent().x; ++x) {
          const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(map.extent());
          if (glm::dot(directionAt(projection, {face, uv}), normal) > 0.0f) setLight(map, face, x, y, light);
        }
    maps.push_back(std::move(map));
  }
  return maps;
}

/// overshoot  how far light may leave what the source holds
void expectWithin(const EnvironmentMap& map, const EnvironmentMap& source, float overshoot, const std::string& what) {
  const LightRange range = rangeOf(map);
  const LightRange held = rangeOf(source);
  constexpr float kRounding = 1e-6f;  // of weights whose sum is 1
  EXPECT_GE(range.min, (held.min - overshoot) * (1.0f - kRounding)) << what;
  EXPECT_LE(range.max, (held.max + overshoot) * (1.0f + kRounding)) << what;
  EXPECT_TRUE(isGrey(map)) << what;
}

/// The map in its own projection enlarged and reduced, and in two others.
void expectNoRinging(const EnvironmentMap& map, float overshoot, const std::string& what) {
  const Projection projection = map.projection();
  for (const int size : {map.size() * 16, map.size() * 3, map.size() * 2 / 3, 3})
    expectWithin(*convert(Environment(map), projection, size), map, overshoot, what + " at " + std::to_string(size));
  if (!covers(projection, {0.0f, 0.0f, -1.0f})) return;  // others would show black where it has nothing
  expectWithin(*convert(Environment(map), Projection::equirect, 4 * kSmall), map, overshoot, what + " as a panorama");
}

class SharpLight : public ::testing::TestWithParam<Projection> {};

TEST_P(SharpLight, NothingIsBrighterOrDarkerBesideASun) {
  for (const Sun& sun : suns(GetParam(), kSmall))
    expectNoRinging(mapOf(GetParam(), kSmall, sun), 0.0f, textOf(GetParam()) + ", " + sun.text());
}

/// At a disc's rim or where smooth regions meet a step may cut off a strip of two texels. At little contrast that is a
/// peak, whose curve rises an eighth above them. Beyond the edge of one half light goes on as it went before.
float overshootOfStep(Projection projection, float light) {
  if (projection == Projection::equirect || light >= 16.0f) return 0.0f;
  return (light - 1.0f) / (projection == Projection::hemioctahedral ? 2.5f : 8.0f);
}

TEST_P(SharpLight, NothingIsBrighterOrDarkerBesideAStep) {
  for (const float light : {1.5f, 12.0f, 1e3f})
    for (const EnvironmentMap& map : steps(GetParam(), light))
      expectNoRinging(map, overshootOfStep(GetParam(), light),
                      textOf(GetParam()) + ", a step to " + std::to_string(light));
}

/// How far the flux of an enlarged sun may be off. In a cube's corner three texels meet instead of four, and the tip of
/// a cone lies in one of an equal-area square; texels at the rim of a ball seen from near by grow by
/// half from one to the next.
double fluxTolerance(Projection projection, const Sun& sun) {
  const bool is_corner = sun.first == glm::ivec2(0);
  if (is_corner && faceCount(projection) == 6) return projection == Projection::eac ? 0.1 : 0.08;
  if (is_corner && projection == Projection::equal_area) return 0.02;
  if (projection == Projection::ballFrom(1.5f)) return 0.03;
  return 0.01;
}

TEST_P(SharpLight, KeepsTheFluxOfAnEnlargedSun) {
  const Projection projection = GetParam();
  for (const Sun& sun : suns(projection, kLarge)) {
    const EnvironmentMap map = mapOf(projection, kLarge, sun);
    const EnvironmentMap enlarged = *convert(Environment(map), projection, map.size() * 2);
    EXPECT_NEAR(testing::fluxOf(enlarged) / testing::fluxOf(map), 1.0, fluxTolerance(projection, sun))
        << textOf(projection) << ", " << sun.text();
  }
}

// One look-up a texel was off by up to 17 % (and by 8 % for the sun of a real panorama). A texel across an octahedron's
// edge is half of it narrower than the other, and its mean does not know which half is which.
TEST_P(SharpLight, KeepsTheFluxOfASunAtEveryRatio) {
  const Projection projection = GetParam();
  constexpr int kHeight = 192;
  const float diameter_deg = 1.5f;  // less than two texels
  for (const glm::vec3 towards : {glm::vec3(0.31f, 0.42f, 0.85f), glm::vec3(-0.52f, -0.33f, 0.6f)}) {
    const float cosine = std::cos(glm::radians(diameter_deg / 2.0f));
    const auto light = [&](glm::vec3 d) {
      return glm::vec3(glm::dot(d, glm::normalize(towards)) > cosine ? kSun : 1e-3f);
    };
    const EnvironmentMap panorama = *convert(Environment(light, 1), Projection::equirect, kHeight);
    for (const float ratio : {0.4f, 0.55f, 0.7f, 0.8f, 0.9f, 1.0f, 1.1f, 1.25f, 1.4f, 1.7f, 2.5f, 4.0f}) {
      const int size = static_cast<int>(static_cast<float>(sizeOf(projection, kHeight)) * ratio);
      const EnvironmentMap converted = *convert(Environment(panorama), projection, size);
      EXPECT_NEAR(testing::fluxOf(converted) / testing::fluxOf(panorama), 1.0,
                  projection == Projection::octahedral ? 0.02 : 0.01)
          << textOf(projection) << " " << size;
    }
  }
}

// With plain bilinear weights the first row of a panorama gained 8 %, the second 1.5 %. Each target texel looks up its
// centre alone: four of them a texel of the source sum a kinked line to 0.8 % of its integral.
TEST(SharpLightAtThePole, ARowKeepsItsFlux) {
  for (const int height : {8, 64, 192})
    for (const int row : {0, 1, 2, height / 2, height - 1}) {
      EnvironmentMap panorama = white(Projection::equirect, height);
      for (int x = 0; x < 2 * height; ++x) setLight(panorama, 0, x, row, kSun);
      for (const Projection projection : {Projection::cube, Projection::octahedral, Projection::equirect}) {
        const EnvironmentMap converted = *convert(Environment(panorama), projection, sizeOf(projection, 4 * height));
        EXPECT_NEAR(testing::fluxOf(converted) / testing::fluxOf(panorama), 1.0, 0.01)
            << textOf(projection) << ", row " << row << " of " << height;
      }
    }
}

// Gaps of sky among dark leaves are no suns: means over texels blurred them, by up to 1.1 dB of a panorama's picture.
TEST(SharpLightAmongLeaves, StaysSharp) {
  constexpr float kGap = 20.0f;
  EnvironmentMap leaves = white(Projection::equirect, kLarge);
  for (const int x : {40, 90, 140}) setLight(leaves, 0, x, kLarge / 3 + x / 20, kGap);
  const EnvironmentMap cube = *convert(Environment(leaves), Projection::cube, 80);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < cube.size(); ++y)
      for (int x = 0; x < cube.size(); ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(cube.size());
        const glm::vec3 centre = leaves.radiance(directionAt(Projection::cube, {face, uv}), Interpolation::bicubic);
        EXPECT_NEAR(rgbAt(cube.face(face), x, y).x, centre.x, 1e-3f) << face << " " << x << " " << y;
      }
}

TEST(SharpLightOnTheSameGrid, IsTheSame) {
  const EnvironmentMap map = mapOf(Projection::equirect, kSmall, {{20, 12}, 1});
  const EnvironmentMap same = *convert(Environment(map), Projection::equirect, kSmall);
  for (int y = 0; y < kSmall; ++y)
    for (int x = 0; x < 2 * kSmall; ++x) {
      const float light = rgbAt(map.face(0), x, y).x;
      EXPECT_NEAR(rgbAt(same.face(0), x, y).x, light, 0.5f + 1e-4f * light) << x << " " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryProjection, SharpLight, ::testing::ValuesIn(kEveryProjection),
                         [](const auto& instance) { return testing::testName(instance.param); });

}  // namespace
}  // namespace mirrorball
