// Whatever hands and keys do to a viewer can be undone; and whatever was opened is let go.

#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/view/control/commands.h"
#include "mirrorball/view/viewer/photograph_testing.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::finish;

constexpr glm::ivec2 kTiny{48, 32};

/// What hands may do next, at random.
class RandomHands {
 public:
  explicit RandomHands(unsigned seed) : random_(seed) {}

  Event next() {
    switch (below(8)) {
      case 0:
        return PointerPressed{static_cast<PointerButton>(below(3)), place(), held()};
      case 1:
      case 2:
        return PointerMoved{place()};
      case 3:
        return PointerReleased{static_cast<PointerButton>(below(3))};
      case 4:
        return Scrolled{float(below(7)) - 3.0f, place()};
      case 5:
        return KeyPressed{key(), held()};
      case 6:
        return KeyReleased{key()};
      default:
        return below(4) == 0 ? Event(FocusLost{}) : Event(Resized{glm::ivec2(1 + below(40), 1 + below(30))});
    }
  }
  /// A key of one of the commands, but for those that undo and do again.
  KeyPressed command() {
    const auto commands = viewerCommands();
    const std::string chord(commands[2 + std::size_t(below(int(commands.size()) - 2))].key);
    const std::size_t last = chord.find_last_of('+', chord.size() - 2);
    KeyPressed pressed{last == std::string::npos ? chord : chord.substr(last + 1)};
    pressed.held.control = chord.find("Ctrl+") != std::string::npos;
    pressed.held.shift = chord.find("Shift+") != std::string::npos;
    return pressed;
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

 private:
  glm::vec2 place() { return {float(below(70)) - 10.0f, float(below(50)) - 10.0f}; }
  Modifiers held() { return {.control = below(4) == 0, .shift = below(4) == 0, .alt = below(20) == 0}; }
  std::string key() { return std::string(1, static_cast<char>('A' + below(26))); }

  std::mt19937 random_;
};

Workspace ballAndMaps() {
  Workspace workspace;
  workspace.model = "sphere";
  const std::string photograph = testing::photographOf(testing::ballBeforeWall(), "events_ball.hdr");
  workspace.maps = {"white", "uv", photograph};
  workspace.photos[photograph] = {};
  workspace.frame = {{"quality", {"draft"}}, {"samples", {"1"}}};
  return workspace;
}

/// Does so much at random, undoes it, and compares with the start.
void doAndUndo(const Device& device, int events) {
  const Workspace start = ballAndMaps();
  Viewer viewer(device, start, kTiny);
  finish(viewer);
  const Image8 before = *viewer.picture();
  RandomHands hands(7);
  for (int i = 0; i < events; ++i) {
    viewer.handle(hands.below(6) == 0 ? Event(hands.command()) : hands.next());
    const auto drawn = viewer.advance(0.03);
    ASSERT_TRUE(drawn) << drawn.error().message;
    if (viewer.hasPicture()) {
      ASSERT_TRUE(viewer.picture());
    }
    (void)viewer.underPointer();
  }
  viewer.handle(FocusLost{});
  viewer.handle(Resized{kTiny});
  finish(viewer);  // a click may still be answered, which is a step, too
  while (viewer.history().undo()) {
  }
  EXPECT_EQ(viewer.workspace(), start);
  finish(viewer);
  const Image8 after = *viewer.picture();
  ASSERT_EQ(after.samples().size(), before.samples().size());
  EXPECT_TRUE(std::equal(after.samples().begin(), after.samples().end(), before.samples().begin()));
}

class ViewerEventsTest : public testing::ViewerTest {};
class ViewerEventsLongTest : public testing::ViewerTest {};

TEST_F(ViewerEventsTest, AnythingCanBeUndoneToTheStart) { doAndUndo(device(), 400); }
TEST_F(ViewerEventsLongTest, TenThousandCanBeUndoneToTheStart) { doAndUndo(device(), 10000); }

/// What the process has in memory [bytes].
double residentBytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

TEST_F(ViewerEventsLongTest, TwoHundredMapsAndModelsAreLetGo) {
  constexpr int kFiles = 200, kSettled = 20;
  const std::vector<std::string> models{"sphere", "teapot", "cube", "torus"};
  Viewer viewer(device(), ballAndMaps(), kTiny);
  double settled = 0.0;
  for (int i = 0; i < kFiles; ++i) {
    const std::string map = ::testing::TempDir() + "many_" + std::to_string(i) + ".hdr";
    ASSERT_TRUE(writeImage(map, Image(256, 128, 3, 0.1f + 0.01f * static_cast<float>(i))));
    Workspace next = withModel(withOnlyMap(viewer.workspace(), map), models[std::size_t(i) % models.size()]);
    viewer.history().change("Open", std::move(next));
    finish(viewer);
    std::remove(map.c_str());
    if (i + 1 == kSettled) settled = residentBytes();
  }
  EXPECT_LE(residentBytes(), 1.05 * settled);
}

}  // namespace
}  // namespace mirrorball
