#include "mirrorball/render/settings/capture_options.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

const Option<FrameSettings>* optionNamed(std::span<const Option<FrameSettings>> options, std::string_view name) {
  const auto found =
      std::find_if(options.begin(), options.end(), [&](const auto& option) { return option.text.name == name; });
  return found == options.end() ? nullptr : &*found;
}

TEST(CaptureOptions, LeaveOutWhatIsOfPictures) {
  EXPECT_EQ(optionNamed(captureFrameOptions(), "camera"), nullptr);
  EXPECT_EQ(optionNamed(captureFrameOptions(), "size"), nullptr);
  EXPECT_NE(optionNamed(captureFrameOptions(), "proxy"), nullptr);
  EXPECT_EQ(captureFrameOptions().size() + 11, frameOptions().size());
}

TEST(CaptureOptions, HaveAllMappingsButTheOneForOneViewingDirection) {
  const Option<FrameSettings>* const all = optionNamed(frameOptions(), "mapping");
  const Option<FrameSettings>* const some = optionNamed(captureFrameOptions(), "mapping");
  ASSERT_NE(all, nullptr);
  ASSERT_NE(some, nullptr);
  EXPECT_EQ(std::string(some->text.choices) + "|sphere", all->text.choices);
  FrameSettings settings;
  EXPECT_TRUE(assign(*some, settings, "normal"));
  EXPECT_EQ(settings.mapping, Mapping::normal);
  EXPECT_FALSE(assign(*some, settings, "sphere"));
}

TEST(CaptureOptions, HaveAllBackgroundsButNone) {
  const Option<FrameSettings>* const all = optionNamed(frameOptions(), "background");
  const Option<FrameSettings>* const some = optionNamed(captureFrameOptions(), "background");
  ASSERT_NE(all, nullptr);
  ASSERT_NE(some, nullptr);
  EXPECT_EQ(std::string(some->text.value) + "|transparent", all->text.value);
  const auto refused = checkCapture({.background = BackgroundKind::transparent}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "a map has light for every direction; {option:background} 0,0,0 leaves it dark");
  EXPECT_TRUE(checkCapture({}, {}));
}

TEST(CaptureOptions, AreCheckedAsThoseOfPictures) {
  const FrameSettings settings{.texgen = Texgen::light};
  const auto refused = checkCapture(settings, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("{option:light}"), std::string::npos);
}

}  // namespace
}  // namespace mirrorball
