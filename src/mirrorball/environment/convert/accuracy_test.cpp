// How exact conversion is, between every two projections. docs/conversion.md has the figures and tells what they mean.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/conversion.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/convert/supersampling.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

using testing::kEveryProjection;

/// A source at least as fine, where it is compared, as a cube of 256² in the middle of its faces: 128 texels a radian.
int sourceSize(Projection projection) {
  switch (projection) {
    case Projection::cube:
    case Projection::eac:
      return 256;
    case Projection::octahedral:
    case Projection::equal_area:
      return 768;  // its triangles are sheared: 512 have 85 across and 148 along
    case Projection::sphere:
    case Projection::angular:
      return 1024;
    case Projection::ball:
      return projection == Projection::ballFrom(1.5f) ? 640 : 1024;  // a near ball shows the front larger
    default:
      return 512;
  }
}

/// A target so fine that none of its texels, but near singular points, spans √2 texels of the source: there it would
/// hold a mean over its area, which is another quantity than the light at its centre.
int targetSize(Projection projection) { return faceCount(projection) == 6 ? 562 : 1124; }

/// Away from the source's own singular points: straight behind on an angular map, both poles of the equal-area square,
/// and the part of a ball, towards its rim, where texels lie so far apart that they do not hold the waves.
bool isRegular(Projection source, glm::vec3 direction) {
  constexpr float kMinDensity = 120.0f;
  constexpr float kAside_texels = 4.0f;
  if (!covers(source, direction)) return false;
  const glm::vec2 uv = positionOf(source, direction).uv;
  const auto size = static_cast<float>(sourceSize(source));
  switch (source) {
    case Projection::sphere:
    case Projection::ball:
      return texelDensityAt(source, sourceSize(source), {0, uv}).lesser >= kMinDensity;
    case Projection::angular:
      return glm::length(uv - 0.5f) * size < size / 2.0f - kAside_texels;
    case Projection::equal_area: {
      const glm::vec2 from_middle = glm::abs(uv - 0.5f);
      return std::min(glm::length(from_middle), glm::length(0.5f - from_middle)) * size > kAside_texels;
    }
    default:
      return true;
  }
}

/// A texel and the light that belongs there.
struct Sample {
  glm::ivec2 texel;
  glm::vec3 direction;
  float light;
  float solid_angle;
};

/// A rectangle of a target's texels, no larger than those that conversion.cpp converts in one way.
struct Tile {
  Strip strip;
  std::vector<Sample> samples;
};

/// Of one target: tiles from all over the map, and a third of the texels in them.
struct Target {
  Conversion conversion;
  std::vector<Tile> tiles;

  explicit Target(Projection to) : conversion(to, targetSize(to), {}) {
    constexpr glm::ivec2 kSize(32, 16);
    constexpr int kEach = 19;
    const glm::ivec2 extent = conversion.extent();
    int count = 0;
    for (int face = 0; face < faceCount(to); ++face)
      for (int y = 0; y < extent.y; y += kSize.y)
        for (int x = 0; x < extent.x; x += kSize.x)
          if (count++ % kEach == 0) add({face, {x, y}, glm::min(glm::ivec2(x, y) + kSize, extent)});
  }

  void add(const Strip& strip) {
    Tile tile{strip, {}};
    for (int y = strip.begin.y; y < strip.end.y; ++y)
      for (int x = strip.begin.x + y % 3; x < strip.end.x; x += 3) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(conversion.extent());
        if (!covers(conversion.to(), uv)) continue;
        const glm::vec3 direction = directionAt(conversion.to(), {strip.face, uv});
        tile.samples.push_back({{x, y},
                                direction,
                                testing::waves(direction).x,
                                texelSolidAngle(conversion.to(), conversion.extent(), {x, y})});
      }
    tiles.push_back(std::move(tile));
  }
};

const std::vector<Target>& targets() {
  static const std::vector<Target> all(kEveryProjection.begin(), kEveryProjection.end());
  return all;
}

struct Difference {
  double root_mean_square = 0.0;
  double largest = 0.0;
  double share = 0.0;  ///< of the solid angle that both maps cover: what was compared
};

