// Blender's Cycles as a second opinion on the path tracer: one node on a sphere, in a room that is no two directions
// alike, and ours with the material that means the same.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

/// A node of Blender, and what is the same here.
struct Node {
  const char* cycles;   ///< as bench/reference_cycles.py takes it
  const char* ours;     ///< options of `render`
  double bound = 0.04;  ///< how far parts of the sphere may be apart; most of it is noise
};

// Its Lambert has no surface before it. Its metal reflects all colours alike at all angles, as ours does where f0 is 1:
// another would grow towards white at grazing angles. Its rough multiscatter glass is not white in a white furnace
// (docs/truth.md), so it is tried where it is nearly smooth, and there beside its glass of one bounce.
constexpr std::array<Node, 7> kNodes{{
    {"diffuse,0,0.8,0.5,0.2", "--set specular=0 --set perceptual_roughness=1 --set base_color=0.8,0.5,0.2"},
    {"glossy,0", "--set metallic=1 --set base_color=1 --set perceptual_roughness=0"},
    {"glossy,0.3", "--set metallic=1 --set base_color=1 --set perceptual_roughness=0.3"},
    {"glossy,0.7", "--set metallic=1 --set base_color=1 --set perceptual_roughness=0.7"},
    {"glass,0", "--set transmission=1 --set base_color=1 --set perceptual_roughness=0 --set ior=1.5"},
    {"glass,0.15", "--set transmission=1 --set base_color=1 --set perceptual_roughness=0.15 --set ior=1.5", 0.15},
    {"single_glass,0.15", "--set transmission=1 --set base_color=1 --set perceptual_roughness=0.15 --set ior=1.5"},
}};

constexpr int kSize = 96;
const std::string kView = " --orthographic 2 --camera 20,10 --size 96x96";

/// The mean radiance of parts of a sphere that just fills its picture: the whole disc, then the quarters of its inner
/// half and of the ring around it.
std::array<glm::dvec3, 9> meansOf(const Image& picture) {
  std::array<glm::dvec3, 9> sums{};
  std::array<int, 9> counts{};
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * (2.0 / kSize) - 1.0;
      const double radius = glm::length(place);
      if (radius > 0.97) continue;  // pixels at the rim show what is behind
      const int part = 1 + (place.x > 0.0 ? 1 : 0) + (place.y > 0.0 ? 2 : 0) + (radius > 0.7 ? 4 : 0);
      for (const int i : {0, part}) {
        sums[std::size_t(i)] += glm::dvec3(rgbAt(picture, x, y));
        ++counts[std::size_t(i)];
      }
    }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

/// How far two lights are apart, in shares of the second: of the channel where it is most.
double relativeDifference(glm::dvec3 light, glm::dvec3 wanted) {
  const glm::dvec3 share = glm::abs(light / wanted - 1.0);
  return std::max({share.x, share.y, share.z});
}

struct Differences {
  double of_all;
  double of_worst_part;
};

Differences differencesOf(const Image& picture, const Image& wanted) {
  const auto found = meansOf(picture), right = meansOf(wanted);
  Differences differences{relativeDifference(found[0], right[0]), 0.0};
  for (std::size_t i = 1; i < found.size(); ++i)
    differences.of_worst_part = std::max(differences.of_worst_part, relativeDifference(found[i], right[i]));
  return differences;
}

class CyclesTest : public CliTest {
 protected:
  void SetUp() override {
    if (std::system("blender --background --python-exit-code 1 --python-expr 'import numpy' >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "Blender and its python3-numpy are not installed";
  }

  /// Renders sphere.glb in room.exr by Cycles: cycles_0.exr, cycles_1.exr …, one a node.
  void renderByCycles() const {
    std::string line = "cd '" + path("").string() +
                       "' && blender --background --factory-startup --python-exit-code 1 --python "
                       "'" MIRRORBALL_SOURCE_DIR
                       "/bench/reference_cycles.py' -- sphere.glb room.exr cycles.exr "
                       "--size 96x96 --samples 64 --bounces 32";
    for (const Node& node : kNodes) line += std::string(" --node ") + node.cycles;
    ASSERT_EQ(std::system((line + " >cycles.log 2>&1").c_str()), 0);
  }

  Image traced(const Node& node, const std::string& room) const {
    trace("render sphere --reference --samples 64 --bounces 32 -o ours.exr -e " + room + kView + " " + node.ours +
          " --from equirect:for=blender");
    return image("ours.exr");
  }
};

// Also by parts of the sphere: a mirrored or turned room must not pass for the right one.
TEST_F(CyclesTest, ItsNodesHaveTheSameLight) {
  succeed("export sphere" + kView + " -o sphere.glb");
  succeed("convert studio --to equirect --size 256 --for blender -o room.exr");
  renderByCycles();
  Image mirrored = image("room.exr");
  for (int y = 0; y < mirrored.height(); ++y)
    for (int x = 0; x < mirrored.width() / 2; ++x)
      std::swap_ranges(mirrored.texel(x, y), mirrored.texel(x, y) + mirrored.channels(),
                       mirrored.texel(mirrored.width() - 1 - x, y));
  write("mirrored.exr", mirrored);

  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const Image cycles = image("cycles_" + std::to_string(i) + ".exr");
    const Differences same = differencesOf(traced(kNodes[i], "room.exr"), cycles);
    EXPECT_LT(same.of_all, 0.02) << kNodes[i].cycles;
    EXPECT_LT(same.of_worst_part, kNodes[i].bound) << kNodes[i].cycles;
    const Differences turned = differencesOf(traced(kNodes[i], "mirrored.exr"), cycles);
    EXPECT_GT(turned.of_worst_part, 2.0 * kNodes[i].bound) << kNodes[i].cycles;
  }
}

}  // namespace
}  // namespace mirrorball::testing
