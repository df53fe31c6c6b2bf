#include "mirrorball/light_edit/lamp_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/light_edit/light_edit_testing.h"

namespace mirrorball {
namespace {

using testing::cloudySky;
using testing::lampsIn;
using testing::MadeSun;
using testing::mapOfSky;
using testing::mapOfSuns;
using testing::smoothSky;

constexpr LampSettings kAllSizes{.max_size_deg = 360.0f};

EnvironmentMap scaled(const EnvironmentMap& map, float factor, const LampSettings& settings = kAllSizes) {
  auto result = scaleLamps(Environment(map), factor, settings);
  EXPECT_TRUE(result) << result.error().message;
  return std::move(result->map);
}

/// Calls `visit(before, after, texel)` for all texels.
template <typename Visit>
void forBoth(const EnvironmentMap& before, const EnvironmentMap& after, const Visit& visit) {
  for (int face = 0; face < before.faces(); ++face)
    for (int y = 0; y < before.extent().y; ++y)
      for (int x = 0; x < before.extent().x; ++x) {
        const MapTexel texel{face, {x, y}};
        visit(radianceOf(before, texel), radianceOf(after, texel), texel);
      }
}

TEST(LampScale, ALampHasTheFactorTimesItsIrradiance) {
  for (const Projection projection : {Projection::equirect, Projection::cube})
    for (const glm::vec3 place : testing::kPlaces) {
      const int size = projection == Projection::cube ? 256 : 512;
      const EnvironmentMap map = mapOfSuns({{place, 1.0f}}, cloudySky, projection, size);
      const std::vector<MapLamp> before = lampsIn(map);
      ASSERT_EQ(before.size(), 1u);
      for (const float factor : {0.25f, 2.0f, 10.0f}) {
        const std::vector<MapLamp> after = lampsIn(scaled(map, factor));
        ASSERT_EQ(after.size(), 1u) << factor;
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(after[0].irradiance[c] / before[0].irradiance[c], factor, 5e-3f * factor) << factor;
        EXPECT_LT(angleBetween(after[0].direction, before[0].direction), 1e-3);
        EXPECT_NEAR(after[0].angular_size_rad, before[0].angular_size_rad, 2e-3f);
      }
    }
}

TEST(LampScale, AllElseStaysBitForBit) {
  const MadeSun sun{{0.3f, 0.8f, -0.5f}, 0.53f};
  const EnvironmentMap map = mapOfSuns({sun}, cloudySky, Projection::equirect, 512);
  const MapLamp lamp = lampsIn(map).front();
  const double changed = double(lamp.reach_rad()) + 0.08;  // 3° and the glow that counts as the lamp's
  for (const float factor : {0.0f, 0.5f, 3.0f}) {
    std::size_t others = 0;
    forBoth(map, scaled(map, factor), [&](glm::vec3 before, glm::vec3 after, const MapTexel& texel) {
      if (angleBetween(directionOf(map, texel), lamp.direction) < changed) return;
      ++others;
      ASSERT_EQ(before, after) << texel.place.x << " " << texel.place.y;
    });
    EXPECT_GT(others, 500000u);
  }
  forBoth(map, scaled(map, 1.0f), [](glm::vec3 before, glm::vec3 after, const MapTexel&) { ASSERT_EQ(before, after); });
}

// A sun's halo is a lamp whose light falls smoothly to that of the sky: neighbours that differed little differ little
// afterwards.
TEST(LampScale, TheChangeHasNoEdgeInTheSky) {
  const MadeSun sun{{0.3f, 0.2f, 0.9f}, 0.53f};
  const auto hazy = [&](glm::vec3 d) {
    const double angle = angleBetween(d, glm::normalize(glm::dvec3(sun.direction)));
    return smoothSky(d) * (1.0f + 60.0f * std::exp(-static_cast<float>(angle * angle) / 0.02f));
  };
  const EnvironmentMap map = mapOfSuns({sun}, hazy, Projection::equirect, 1024);
  ASSERT_GE(lampsIn(map).size(), 1u);
  const EnvironmentMap bright = scaled(map, 3.0f);
  float largest = 1.0f;
  forBoth(map, bright, [&](glm::vec3 before, glm::vec3 after, const MapTexel& texel) {
    const MapTexel beside = texelBeside(map, texel, {1, 0});
    if (before.x > 60.0f || radianceOf(map, beside).x > 60.0f) return;
    const float there = radianceOf(bright, beside).x / radianceOf(map, beside).x;
    largest = std::max(largest, (after.x / before.x) / there);
  });
  EXPECT_GT(largest, 1.001f) << "the glow changes with the lamp";
  EXPECT_LT(largest, 1.15f);
}

TEST(LampScale, WithoutLightALampGivesWayToItsSurroundings) {
  for (const Projection projection : {Projection::equirect, Projection::cube}) {
    const EnvironmentMap sky = mapOfSky(smoothSky, projection, 256);
    const EnvironmentMap map = mapOfSuns({{{0.3f, 0.8f, -0.5f}, 0.53f}}, smoothSky, projection, 256);
    const EnvironmentMap dark = scaled(map, 0.0f);
    EXPECT_TRUE(lampsIn(dark).empty());
    forBoth(sky, dark, [](glm::vec3 before, glm::vec3 after, const MapTexel&) {
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(after[c], before[c], 0.02f * before[c]);
    });
  }
}

// A window is a wide lamp, and the sun in it one of its own: none of their texels is scaled twice.
TEST(LampScale, LampsThatTouchAreEachScaledOnce) {
  const auto window = [](glm::vec3 d) {
    const bool is_inside = d.z > 0.0f && std::abs(d.x / d.z) < 0.2f && std::abs(d.y / d.z) < 0.15f;
    return is_inside ? glm::vec3(100.0f, 110.0f, 120.0f) : glm::vec3(0.5f);
  };
  const EnvironmentMap map =
      mapOfSuns({{{0.05f, 0.05f, 1.0f}, 0.6f}, {{0.05f, 0.0605f, 1.0f}, 0.6f}}, window, Projection::equirect, 512);
  const std::vector<MapLamp> before = lampsIn(map);
  ASSERT_GE(before.size(), 2u);
  const EnvironmentMap bright = scaled(map, 2.0f);
  const std::vector<MapLamp> after = lampsIn(bright);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i].illuminance() / before[i].illuminance(), 2.0f, 0.04f) << i;
  forBoth(map, bright, [](glm::vec3 light, glm::vec3 result, const MapTexel&) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(result[c], light[c]);
      ASSERT_LE(result[c], 2.05f * light[c]);
    }
  });
}

