// Environments that are near, as a user asks for them.

#include <string>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ProxyOptionTest : public RenderCliTest {};

TEST_F(ProxyOptionTest, ARoomIsTheSameDrawnAndTraced) {
  const std::string shot =
      "render sphere --material mirror -e uv --proxy box:-3,-1.5,-4,5,3,4 --captured-at 0.5,0.5,0 --camera 20,10,4 "
      "--size 96x64 --samples 16 ";
  succeed(shot + "-o drawn.png");
  trace(shot + "--reference --bounces 1 -o traced.png");
  const Outcome compared = run("compare drawn.png traced.png --threshold psnr=34");
  EXPECT_EQ(compared.exit_code, 0) << compared.out;
}

TEST_F(ProxyOptionTest, AModelStandsOnTheGroundDrawnAndTraced) {
  const std::string shot = "render sphere --material mirror -e sunset --camera 20,25 --size 96x64 ";
  succeed(shot + "--proxy ground:2 --samples 16 -o drawn.png");
  trace(shot + "--proxy ground:2 --reference --samples 64 -o traced.png");
  succeed(shot + "--samples 16 -o afloat.png");
  const Outcome compared = run("compare drawn.png traced.png --threshold psnr=29");
  EXPECT_EQ(compared.exit_code, 0) << compared.out;
  EXPECT_NE(run("compare afloat.png traced.png --threshold psnr=24").exit_code, 0);
}

TEST_F(ProxyOptionTest, WhatCannotBeIsOneLine) {
  for (const auto& [options, says] : std::vector<std::pair<std::string, std::string>>{
           {"--proxy box:1,2,3", "6 numbers"},
           {"--proxy sphere:0,0,0,0", "a radius above 0"},
           {"--proxy ground:0", "above the ground"},
           {"--proxy no_such_room.glb", "no_such_room"},
           {"--proxy box:-3,-3,-3,3,3,3 --captured-at 9,0,0", "not within its proxy"},
           {"--captured-at 0,0,0", "add --proxy"},
           {"--ground-roughness 0.2", "add --proxy ground"},
           {"--proxy ground --ground-roughness 1.2", "0 … 1"},
           {"--proxy ground --camera 0,-40", "the camera is below the ground"}}) {
    const Outcome outcome = run("render sphere --size 16x16 -o no.png " + options);
    EXPECT_NE(outcome.exit_code, 0) << options;
    EXPECT_THAT(outcome.err, HasSubstr(says)) << options;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
  EXPECT_THAT(run("capture sphere --at 0,0,2 --captured-at 0,0,0 -o no.exr").err, HasSubstr("add --proxy"));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(ProxyOptionTest, WhatIsOutsideIsNoted) {
  EXPECT_THAT(run("render sphere --size 16x16 -o a.png --proxy sphere:0,0,0,0.5").err,
              HasSubstr("does not hold all of the model"));
  EXPECT_THAT(run("render sphere --size 16x16 -o b.png --proxy box:-1,-1,-1,1,1,1").err,
              HasSubstr("the camera is outside of the proxy"));
}

}  // namespace
}  // namespace mirrorball::testing