Difference differenceOf(const Environment& source, const Target& target) {
  const Projection from = source.map()->projection();
  const Conversion& conversion = target.conversion;
  Difference difference;
  double sum = 0.0;
  std::size_t count = 0;
  double compared = 0.0;
  double covered = 0.0;
  for (const auto& [strip, samples] : target.tiles) {
    Image texels = Image::withoutValues(strip.size().x, strip.size().y, conversion.channels());
    conversion.fill(source, strip, texels);
    const bool is_mean = pointsPerTexel(source, conversion.to(), conversion.extent(), strip.face, strip.begin,
                                        strip.end, glm::mat3(1.0f))
                             .smooth != glm::ivec2(1);
    for (const Sample& sample : samples) {
      if (!covers(from, sample.direction)) continue;
      covered += double(sample.solid_angle);
      if (is_mean || !isRegular(from, sample.direction)) continue;
      const glm::ivec2 place = sample.texel - strip.begin;
      const double error = std::abs(double(rgbAt(texels, place.x, place.y).x) - double(sample.light));
      sum += error * error;
      difference.largest = std::max(difference.largest, error);
      compared += double(sample.solid_angle);
      ++count;
    }
  }
  difference.root_mean_square = std::sqrt(sum / double(count));
  difference.share = compared / covered;
  return difference;
}

class Accuracy : public ::testing::TestWithParam<Projection> {};

TEST_P(Accuracy, SmoothLightIsExactInEveryProjection) {
  const Projection from = GetParam();
  const Environment source(*convert(Environment(testing::waves, 1), from, sourceSize(from)));
  for (const Target& target : targets()) {
    const Projection to = target.conversion.to();
    const Difference difference = differenceOf(source, target);
    RecordProperty("rms_to_" + testing::testName(to), std::to_string(difference.root_mean_square * 1e6) + "e-6");
    RecordProperty("largest_to_" + testing::testName(to), std::to_string(difference.largest * 1e6) + "e-6");
    RecordProperty("share_to_" + testing::testName(to), std::to_string(difference.share));
    EXPECT_LT(difference.root_mean_square, 1.5e-4) << textOf(from) << " to " << textOf(to);
    EXPECT_GT(difference.share, 0.5) << textOf(from) << " to " << textOf(to);
  }
}

/// Nothing in the half z < 0, and nothing to speak of near it.
glm::vec3 lightInFront(glm::vec3 d) { return testing::smoothRadiance(d) * std::max(d.z, 0.0f) * std::max(d.z, 0.0f); }

bool leavesMuchOut(Projection projection) {
  return projection == Projection::hemioctahedral || projection == Projection::ballFrom(1.5f);
}

// ∫ L dω. Where one of the maps leaves much out the light ends before the map does: texels on the border count wholly
// or not at all, and on a near ball's rim they count much.
TEST_P(Accuracy, TotalFluxIsKept) {
  constexpr int kHeight = 192;
  const Projection from = GetParam();
  const auto sourceOf = [&](glm::vec3 (*light)(glm::vec3)) {
    return *convert(Environment(light, 1), from, equivalentSize(Projection::equirect, kHeight, from));
  };
  const EnvironmentMap whole = sourceOf(testing::smoothRadiance);
  const EnvironmentMap front = sourceOf(lightInFront);
  const double whole_flux = testing::fluxOf(whole);
  const double front_flux = testing::fluxOf(front);
  for (const Projection to : kEveryProjection) {
    const bool in_front = leavesMuchOut(from) || leavesMuchOut(to);
    const EnvironmentMap target =
        *convert(Environment(in_front ? front : whole), to, equivalentSize(Projection::equirect, kHeight, to));
    EXPECT_NEAR(testing::fluxOf(target) / (in_front ? front_flux : whole_flux), 1.0, 1e-3)
        << textOf(from) << " to " << textOf(to);
  }
}

// A step is a hundredth of a texel. A wrong neighbour would make it as large as neighbouring texels' difference, 0.05.
TEST_P(Accuracy, ConversionLeavesNoSeam) {
  const Projection from = GetParam();
  const EnvironmentMap source = *convert(Environment(testing::smoothRadiance, 1), from, 64);
  for (const Projection to : kEveryProjection) {
    const EnvironmentMap target = *convert(Environment(source), to, 32);
    const auto isNoEnd = [&](glm::vec3 d) {
      // Where half a sphere ends the light does, over two texels of the target.
      if (from == Projection::hemioctahedral && d.z < 0.2f) return false;
      return !testing::isEnd(from, d) && !testing::isEnd(to, d);
    };
    EXPECT_LT(testing::largestStep(target, isNoEnd), 0.01f) << textOf(from) << " to " << textOf(to);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryProjection, Accuracy, ::testing::ValuesIn(kEveryProjection),
                         [](const auto& instance) { return testing::testName(instance.param); });

}  // namespace
}  // namespace mirrorball
