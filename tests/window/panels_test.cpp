// What stands in the panels, as somebody has looked at it: pictures/ has them, and MIRRORBALL_UPDATE_GOLDEN=1 makes
// them anew. What the picture beside them shows is tests/golden's.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "golden/comparison.h"
#include "golden/golden_picture.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "window/display.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kPanels_px = 340;  // their width

/// A state of the window.
struct PanelState {
  const char* name;  ///< of pictures/NAME.png and of the test
  std::vector<std::string> words;
};

const std::vector<PanelState>& panelStates() {
  static const std::vector<PanelState> states{
      // An exposure of 0 would have the slider's ends in the middle of pixels, where drivers choose either side.
      {"options_dark", {"-e", "white", "--exposure", "1"}},
      {"search_dark", {"-e", "white", "--find", "rough"}},
      {"inspector_light", {"-e", "white", "--theme", "light", "--keys", "I", "--pointer", "150,200"}},
      {"map_light", {"-e", "white", "--theme", "light", "--keys", "M", "--pointer", "60,60"}},
  };
  return states;
}

void PrintTo(const PanelState& state, std::ostream* out) { *out << state.name; }

/// A letter is some twenty pixels, each of them far from its ground: the maximum finds it. Other drivers round what is
/// blended, and so all headings, to the next code.
const golden::Tolerance kSameText{64, 1.0, "text is copied texel by texel; what is blended is rounded otherwise"};

Result<Image8> pictureIn(const std::string& path) {
  MIRRORBALL_TRY(bytes, readFile(path));
  return decodeTexture(bytes);
}

/// The right columns of a picture of the window, black where the time of a sample stands.
Image8 panelsOf(const Image8& window) {
  constexpr int kTimeTop = 44, kTimeBottom = 62;
  Image8 panels(kPanels_px, window.height(), 4);
  for (int y = 0; y < panels.height(); ++y) {
    const auto row = panels.row(y);
    if (y < kTimeTop || y >= kTimeBottom)
      std::copy_n(window.texel(window.width() - kPanels_px, y), row.size(), row.begin());
    for (int x = 0; x < kPanels_px; ++x) panels.texel(x, y)[3] = 255;
  }
  return panels;
}

class WindowScreenshotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("MIRRORBALL_WITHOUT_GL") != nullptr) GTEST_SKIP() << "the window needs OpenGL";
    display_ = std::make_unique<Display>();
    ASSERT_TRUE(display_->isThere());
    fs::remove(shot_);
  }

  /// returns   the exit code
  std::optional<int> view(std::vector<std::string> words) const {
    words.insert(words.begin(), {MIRRORBALL_VIEW, "sphere", "--material", "gold", "--samples", "1", "--quality",
                                 "draft", "--size", "300x400", "--screenshot"});
    return Process(words, log_).waitFor(120.0);
  }

  std::string logged() const {
    const auto bytes = readFile(log_);
    return bytes ? std::string(bytes->begin(), bytes->end()) : bytes.error().message;
  }

  const std::string log_ = ::testing::TempDir() + "panels.log";
  const std::string shot_ = ::testing::TempDir() + "panels.png";
  std::unique_ptr<Display> display_;
};

class WindowPanelsTest : public WindowScreenshotTest, public ::testing::WithParamInterface<PanelState> {};

TEST_P(WindowPanelsTest, AreAsSomebodyHasSeenThem) {
  if (std::string(IMGUI_VERSION) != "1.86")
    GTEST_SKIP() << "skipped: the pictures are of Dear ImGui 1.86, and this is " IMGUI_VERSION;
  std::vector<std::string> words = GetParam().words;
  words.insert(words.begin(), shot_);
  ASSERT_EQ(view(words), 0) << logged();
  const auto window = pictureIn(shot_);
  ASSERT_TRUE(window) << window.error().message;
  const Image8 panels = panelsOf(*window);
  const fs::path path =
      fs::path(MIRRORBALL_SOURCE_DIR) / "tests/window/pictures" / (GetParam().name + std::string(".png"));
  if (golden::isUpdating()) {
    const auto written = savePicture(path, panels);
    ASSERT_TRUE(written) << written.error().message;
    GTEST_SKIP() << "not compared: wrote " << path.string();
  }
  EXPECT_TRUE(golden::matchesGolden(path, panels, kSameText, MIRRORBALL_GOLDEN_FAILURES));
}
INSTANTIATE_TEST_SUITE_P(States, WindowPanelsTest, ::testing::ValuesIn(panelStates()),
                         [](const auto& state) { return std::string(state.param.name); });

TEST_F(WindowScreenshotTest, SaysWhyThereIsNone) {
  EXPECT_EQ(view({shot_ + "/nowhere.png", "-e", "white"}), 1);
  EXPECT_THAT(logged(), HasSubstr("nowhere.png"));
  EXPECT_EQ(view({shot_, "--keys", "Ctrl+Alt+Q"}), 1);
  EXPECT_THAT(logged(), HasSubstr("Ctrl+Alt+Q"));
  EXPECT_FALSE(fs::exists(shot_));
}

}  // namespace
}  // namespace mirrorball::testing
