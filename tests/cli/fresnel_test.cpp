// What `mirrorball fresnel` prints and plots.

#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;

using FresnelTest = CliTest;

TEST_F(FresnelTest, PrintsEachFormAtEachAngleAndTheBestFit) {
  const std::string text = succeed("fresnel --ior 1.5");
  EXPECT_THAT(text, StartsWith("index 1.5: n 1.5, 0.04 at normal incidence\nangle     exact      schlick"));
  EXPECT_THAT(text, HasSubstr("\n0         0.04000    0.04000"));
  EXPECT_THAT(text, HasSubstr("\n90        1.00000    1.00000    1.00000    0.98"));
  EXPECT_THAT(text, HasSubstr("\nschlick   off by up to 0.0357\n"));
  EXPECT_THAT(text, HasSubstr("\nempirical off by up to 0.0154 with "));
  EXPECT_THAT(text, HasSubstr("fresnel_offset=0.055 fresnel_scale=0.929 fresnel_power=5.3"));
  EXPECT_THAT(succeed("fresnel bk7"), StartsWith("bk7: n 1.5168"));
}

TEST_F(FresnelTest, PrintsAMetalForEachChannel) {
  EXPECT_THAT(succeed("fresnel gold"), AllOf(HasSubstr("gold, red: n 0.156, k 3.602, 0.956"),
                                             HasSubstr("\n\ngold, green:"), HasSubstr("\n\ngold, blue:")));
}

TEST_F(FresnelTest, JsonHasTheSameNumbers) {
  const Json json = Json::parse(succeed("fresnel silver --json"));
  EXPECT_EQ(json["title"], "silver");
  ASSERT_EQ(json["curves"].size(), 3u);
  const Json& blue = json["curves"][2];
  EXPECT_EQ(blue["channel"], "blue");
  ASSERT_EQ(blue["table"].size(), 19u);
  EXPECT_EQ(blue["table"][18]["angle"], 90);
  EXPECT_EQ(blue["table"][0]["exact"], blue["f0"]);
  EXPECT_LE(blue["f82"]["greatest_error"], blue["schlick"]["greatest_error"]);
  EXPECT_TRUE(Json::parse(succeed("fresnel --ior 1.333 --json"))["curves"][0]["channel"].is_null());
}

// What it says of the empirical form is what a render with those parameters shows.
TEST_F(FresnelTest, PlotsIntoAFileOrToStandardOutput) {
  EXPECT_THAT(succeed("fresnel water -o water.svg"), HasSubstr("water: n 1.33"));
  const std::vector<std::uint8_t> file = bytes("water.svg");
  const std::string svg(file.begin(), file.end());
  EXPECT_THAT(svg, AllOf(StartsWith("<svg xmlns="), HasSubstr("reflectance of water"), HasSubstr("F82")));
  EXPECT_EQ(succeed("fresnel water -o -.svg"), svg);
}

TEST_F(FresnelTest, StandardOutputHasTheJsonOrThePlot) {
  EXPECT_EQ(refuse(2, "fresnel water --json -o -.svg"), "-.svg: standard output has the JSON; name a file");
  EXPECT_EQ(Json::parse(succeed("fresnel water --json -o water.svg"))["title"], "water");
  EXPECT_EQ(files(), std::vector<std::string>{"water.svg"});
}

TEST_F(FresnelTest, RefusesWhatHasNoIndexAndWhatIsNoPlot) {
  EXPECT_THAT(refuse(2, "fresnel"), HasSubstr("--ior 1.5"));
  EXPECT_THAT(refuse(2, "fresnel gold --ior 1.5"), HasSubstr("not both"));
  EXPECT_THAT(refuse(2, "fresnel mirror"), HasSubstr("mirror has no index"));
  EXPECT_THAT(refuse(2, "fresnel godl"), HasSubstr("did you mean 'gold'"));
  EXPECT_THAT(refuse(2, "fresnel --ior 0"), HasSubstr("0.1 … 10"));
  EXPECT_THAT(refuse(2, "fresnel --ior nan"), HasSubstr("ior"));
  EXPECT_THAT(refuse(2, "fresnel gold -o gold.png"), HasSubstr(".svg"));
  EXPECT_THAT(refuse(1, "fresnel gold -o nowhere/gold.svg"), HasSubstr("nowhere"));
}

}  // namespace
}  // namespace mirrorball::testing
