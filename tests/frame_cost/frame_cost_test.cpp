// What six fixed frames cost, compared with costs.txt. Nothing else sees that every frame has become a little slower:
// between two commits a few days apart the helmet's first frame went from 1.4 to 6.3 s, and no test failed.
//
// MIRRORBALL_UPDATE_COSTS=1 writes what was measured into costs.txt; the reason is then added there by hand.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "frame_cost/cost_counter.h"
#include "frame_cost/cost_table.h"
#include "frame_cost/fixed_frames.h"
#include "frame_cost/yardstick.h"
#include "gl_driver.h"
#include "mirrorball/base/file.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball::testing {
namespace {

constexpr double kMoreInstructions = 1.15;
constexpr double kMoreTime = 1.3;

std::string tablePath() { return std::string(MIRRORBALL_SOURCE_DIR) + "/tests/frame_cost/costs.txt"; }

std::string tableText() {
  const auto bytes = readFile(tablePath());
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes ? std::string(bytes->begin(), bytes->end()) : "";
}

/// "Mesa 22.3.6" of "4.5 (Core Profile) Mesa 22.3.6"
std::string mesaOf(const std::string& version) {
  const std::size_t at = version.find("Mesa ");
  return at == std::string::npos ? version : version.substr(at);
}

class FrameCostTest : public ::testing::Test {
 protected:
  /// One thread and vectors of four floats, whatever the machine has; a driver reads this when it starts.
  static void SetUpTestSuite() {
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    ::unsetenv("GALLIVM_PERF");  // with which ./test has programs compiled for tests, not for frames
    ::setenv("LP_NUM_THREADS", "0", 1);
    ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
    // Its cache on disk does not tell vectors of one width from those of another: what one process has compiled crashes
    // another, or makes it round otherwise (Mesa 22.3.6).
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  }
};

/// The median of five quotients, each of a frame and a yardstick one after the other: a busy moment slows both.
double yardsticksOf(Renderer& renderer, const FrameSettings& settings, Yardstick& yardstick) {
  std::array<double, 5> quotients{};
  for (double& quotient : quotients) {
    const double unit = processorTimeOf([&] { yardstick.run(); });
    quotient = processorTimeOf([&] { drawn(renderer, settings); }) / unit;
  }
  std::nth_element(quotients.begin(), quotients.begin() + 2, quotients.end());
  return quotients[2];
}

FrameCost measured(Renderer& renderer, const FrameSettings& settings, Yardstick& yardstick) {
  const CostCounter counter;
  FrameCost cost;
  // The first frame compiles shaders and uploads.
  drawn(renderer, settings);
  yardstick.run();
  if (counter.countsInstructions())
    cost.instructions = 1e-6 * static_cast<double>(counter.instructionsOf([&] { drawn(renderer, settings); }));
  cost.yardsticks = yardsticksOf(renderer, settings, yardstick);
  return cost;
}

/// Whether it takes more processor time than it may, where that is what is compared.
bool takesLonger(const FrameCost& now, const FrameCost& before) {
  const bool compares_time = !now.instructions || !before.instructions;
  return compares_time && now.yardsticks && before.yardsticks && *now.yardsticks > kMoreTime * *before.yardsticks;
}

void expectNoDearer(const std::string& name, const FrameCost& now, const FrameCost& before) {
  if (now.instructions && before.instructions) {
    std::printf("%s: %.0f million instructions, %.0f before\n", name.c_str(), *now.instructions, *before.instructions);
    EXPECT_LE(*now.instructions, kMoreInstructions * *before.instructions) << name << " costs more instructions";
    return;
  }
  ASSERT_TRUE(now.yardsticks && before.yardsticks) << name << " has no cost that can be compared in costs.txt";
  std::printf("%s: processor time of %.2f yardsticks, %.2f before\n", name.c_str(), *now.yardsticks,
              *before.yardsticks);
  EXPECT_LE(*now.yardsticks, kMoreTime * *before.yardsticks) << name << " costs more processor time";
}

TEST_F(FrameCostTest, IsNotMoreThanBefore) {
  const auto before = parseCostTable(tableText());
  ASSERT_TRUE(before) << before.error().message;
  const bool updates = std::getenv("MIRRORBALL_UPDATE_COSTS") != nullptr;
  CostTable now;
  for (const FixedFrame& frame : fixedFrames()) {
    FrameSettings settings;
    auto renderer = rendererOf(frame, settings);
    if (!renderer && renderer.error().code == ErrorCode::no_gl) MIRRORBALL_END_WITHOUT_GL(renderer.error().message);
    ASSERT_TRUE(renderer) << renderer.error().message;
    now.driver = mesaOf(gl::Context::adoptCurrent()->version());
    if (!updates && now.driver != before->driver)
      GTEST_SKIP() << "costs.txt is of " << before->driver << ", and this is " << now.driver;
    auto yardstick = Yardstick::make();
    ASSERT_TRUE(yardstick) << yardstick.error().message;
    const std::string name(frame.name);
    now.frames[name] = measured(*renderer, settings, *yardstick);
    if (updates) continue;
    const auto row = before->frames.find(name);
    ASSERT_NE(row, before->frames.end()) << name << " is not in costs.txt";
    // A neighbour of the machine may fill its caches for a while: what costs more does so each time.
    for (int again = 0; again < 2 && takesLonger(now.frames[name], row->second); ++again)
      now.frames[name] = measured(*renderer, settings, *yardstick);
    expectNoDearer(name, now.frames[name], row->second);
  }
  if (!updates) return;
  const std::string text = withCosts(tableText(), now);
  ASSERT_TRUE(writeFile(tablePath(), std::vector<std::uint8_t>(text.begin(), text.end())));
}

TEST(FrameCostTable, WhatIsWrittenIsRead) {
  const CostTable table{"Mesa 1", {{"a frame", {12.0, 3.25}}, {"b", {std::nullopt, 1.5}}}};
  const auto read = parseCostTable(withCosts("# why\ndriver\tMesa 0\n", table));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->driver, "Mesa 1");
  EXPECT_EQ(read->frames.at("a frame").yardsticks, 3.25);
  EXPECT_EQ(read->frames.at("a frame").instructions, 12.0);
  EXPECT_FALSE(read->frames.at("b").instructions);
  EXPECT_EQ(withCosts("# why\n", table).substr(0, 6), "# why\n");
  EXPECT_FALSE(parseCostTable("what is this"));
}

}  // namespace
}  // namespace mirrorball::testing
