// What somebody sees and does at the window.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "window/display.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("MIRRORBALL_WITHOUT_GL") != nullptr) GTEST_SKIP() << "the window needs OpenGL";
    for (const char* program : {"Xvfb", "openbox", "xdotool", "xwd"})
      ASSERT_TRUE(isInstalled(program)) << program << " is missing; ./test installs it";
    display_ = std::make_unique<Display>();
    ASSERT_TRUE(display_->isThere());
  }

  /// Opens a window, and waits until its picture is done.
  void open(std::vector<std::string> words) {
    words.insert(words.begin(), MIRRORBALL_VIEW);
    view_ = std::make_unique<Process>(words, log_);
    for (int tries = 0; tries < 600 && display_->hand("search --name ^Mirrorball").empty(); ++tries) wait(0.1);
    ASSERT_TRUE(view_->isRunning()) << textOf(log_);
    for (int tries = 0; tries < 600 && !hasLight(); ++tries) wait(0.2);
    ASSERT_TRUE(hasLight()) << "no picture came";
    settle();
  }

  static void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

  /// Waits until the window's title says that nothing is going on, for a while in which what is seen stays the same.
  void settle() {
    Picture before;
    int calm = 0;
    constexpr int kCalm = 4;
    for (int tries = 0; tries < 1000 && calm < kCalm; ++tries) {
      wait(0.25);
      Picture now = picture();
      const bool is_done = !display_->hand("search --name ^Mirrorball$").empty();
      calm = is_done && now == before ? calm + 1 : 0;
      before = std::move(now);
    }
    EXPECT_GE(calm, kCalm) << "it never rests";
  }

  /// The middle of the picture, which neither menus nor panels cover.
  using Picture = std::vector<std::uint8_t>;
  Picture picture() const {
    const Image8 all = display_->photograph();
    Picture part;
    for (int y = 150; y < 650 && y < all.height(); ++y)
      part.insert(part.end(), all.texel(150, y), all.texel(150, y) + 3 * 1000);
    return part;
  }

  bool hasLight() const {
    const Picture now = picture();
    return !now.empty() && *std::max_element(now.begin(), now.end()) > 100;
  }

  /// Whether a photograph has a picture somewhere, its rows below each other.
  static bool isOn(const Image8& photograph, const Image8& picture) {
    for (int top = 0; top + picture.height() <= photograph.height(); ++top)
      for (int left = 0; left + picture.width() <= photograph.width(); ++left)
        if (isAt(photograph, picture, left, top)) return true;
    return false;
  }
  static bool isAt(const Image8& photograph, const Image8& picture, int left, int top) {
    for (int y = 0; y < picture.height(); ++y)
      if (!std::equal(picture.texel(0, y), picture.texel(0, y) + 3 * picture.width(), photograph.texel(left, top + y)))
        return false;
    return true;
  }

  std::string log_ = ::testing::TempDir() + "window.log";
  std::unique_ptr<Display> display_;
  std::unique_ptr<Process> view_;
};

TEST_F(WindowTest, AHandTurnsTheModelAndKeysUndoIt) {
  open({"teapot", "-e", "studio", "--material", "gold", "--samples", "1"});
  const Picture before = picture();
  display_->hand("mousemove 600 400 mousedown 1 mousemove 650 400 sleep 0.2 mousemove 720 430 sleep 0.2 mouseup 1");
  settle();
  const Picture turned = picture();
  EXPECT_NE(turned, before);
  display_->hand("key ctrl+z");
  settle();
  EXPECT_EQ(picture(), before) << "bit by bit";
  display_->hand("key ctrl+shift+z");
  settle();
  EXPECT_EQ(picture(), turned);
}

