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
#include "window/drag_source.h"

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
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ + "/state");
    ::setenv("XDG_STATE_HOME", (folder_ + "/state").c_str(), 1);
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

  /// Presses the manager's key for closing until the window has gone: the manager may not have given it the focus yet.
  void closeByKey() {
    for (int tries = 0; tries < 30 && view_->isRunning(); ++tries) {
      display_->hand("search --name ^Mirrorball windowactivate --sync key alt+F4");
      (void)view_->waitFor(1.0);
    }
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

  /// Does something by which the picture becomes another one, and waits until that is done.
  void change(const std::string& words) {
    const Picture before = picture();
    display_->hand(words);
    for (int tries = 0; tries < 100 && picture() == before; ++tries) wait(0.1);
    settle();
  }

  /// The middle of the picture, which neither menus nor panels cover.
  using Picture = std::vector<std::uint8_t>;
  Picture picture() const { return columns(150, 1000); }
  Picture panels() const { return columns(1300, 300); }
  Picture columns(int left, int width) const {
    const Image8 all = display_->photograph();
    Picture part;
    for (int y = 150; y < 650 && y < all.height(); ++y)
      part.insert(part.end(), all.texel(left, y), all.texel(left, y) + 3 * width);
    return part;
  }

  bool hasLight() const {
    const Picture now = picture();
    return !now.empty() && *std::max_element(now.begin(), now.end()) > 100;
  }

  /// Whether something is so within a while.
  template <typename Condition>
  static bool eventually(const Condition& condition) {
    for (int tries = 0; tries < 100; ++tries) {
      if (condition()) return true;
      wait(0.2);
    }
    return false;
  }

  static Image8 columnsOf(const Image8& all, int left, int width) {
    Image8 part(width, all.height(), 3);
    for (int y = 0; y < all.height(); ++y) std::copy_n(all.texel(left, y), 3 * width, part.texel(0, y));
    return part;
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

  /// Drags files onto the window, and waits until its picture is done.
  void drop(const std::vector<std::string>& paths) {
    const std::string window = display_->hand("search --name ^Mirrorball");
    ASSERT_EQ(dropFiles(display_->name(), std::stoul(window), paths), "");
    wait(0.5);
    settle();
  }

  std::string folder_ = ::testing::TempDir() + "mirrorball_window";
  std::string log_ = ::testing::TempDir() + "window.log";
  std::unique_ptr<Display> display_;
  std::unique_ptr<Process> view_;
};

TEST_F(WindowTest, AHandTurnsTheModelAndKeysUndoIt) {
  open({"teapot", "-e", "studio", "--material", "gold", "--samples", "1"});
  const Picture before = picture();
  change("mousemove 600 400 mousedown 1 mousemove 650 400 sleep 0.2 mousemove 720 430 sleep 0.2 mouseup 1");
  const Picture turned = picture();
  EXPECT_NE(turned, before);
  change("key ctrl+z");
  EXPECT_EQ(picture(), before) << "bit by bit";
  change("key ctrl+shift+z");
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
  change("key t");
  const Picture traced = picture();
  EXPECT_NE(traced, drawn);
  change("key t");
  EXPECT_EQ(picture(), drawn);
}

void writeText(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST_F(WindowTest, ShowsFilesThatAreDropped) {
  const std::string map = folder_ + "/map.hdr", model = folder_ + "/Drei Ecken, größer als 100%.obj";
  Image light(16, 8, 3);
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 8; ++y) light.texel(x, y)[y < 4 ? 0 : 2] = 0.5f;
  ASSERT_TRUE(writeImage(map, light));
  writeText(model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  open({"sphere", "-e", "white", "--samples", "1", "--size", "700x500"});
  drop({map});
  drop({model});
  const std::string rendered = folder_ + "/rendered.png";
  // Below the picture there are two panoramas to choose among now.
  Process render(
      {MIRRORBALL_PROGRAM, "render", model, "-e", map, "--samples", "1", "--size", "700x424", "-o", rendered}, log_);
  ASSERT_EQ(render.waitFor(60.0), 0) << textOf(log_);
  EXPECT_TRUE(isOn(display_->photograph(), pictureFromLinear(readImage(rendered)->image, 3)));
}

TEST_F(WindowTest, GoesOnOnAnotherMonitor) {
  display_.reset();
  display_ = Display::withTwoMonitors();
  if (!display_) GTEST_SKIP() << "skipped: there is no Xorg with its dummy driver that this user may start";
  const std::string rendered = folder_ + "/rendered.png";
  const std::vector<std::string> words{"sphere",    "-e", "studio", "--quality", "draft",
                                       "--samples", "1",  "--size", "700x500"};
  std::vector<std::string> to_render{MIRRORBALL_PROGRAM, "render", "-o", rendered};
  to_render.insert(to_render.end(), words.begin(), words.end());
  Process render(to_render, log_);
  ASSERT_EQ(render.waitFor(120.0), 0) << textOf(log_);
  const Image8 picture = pictureFromLinear(readImage(rendered)->image, 3);
  const auto isOnSecond = [&] { return isOn(columnsOf(display_->photograph(), 1700, 1280), picture); };
  open(words);
  EXPECT_TRUE(isOn(display_->photograph(), picture));
  const std::string window = display_->hand("search --name ^Mirrorball$");
  display_->hand("windowmove " + window.substr(0, window.find('\n')) + " 1760 60");
  EXPECT_TRUE(eventually(isOnSecond));
  EXPECT_FALSE(isOn(columnsOf(display_->photograph(), 0, 1700), picture));
  // And hands reach it there.
  display_->hand("mousemove 2000 300 mousedown 1 mousemove 2060 300 sleep 0.2 mousemove 2100 330 sleep 0.2 mouseup 1");
  EXPECT_TRUE(eventually([&] { return !isOnSecond(); }));
  settle();
  display_->hand("key ctrl+z");
  EXPECT_TRUE(eventually(isOnSecond));
}

TEST_F(WindowTest, ReadsNothingOutsideTheFolderOfADroppedModel) {
  const std::string model = folder_ + "/inside/model.gltf";
  std::filesystem::create_directories(folder_ + "/inside");
  const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  writeText(folder_ + "/outside.bin", {reinterpret_cast<const char*>(corners.data()), 36});
  writeText(model, R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
    "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "../outside.bin"}]})");
  const std::vector<std::string> render{MIRRORBALL_PROGRAM, "render", model, "--size", "8", "-o", folder_ + "/any.png"};
  ASSERT_EQ(Process(render, log_).waitFor(60.0), 0) << "where it is allowed, it is a model" << textOf(log_);
  open({"sphere", "-e", "white", "--samples", "1"});
  const Picture before = picture(), panels_before = panels();
  drop({model});
  EXPECT_EQ(picture(), before) << "it stays";
  EXPECT_NE(panels(), panels_before) << "a line says why";
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
  closeByKey();
  EXPECT_EQ(view_->waitFor(1.0), 0) << textOf(log_);
}

TEST_F(WindowTest, ClosesByItsManager) {
  open({"sphere", "-e", "white"});
  closeByKey();
  EXPECT_EQ(view_->waitFor(20.0), 0) << textOf(log_);
}

TEST_F(WindowTest, RefusesWhatItCannotOpenInOneLine) {
  Process wrong({MIRRORBALL_VIEW, "nowhere.glb"}, log_);
  EXPECT_EQ(wrong.waitFor(20.0), 1);
  EXPECT_THAT(textOf(log_), HasSubstr("nowhere.glb"));
  const auto refuses = [&] {
    Process without({MIRRORBALL_VIEW, "sphere"}, log_);
    return without.waitFor(20.0) == 1 && textOf(log_).find("mirrorball render") != std::string::npos;
  };
  ::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
  EXPECT_TRUE(refuses()) << textOf(log_);
  ::unsetenv("MESA_GL_VERSION_OVERRIDE");
  const Display without_gl("-extension GLX");
  EXPECT_TRUE(refuses()) << textOf(log_);
  ::unsetenv("DISPLAY");
  EXPECT_TRUE(refuses()) << textOf(log_);
}

TEST_F(WindowTest, KeepsWhatWasShownWhenItsDisplayGoesAway) {
  open({"sphere", "-e", "white", "--samples", "1", "--fov", "50"});
  display_->stop();
  EXPECT_EQ(view_->waitFor(20.0), 1);
  const std::string kept = folder_ + "/state/mirrorball/kept.json";
  EXPECT_EQ(textOf(log_), "mirrorball: the connection to the display broke; to go on: mirrorball view " + kept + "\n");
  EXPECT_THAT(textOf(kept), HasSubstr("50"));
}

}  // namespace
}  // namespace mirrorball::testing
