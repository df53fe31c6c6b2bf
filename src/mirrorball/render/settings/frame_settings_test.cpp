#include "mirrorball/render/settings/frame_settings.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/option_control.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

/// Gives an option a value; what is wrong with it, or nothing.
std::string set(FrameSettings& settings, std::string_view name, std::string_view value) {
  const auto option = std::ranges::find(frameOptions(), name, [](const auto& row) { return row.text.name; });
  const auto assigned = assign(*option, settings, value);
  return assigned ? "" : assigned.error().message;
}

TEST(FrameOptions, DefaultsAreWhatTheProjectPromises) {
  const FrameSettings settings;
  std::string defaults;
  for (const auto& option : frameOptions()) defaults += written(option, settings) + " ";
  EXPECT_EQ(defaults,
            "1280x720 4 adaptive display 0 neutral pattern env 30,15  35  0 1 no none  1 0 0 2 map exact 4 reflection "
            "fragment "
            "bump 64 "
            "single probes 4 channels 12  none no cube trilinear none 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1  1 ");
  EXPECT_EQ(settings.display.exposure(), 1.0f);
}

TEST(FrameOptions, EveryRowHasANameOfItsOwnAndHelp) {
  std::set<std::string_view> names;
  for (const auto& option : frameOptions()) {
    EXPECT_TRUE(names.insert(option.text.name).second) << option.text.name;
    EXPECT_FALSE(option.text.help.empty()) << option.text.name;
  }
}

// A panel is made of the table alone: only what is more than numbers and choices is a line of text there.
TEST(FrameOptions, EveryRowCanBeAControl) {
  FrameSettings settings;
  std::vector<std::string> texts;
  for (const auto& option : frameOptions()) {
    const std::string name(option.text.name);
    const OptionControl control = controlOf(option);
    if (control.kind == ControlKind::text) texts.push_back(name);
    EXPECT_LE(control.minimum, control.maximum) << name;
    const std::string before = written(option, settings);
    const ControlValue value = valueOf(option, settings);
    if (before.empty()) continue;  // such as lights, which are added
    EXPECT_TRUE(setValue(option, settings, value)) << name;
    EXPECT_EQ(written(option, settings), before) << name;
    EXPECT_EQ(valueOf(option, settings), value) << name;
  }
  EXPECT_EQ(settings, FrameSettings());
  EXPECT_THAT(texts, ::testing::ElementsAre("background", "proxy", "probes"));
}

// What a row writes it also reads.
TEST(FrameOptions, AreWrittenAsTheyAreRead) {
  const std::vector<std::pair<std::string, std::string>> values{
      {"size", "640x480"},
      {"exposure", "-1.5"},
      {"tone-map", "aces"},
      {"background", "blur"},
      {"camera", "1,2,3"},
      {"target", "1,2,3"},
      {"fov", "60"},
      {"orthographic", "2"},
      {"samples", "9"},
      {"env-rotation", "1,2"},
      {"env-rotation", "1,0,3"},
      {"env-intensity", "0.5"},
      {"probes", "auto"},
      {"probes", "64"},
      {"blur", "cone"},
      {"lobe-taps", "6"},
      {"background", "0.5,2,0"},
      {"lookup", "flat-nearest"},
      {"texture-filter", "anisotropic"},
      {"ground-roughness", "0.25"},
      {"relief", "linear-binary"},
      {"relief-steps", "32"},
      {"dispersion", "spectral"},
      {"wavelengths", "16"},
      {"wavelength", "486.13"},
      {"texgen", "eye-linear"},
      {"texture-matrix", "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16"}};
  for (const auto& [name, value] : values) {
    FrameSettings settings;
    EXPECT_EQ(set(settings, name, value), "");
    const auto option = std::ranges::find(frameOptions(), name, [](const auto& row) { return row.text.name; });
    EXPECT_EQ(written(*option, settings), value) << name;
  }
}

