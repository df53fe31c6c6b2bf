#include "mirrorball/view/control/gesture.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/control/commands.h"

namespace mirrorball {
namespace {

const ShownPicture kShown{.camera = {.distance = 4.0f, .target = glm::vec3(0.0f)}, .size_px = {320, 200}};

/// What a button does that is pressed, moved by a way, and let go.
std::optional<Change> dragged(PointerButton button, Modifiers held, glm::vec2 by_px) {
  Gesture gesture;
  EXPECT_FALSE(gesture.handle(PointerPressed{button, {100, 100}, held}, {}, kShown));
  EXPECT_TRUE(gesture.isGoingOn());
  auto change = gesture.handle(PointerMoved{glm::vec2(100, 100) + by_px}, {}, kShown);
  EXPECT_FALSE(gesture.handle(PointerReleased{button}, {}, kShown));
  EXPECT_FALSE(gesture.isGoingOn());
  EXPECT_FALSE(gesture.handle(PointerMoved{{1, 1}}, {}, kShown)) << "nothing is held any more";
  return change;
}

CameraOptions cameraAfter(const std::optional<Change>& change) { return frameOf(change->next, 0)->camera; }

TEST(Gesture, EachButtonMovesInItsOwnWay) {
  const glm::vec2 by(20, 8);
  const CameraOptions& before = kShown.camera;
  EXPECT_EQ(cameraAfter(dragged(PointerButton::left, {}, by)), orbited(before, by, kShown.size_px));
  const CameraOptions panned_camera = panned(before, kShown.bounds, by, kShown.size_px);
  EXPECT_EQ(cameraAfter(dragged(PointerButton::middle, {}, by)), panned_camera);
  EXPECT_EQ(cameraAfter(dragged(PointerButton::left, {.shift = true}, by)), panned_camera);
  EXPECT_EQ(cameraAfter(dragged(PointerButton::left, {.control = true}, by)),
            lookedAround(before, kShown.bounds, by, kShown.size_px));
  EXPECT_GT(*cameraAfter(dragged(PointerButton::right, {}, by)).distance, *before.distance) << "away";
  const auto turned = dragged(PointerButton::right, {.shift = true}, by);
  EXPECT_FLOAT_EQ(frameOf(turned->next, 0)->env_rotation_deg.x, 18.0f);
  EXPECT_EQ(cameraAfter(turned), CameraOptions());
}

TEST(Gesture, AnotherButtonChangesNothingWhileOneIsHeld) {
  Gesture gesture;
  gesture.handle(PointerPressed{PointerButton::left, {10, 10}}, {}, kShown);
  gesture.handle(PointerPressed{PointerButton::right, {10, 10}}, {}, kShown);
  gesture.handle(PointerReleased{PointerButton::right}, {}, kShown);
  EXPECT_EQ(gesture.handle(PointerMoved{{30, 10}}, {}, kShown)->name, "Turn");
}

TEST(Gesture, TheWheelComesNearerToWhatIsUnderThePointer) {
  Gesture gesture;
  const auto change = gesture.handle(Scrolled{1.0f, {300, 20}}, {}, kShown);
  EXPECT_FLOAT_EQ(*cameraAfter(change).distance, 3.6f);
  EXPECT_GT(cameraAfter(change).target->y, 0.0f);
}

TEST(Gesture, KeysFlyWhileTheyAreHeld) {
  Gesture gesture;
  gesture.handle(KeyPressed{"W"}, {}, kShown);
  gesture.handle(KeyPressed{"S", {.control = true}}, {}, kShown);
  EXPECT_TRUE(gesture.isGoingOn());
  const auto change = gesture.advance(0.5, {}, kShown);
  EXPECT_EQ(cameraAfter(change), flown(kShown.camera, kShown.bounds, {0, 0, 0.5f}));
  EXPECT_FALSE(gesture.advance(0.0, {}, kShown));
  gesture.handle(KeyPressed{"S"}, {}, kShown);
  EXPECT_FALSE(gesture.advance(0.5, {}, kShown)) << "against each other";
  gesture.handle(FocusLost{}, {}, kShown);
  EXPECT_FALSE(gesture.isGoingOn());
}

TEST(Commands, EachHasANameAndAKeyOfItsOwn) {
  std::set<std::string_view> names, keys;
  for (const ViewerCommand& command : viewerCommands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    for (const std::string_view key : {command.key, command.other_key})
      EXPECT_TRUE(key.empty() || keys.insert(key).second) << key;
    EXPECT_EQ(commandOfKey(command.key), &command);
    History history;
    Gesture gesture;
    EXPECT_FALSE(gesture.handle(KeyPressed{std::string(command.key)}, {}, kShown) || gesture.isGoingOn())
        << command.key << " flies, too";
    command.perform(history);
  }
  EXPECT_EQ(commandOfKey("Ctrl+Alt+Q"), nullptr);
  EXPECT_EQ(commandOfKey(chordOf({"Z", {.control = true, .shift = true}}))->name, "redo");
  for (const char* chord : {"Z", "Ctrl+Shift+Z", "Shift+=", "Ctrl+Alt+Q"}) EXPECT_EQ(chordOf(pressedOf(chord)), chord);
}

TEST(Commands, DoWhatTheySay) {
  History history;
  commandOfKey("3")->perform(history);
  EXPECT_FLOAT_EQ(frameOf(history.now(), 0)->camera.azimuth_deg, 90.0f);
  commandOfKey("C")->perform(history);
  EXPECT_EQ(history.now().compare_by, CompareBy::slider);
  commandOfKey("Tab")->perform(history);
  commandOfKey("T")->perform(history);
  EXPECT_TRUE(history.now().sides[1].is_traced);
  commandOfKey("C")->perform(history);
  EXPECT_EQ(history.now().compare_by, CompareBy::none);
  for (int step = 0; step < 5; ++step) commandOfKey("Ctrl+Z")->perform(history);
  EXPECT_EQ(history.now(), Workspace());
}

/// A ball of 20 pixels around (50, 40) in a photograph of 100 × 80, seen twice as large from (10, 20) on.
const ShownPicture kBesideMap{
    .size_px = {480, 200},
    .ball = ShownBall{BallView(Pinhole{{50, 40}, 0.0}, {{50, 40}, 20}), {{10, 20}, {200, 160}}, {100, 80}}};

Workspace besideMap() {
  Workspace workspace;
  workspace.maps = {"ball.jpg"};
  workspace.photos["ball.jpg"] = {};
  workspace.shows_map = true;
  workspace.map_view = {{"picture", {"inside"}}};
  return workspace;
}

/// The circle that is given after a way, as a text; "" where none is.
std::string circleAfter(glm::vec2 from_px, glm::vec2 to_px, PointerButton button = PointerButton::left) {
  Gesture gesture;
  const PointerPressed pressed{button, from_px};
  EXPECT_TRUE(gesture.asksForPicture(pressed, besideMap()));
  EXPECT_FALSE(gesture.handle(pressed, besideMap(), kBesideMap));
  const auto change = gesture.handle(PointerMoved{to_px}, besideMap(), kBesideMap);
  if (!change) return "";
  EXPECT_TRUE(change->goes_on);
  const GivenTexts& given = change->next.photos.at("ball.jpg");
  return given.empty() ? "another change" : given.at("circle").front();
}

TEST(Gesture, ABallBesideItsMapIsMovedAndResized) {
  EXPECT_EQ(circleAfter({110, 100}, {120, 90}), "55,35,20");
  EXPECT_EQ(circleAfter({150, 100}, {160, 100}), "50,40,25") << "by its rim, from which the hand is nowhere";
  EXPECT_EQ(circleAfter({154, 100}, {164, 100}), "50,40,25") << "from a little outside";
  EXPECT_EQ(circleAfter({150, 100}, {110, 100}), "50,40,3") << "it stays to be seen";
  EXPECT_EQ(circleAfter({110, 100}, {-900, 100}), "0,40,20") << "and in the photograph";
  EXPECT_EQ(circleAfter({15, 25}, {60, 60}), "") << "beside the ball";
  EXPECT_EQ(circleAfter({110, 100}, {120, 90}, PointerButton::right), "");
  EXPECT_EQ(circleAfter({300, 100}, {320, 100}), "another change") << "in the map one looks around";
  Gesture gesture;
  EXPECT_TRUE(gesture.handle(Scrolled{1.0f, {300, 100}}, besideMap(), kBesideMap));
  EXPECT_FALSE(gesture.handle(Scrolled{1.0f, {110, 100}}, besideMap(), kBesideMap)) << "a photograph stays as it is";
}

}  // namespace
}  // namespace mirrorball