TEST_F(WindowTest, SavesAndShowsWhatRenderDraws) {
  const std::string saved = ::testing::TempDir() + "window_saved.png";
  const std::string rendered = ::testing::TempDir() + "window_rendered.png";
  std::filesystem::remove(saved);
  open({"teapot", "-e", "studio", "--material", "gold", "--samples", "1"});
  const Image8 photograph = display_->photograph();
  const Picture before = picture();
  display_->hand("key ctrl+p");
  for (int tries = 0; tries < 100 && picture() == before; ++tries) wait(0.2);
  wait(2.0);  // its field blinks, and so it never rests
  display_->hand("type --delay 150 " + saved);
  wait(3.0);
  display_->hand("key Return");
  for (int tries = 0; tries < 300 && !std::filesystem::exists(saved); ++tries) wait(0.1);
  const auto picture = readImage(saved);
  ASSERT_TRUE(picture) << picture.error().message;
  const std::string size = std::to_string(picture->image.width()) + "x" + std::to_string(picture->image.height());
  Process render({MIRRORBALL_PROGRAM, "render", "teapot", "-e", "studio", "--material", "gold", "--samples", "1",
                  "--size", size, "-o", rendered},
                 log_);
  ASSERT_EQ(render.waitFor(120.0), 0) << textOf(log_);
  EXPECT_EQ(textOf(saved), textOf(rendered)) << "byte by byte";
  EXPECT_TRUE(isOn(photograph, pictureFromLinear(picture->image, 3))) << "and it is what was seen";
}

TEST_F(WindowTest, ComparesWithTheTruthAtAKey) {
  open({"sphere", "-e", "studio", "--material", "gold", "--quality", "draft", "--samples", "2"});
  const Picture drawn = picture();
  display_->hand("key t");
  settle();
  EXPECT_EQ(picture(), drawn) << "while it is traced";
  display_->hand("key t");
  settle();
  const Picture traced = picture();
  EXPECT_NE(traced, drawn);
  display_->hand("key t");
  settle();
  EXPECT_EQ(picture(), drawn);
}

TEST_F(WindowTest, FollowsItsManager) {
  open({"sphere", "-e", "white", "--material", "gold", "--samples", "1"});
  const std::string window = "search --name ^Mirrorball ";
  for (const char* size : {"1 1", "900 500", "400 1200", "1300 700"}) {
    display_->hand(window + "windowsize " + size);
    wait(1.0);
    ASSERT_TRUE(view_->isRunning()) << size << textOf(log_);
  }
  display_->hand(window + "windowminimize");
  wait(1.0);
  ASSERT_TRUE(view_->isRunning()) << textOf(log_);
  EXPECT_FALSE(hasLight()) << "nothing is seen of it";
  display_->hand(window + "windowactivate --sync");
  settle();
  EXPECT_TRUE(hasLight());
}

TEST_F(WindowTest, ClosesWhileItLoads) {
  view_ = std::make_unique<Process>(std::vector<std::string>{MIRRORBALL_VIEW, "knot", "-e", "sunset"}, log_);
  for (int tries = 0; tries < 600 && display_->hand("search --name ^Mirrorball").empty(); ++tries) wait(0.05);
  // The manager may not have it yet.
  for (int tries = 0; tries < 30 && view_->isRunning(); ++tries) {
    display_->hand("search --name ^Mirrorball windowactivate --sync key alt+F4");
    (void)view_->waitFor(1.0);
  }
  EXPECT_EQ(view_->waitFor(1.0), 0) << textOf(log_);
}

TEST_F(WindowTest, ClosesByItsManager) {
  open({"sphere", "-e", "white"});
  display_->hand("search --name ^Mirrorball windowactivate --sync key alt+F4");
  EXPECT_EQ(view_->waitFor(20.0), 0) << textOf(log_);
}

TEST_F(WindowTest, RefusesWhatItCannotOpenInOneLine) {
  Process wrong({MIRRORBALL_VIEW, "nowhere.glb"}, log_);
  EXPECT_EQ(wrong.waitFor(20.0), 1);
  EXPECT_THAT(textOf(log_), HasSubstr("nowhere.glb"));
  ::unsetenv("DISPLAY");
  Process without({MIRRORBALL_VIEW, "sphere"}, log_);
  EXPECT_EQ(without.waitFor(20.0), 1);
  EXPECT_THAT(textOf(log_), HasSubstr("mirrorball render"));
}

}  // namespace
}  // namespace mirrorball::testing