TEST(LampScale, OnlyTheLampsThatAreSelected) {
  const MadeSun strong{{0.0f, 0.5f, 1.0f}, 0.5f, glm::vec3(2e5f)};
  const MadeSun weak{{1.0f, 0.5f, 0.0f}, 0.5f, glm::vec3(1e5f)};
  const EnvironmentMap map = mapOfSuns({strong, weak}, smoothSky, Projection::equirect, 512);
  LampSettings one = kAllSizes;
  one.max = 1;
  const std::vector<MapLamp> before = lampsIn(map);
  const std::vector<MapLamp> after = lampsIn(scaled(map, 4.0f, one));
  ASSERT_EQ(after.size(), 2u);
  EXPECT_NEAR(after[0].illuminance(), 4.0f * before[0].illuminance(), 0.02f * after[0].illuminance());
  EXPECT_NEAR(after[1].illuminance(), before[1].illuminance(), 1e-4f * before[1].illuminance());
  LampSettings small = kAllSizes;
  small.max_size_deg = 0.1f;
  const auto none = scaleLamps(Environment(map), 4.0f, small);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->lamps.empty());
}

// Other projections stay what they are: the panorama is only where the lamps are searched.
TEST(LampScale, AMapOfAnyFormKeepsIt) {
  const MadeSun sun{{0.4f, 0.5f, 0.7f}, 2.0f, glm::vec3(2e4f)};
  for (const Projection projection : {Projection::octahedral, Projection::angular, Projection::equal_area}) {
    const EnvironmentMap map = mapOfSky(
        [&](glm::vec3 d) {
          const bool is_sun = angleBetween(d, glm::normalize(sun.direction)) < 0.0175;
          return is_sun ? sun.radiance : smoothSky(d);
        },
        projection, 512);
    const auto panorama = [](const EnvironmentMap& of) { return *searchedMap(Environment(of)); };
    auto result = scaleLamps(Environment(map), 2.0f, kAllSizes);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->lamps.size(), 1u) << int(projection);
    EXPECT_EQ(result->map.projection(), projection);
    const std::vector<MapLamp> after = lampsIn(panorama(result->map));
    ASSERT_EQ(after.size(), 1u);
    EXPECT_NEAR(after[0].illuminance() / result->lamps[0].illuminance(), 2.0f, 0.03f) << int(projection);
    std::size_t changed = 0, all = 0;
    forBoth(map, result->map, [&](glm::vec3 before, glm::vec3 now, const MapTexel&) {
      ++all;
      changed += before != now ? 1u : 0u;
    });
    EXPECT_GT(changed, 10u);
    EXPECT_LT(changed, all / 50);
  }
}