TEST(FrameOptions, WavelengthsAreThoseOfVisibleLight) {
  FrameSettings settings;
  for (const char* wrong : {"379", "781", "0.55", "green"})
    EXPECT_THAT(set(settings, "wavelength", wrong), HasSubstr("nanometres (380 … 780)")) << wrong;
  EXPECT_EQ(settings.wavelength_nm, 0.0f);
  EXPECT_THAT(set(settings, "wavelengths", "7"), HasSubstr("8 … 16"));
  EXPECT_THAT(set(settings, "wavelengths", "17"), HasSubstr("8 … 16"));
}

TEST(FrameOptions, ProbesAreCounted) {
  FrameSettings settings;
  EXPECT_EQ(set(settings, "probes", "0"), "");
  for (const char* wrong : {"-1", "65", "1000", "2.5", "all"})
    EXPECT_THAT(set(settings, "probes", wrong), HasSubstr("probes takes 'auto' or a number (0 … 64)")) << wrong;
  EXPECT_EQ(settings.probes, 0);
}

TEST(FrameOptions, SizesAreChecked) {
  FrameSettings settings;
  EXPECT_EQ(set(settings, "size", "640x480"), "");
  EXPECT_EQ(settings.size, glm::ivec2(640, 480));
  for (const char* wrong : {"", "640x", "0x480", "640x480x3", "640.5x480", "-1x5", "99999x1", "axb"})
    EXPECT_THAT(set(settings, "size", wrong), HasSubstr("size takes WIDTHxHEIGHT")) << wrong;
  EXPECT_EQ(settings.size, glm::ivec2(640, 480)) << "a wrong one changes nothing";
  EXPECT_EQ(set(settings, "size", "320"), "");
  EXPECT_EQ(settings.size, glm::ivec2(320, 240)) << "a width alone keeps the shape";
  EXPECT_EQ(set(settings, "size", "1"), "");
  EXPECT_EQ(settings.size, glm::ivec2(1, 1));
}

TEST(FrameOptions, BackgroundsAreParsed) {
  FrameSettings settings;
  EXPECT_EQ(set(settings, "background", "#ff8000"), "");
  EXPECT_EQ(settings.background, BackgroundKind::display_color);
  EXPECT_NEAR(settings.background_color.x, 1.0f, 1e-6f);
  EXPECT_NEAR(settings.background_color.y, 0.2158605f, 1e-5f) << "sRGB 128";
  EXPECT_EQ(set(settings, "background", "0.5,2,0"), "");
  EXPECT_EQ(settings.background, BackgroundKind::radiance);
  EXPECT_EQ(settings.background_color, glm::vec3(0.5f, 2.0f, 0.0f));
  EXPECT_EQ(set(settings, "background", "transparent"), "");
  EXPECT_EQ(settings.background, BackgroundKind::transparent);
  for (const char* wrong : {"#ff80", "#gg8000", "red", "1,2"})
    EXPECT_THAT(set(settings, "background", wrong), HasSubstr("background takes env, blur")) << wrong;
}

TEST(FrameOptions, LightsAreParsedAndLimited) {
  FrameSettings settings;
  EXPECT_THAT(set(settings, "light", "1,2,3"), HasSubstr("light takes 6 numbers"));
  for (std::size_t i = 0; i < FrameSettings::kMaxLights; ++i) EXPECT_EQ(set(settings, "light", "1,2,3,4,5,6"), "");
  EXPECT_EQ(settings.lights[7].color, glm::vec3(4, 5, 6));
  EXPECT_THAT(set(settings, "light", "1,2,3,4,5,6"), HasSubstr("8 times at most"));
}

TEST(FrameOptions, CamerasAreChecked) {
  FrameSettings settings;
  EXPECT_EQ(set(settings, "camera", "10,20,3"), "");
  EXPECT_EQ(settings.camera.distance, 3.0f);
  EXPECT_THAT(set(settings, "camera", "10,91"), HasSubstr("elevation from -90 to 90"));
  EXPECT_THAT(set(settings, "camera", "10,20,0"), HasSubstr("distance above 0"));
}

}  // namespace
}  // namespace mirrorball
