#include "mirrorball/base/option_control.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

enum class Kind { small, large };

struct Settings {
  bool shows = false;
  int count = 3;
  float size = 0.5f;
  glm::vec3 tint{1.0f};
  Kind kind = Kind::small;
  std::string file = "a.png";
  glm::vec2 extent{4.0f, 2.0f};
};

const auto kTable = std::to_array<Option<Settings>>({
    {{.name = "shows"}, &Settings::shows},
    {{.name = "count", .minimum = 1, .maximum = 8}, &Settings::count},
    {{.name = "size", .minimum = 0, .maximum = 1e6, .soft_maximum = 2, .step = 0.1}, &Settings::size},
    {{.name = "tint", .minimum = 0, .maximum = 1, .is_color = true}, &Settings::tint},
    {{.name = "kind", .choices = "small|large"}, choiceField<&Settings::kind>},
    {{.name = "file", .takes_path = true}, &Settings::file},
    {{.name = "extent", .min_count = 2, .max_count = 2, .between_numbers = 'x'},
     ParsedField<Settings>{
         [](const Settings& s) { return std::to_string(int(s.extent.x)) + "x" + std::to_string(int(s.extent.y)); },
         [](const OptionText&, std::string_view written, Settings& s) -> Result<void> {
           const std::string text(written);
           s.extent = {std::stof(text), std::stof(text.substr(text.find('x') + 1))};
           return {};
         }}},
});

TEST(OptionControl, IsThatOfTheField) {
  const std::array<ControlKind, 7> kinds{ControlKind::flag,   ControlKind::integer, ControlKind::number,
                                         ControlKind::color,  ControlKind::choice,  ControlKind::file,
                                         ControlKind::numbers};
  for (std::size_t i = 0; i < kTable.size(); ++i) EXPECT_EQ(controlOf(kTable[i]).kind, kinds[i]) << i;
  const OptionControl size = controlOf(kTable[2]);
  EXPECT_EQ(size.minimum, 0.0);
  EXPECT_EQ(size.maximum, 2.0) << "a slider ends before the range does";
  EXPECT_EQ(size.step, 0.1);
  EXPECT_EQ(controlOf(kTable[1]).step, 1.0);
  EXPECT_EQ(controlOf(kTable[3]).count, 3u);
}

TEST(OptionControl, ValuesAreTyped) {
  Settings settings;
  EXPECT_EQ(std::get<bool>(valueOf(kTable[0], settings)), false);
  EXPECT_EQ(std::get<int>(valueOf(kTable[1], settings)), 3);
  EXPECT_EQ(std::get<std::vector<float>>(valueOf(kTable[2], settings)), std::vector{0.5f});
  EXPECT_EQ(std::get<int>(valueOf(kTable[4], settings)), 0);
  EXPECT_EQ(std::get<std::string>(valueOf(kTable[5], settings)), "a.png");
  EXPECT_EQ(std::get<std::vector<float>>(valueOf(kTable[6], settings)), (std::vector{4.0f, 2.0f}));
  ASSERT_TRUE(setValue(kTable[0], settings, true));
  ASSERT_TRUE(setValue(kTable[1], settings, 5));
  ASSERT_TRUE(setValue(kTable[2], settings, std::vector{0.1f + 0.2f}));
  ASSERT_TRUE(setValue(kTable[3], settings, std::vector{0.25f, 0.5f, 1.0f / 3.0f}));
  ASSERT_TRUE(setValue(kTable[4], settings, 1));
  ASSERT_TRUE(setValue(kTable[5], settings, std::string("b.png")));
  ASSERT_TRUE(setValue(kTable[6], settings, std::vector{8.0f, 6.0f}));
  EXPECT_TRUE(settings.shows);
  EXPECT_EQ(settings.count, 5);
  EXPECT_EQ(settings.size, 0.1f + 0.2f) << "no digit is lost";
  EXPECT_EQ(settings.tint, glm::vec3(0.25f, 0.5f, 1.0f / 3.0f));
  EXPECT_EQ(settings.kind, Kind::large);
  EXPECT_EQ(settings.file, "b.png");
  EXPECT_EQ(settings.extent, glm::vec2(8.0f, 6.0f));
  EXPECT_FALSE(setValue(kTable[1], settings, 9)) << "beyond the range";
  EXPECT_FALSE(setValue(kTable[2], settings, std::vector{NAN}));
  EXPECT_FALSE(setValue(kTable[4], settings, 2)) << "there are two choices";
  EXPECT_FALSE(setValue(kTable[4], settings, -1));
}

TEST(FilledIn, NamesOptionsAsTheFaceDoes) {
  const auto dashed = [](std::string_view name) { return "--" + std::string(name); };
  EXPECT_EQ(filledIn("with {option:proxy} ground, and {option:behind}", dashed), "with --proxy ground, and --behind");
  EXPECT_EQ(filledIn("nothing {here} {option:", dashed), "nothing {here} {option:");
}

}  // namespace
}  // namespace mirrorball