TEST(LampScale, MapsWithoutLampsAndExtremes) {
  const EnvironmentMap black = mapOfSky([](glm::vec3) { return glm::vec3(0.0f); }, Projection::equirect, 64);
  auto none = scaleLamps(Environment(black), 2.0f, kAllSizes);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->lamps.empty());
  const EnvironmentMap one(Projection::equirect, [] {
    ImageSet images(1, 1);
    images.at(0, 0) = Image(2, 1, 3, 1.0f);
    return images;
  }());
  EXPECT_TRUE(scaleLamps(Environment(one), 0.0f, kAllSizes));
  EnvironmentMap brightest = mapOfSky(smoothSky, Projection::equirect, 256);
  std::fill_n(brightest.face(0).texel(256, 60), 3, 9e35f);
  const auto too_bright = scaleLamps(Environment(brightest), 1000.0f, kAllSizes);
  ASSERT_FALSE(too_bright);
  EXPECT_EQ(too_bright.error().code, ErrorCode::out_of_range);
}

// What a file holds below 0 beside the lamps is not touched, and alpha nowhere.
TEST(LampScale, NegativeLightAndAlphaStay) {
  EnvironmentMap map = mapOfSuns({{{0.0f, 0.02f, 1.0f}, 1.0f}}, smoothSky, Projection::equirect, 256);
  Image with_alpha(512, 256, 4, 0.25f);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) std::copy_n(map.face(0).texel(x, y), 3, with_alpha.texel(x, y));
  std::fill_n(with_alpha.texel(3, 5), 3, -0.5f);
  map.face(0) = with_alpha;
  auto result = scaleLamps(Environment(map), 2.0f, kAllSizes);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->lamps.size(), 1u);
  EXPECT_EQ(result->map.face(0).texel(3, 5)[1], -0.5f);
  for (int x = 0; x < 512; ++x) ASSERT_EQ(result->map.face(0).texel(x, 127)[3], 0.25f);
}

/// A limit of memory, while it lives.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::uint64_t bytes) : before_(memoryLimit()) { setMemoryLimit(bytes); }
  ~MemoryLimit() { setMemoryLimit(before_); }

 private:
  const std::uint64_t before_;
};

// A panorama of 3 MB, of which no second one is made, and a float for each of its texels, 1 MB.
TEST(LampScale, MemoryIsCheckedBeforeItIsTaken) {
  const EnvironmentMap sky = mapOfSky(smoothSky, Projection::equirect, 362);
  const EnvironmentMap map = mapOfSuns({{{0.3f, 0.8f, -0.5f}, 1.0f}}, smoothSky, Projection::equirect, 362);
  EnvironmentMap negative = map;
  negative.face(0).texel(3, 300)[0] = -1.0f;
  const auto errorWithin = [](const EnvironmentMap& scaled, std::uint64_t bytes) {
    const MemoryLimit limit(bytes);
    const auto result = scaleLamps(Environment(scaled), 2.0f, kAllSizes);
    return result ? std::nullopt : std::optional(result.error().code);
  };
  EXPECT_EQ(errorWithin(map, 4'100'000), ErrorCode::too_large);
  EXPECT_EQ(errorWithin(map, 4'300'000), std::nullopt);
  EXPECT_EQ(errorWithin(sky, 3'200'000), std::nullopt) << "without lamps nothing is made";
  EXPECT_EQ(errorWithin(negative, 6'200'000), ErrorCode::too_large) << "a copy without negative light";
  EXPECT_EQ(errorWithin(negative, 7'400'000), std::nullopt);
  const EnvironmentMap octahedral = mapOfSky(smoothSky, Projection::octahedral, 512);
  EXPECT_EQ(errorWithin(octahedral, 5'000'000), ErrorCode::too_large) << "and a panorama";
}

TEST(LampScale, StopsWhenItIsAskedTo) {
  const MadeSun sun{{0.4f, 0.5f, 0.7f}, 20.0f, glm::vec3(100.0f)};
  for (const Projection projection : {Projection::equirect, Projection::cube}) {
    const EnvironmentMap map = mapOfSuns({sun}, smoothSky, projection, 256);
    for (const std::size_t last : {0u, 100u}) {
      std::size_t polled = 0;
      const Observer observer{.progress = [&](std::string_view) -> ProgressFunction {
        return [&](std::size_t done, std::size_t total) {
          EXPECT_EQ(total, std::size_t(map.extent().y) * std::size_t(map.faces()));
          return ++polled, done < last;
        };
      }};
      const auto result = scaleLamps(Environment(map), 2.0f, kAllSizes, observer);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().code, ErrorCode::interrupted);
      EXPECT_GT(polled, last);
    }
  }
}

}  // namespace
}  // namespace mirrorball
