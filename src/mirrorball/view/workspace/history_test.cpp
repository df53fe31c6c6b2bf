#include "mirrorball/view/workspace/history.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/panel/panel.h"
#include "mirrorball/view/workspace/asked_map.h"
#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {
namespace {

Workspace ofModel(const char* model) {
  Workspace workspace;
  workspace.model = model;
  return workspace;
}

TEST(History, UndoesAndDoesAgainByName) {
  History history(ofModel("sphere"));
  EXPECT_TRUE(history.undoName().empty());
  EXPECT_FALSE(history.undo());
  history.change("Open teapot", ofModel("teapot"));
  history.change("Open knot", ofModel("knot"));
  history.change("Nothing", ofModel("knot"));
  EXPECT_EQ(history.undoName(), "Open knot");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "teapot");
  EXPECT_EQ(history.redoName(), "Open knot");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "sphere");
  EXPECT_TRUE(history.redo());
  history.change("Open cube", ofModel("cube"));
  EXPECT_FALSE(history.redo()) << "what was undone is forgotten by another change";
}

TEST(History, WhatAHandDoesIsOneStep) {
  History history(ofModel("sphere"));
  for (const char* model : {"a", "b", "c"}) history.change("Turn", ofModel(model), true);
  history.endGesture();
  for (const char* model : {"d", "e"}) history.change("Turn", ofModel(model), true);
  history.change("Zoom", ofModel("f"), true);
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "e");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "c");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "sphere");
}

TEST(History, AWayBackToItsStartIsNoStep) {
  History history(ofModel("sphere"));
  for (const char* model : {"a", "b", "sphere"}) history.change("Turn", ofModel(model), true);
  EXPECT_TRUE(history.undoName().empty());
  history.change("Turn", ofModel("a"), true);
  history.change("Other", ofModel("a"));
  history.change("Turn", ofModel("b"), true);
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.now().model, "a") << "what changed nothing came between";
}

TEST(History, KeepsOnlyTheLastSteps) {
  History history;
  for (std::size_t i = 0; i <= History::kMostSteps; ++i) history.change("Open", ofModel(std::to_string(i).c_str()));
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, History::kMostSteps);
}

/// What a user may do next, at random: mostly what is right, and sometimes what is refused.
class RandomUser {
 public:
  explicit RandomUser(unsigned seed) : random_(seed) {}

  void act(History& history) {
    const Workspace& now = history.now();
    switch (below(10)) {
      case 0:
        return (void)history.undo();
      case 1:
        return (void)history.redo();
      case 2:
        return history.endGesture();
      case 3:
        return history.change("Next map", withMapStepped(now, int(below(5)) - 2));
      case 4:
        if (below(4) == 0) return history.change("Open", withModel(now, "model" + std::to_string(below(3))));
        if (below(3) == 0) return history.change("Photograph", photographed(now));
        return history.change("Open", withMap(now, "map" + std::to_string(below(6)) + ".hdr"));
      case 5:
        return history.change("Turn", moved(now), true);
      case 6:
        return history.change("Compare", comparing(now));
      case 7:
        return play(history);
      case 8:
        return history.change("Reset", below(10) == 0 ? withoutOptions(now) : withoutGroup(now, groupOf(now)));
      default:
        return setRow(history);
    }
  }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }

  /// An animation that goes on is no step.
  void play(History& history) {
    if (history.now().plays) history.goOn(withMoment(history.now(), "Walk", between(0.0f, 4.0f)));
    Workspace next = history.now();
    next.plays = !next.plays;
    history.change("Play", std::move(next));
  }

  Workspace moved(const Workspace& now) {
    constexpr glm::ivec2 kSize{640, 360};
    constexpr BoundingSphere kBounds{{0, 1, 0}, 2.0f};
    const CameraOptions camera = frameOf(now, 0)->camera;
    const glm::vec2 by(between(-50, 50), between(-50, 50));
    switch (below(4)) {
      case 0:
        return withCamera(now, orbited(camera, by, kSize));
      case 1:
        return withCamera(now, panned(camera, kBounds, by, kSize));
      case 2:
        return withCamera(now, zoomed(camera, kBounds, between(0.7f, 1.4f), by + 100.0f, kSize));
      default:
        return withCamera(now, alongAxis(camera, static_cast<AxisView>(below(6))));
    }
  }

  /// Takes the map for a photograph or a map, or moves the circle in it.
  Workspace photographed(const Workspace& now) {
    if (below(2) == 0) return withBallCircle(now, {{between(0, 900), between(0, 700)}, between(3, 300)});
    return withPhotograph(now, below(3) != 0);
  }

  Workspace comparing(Workspace now) {
    now.compare_by = static_cast<CompareBy>(below(5));
    now.edited_side = below(2);
    now.sides[below(2)].is_traced = below(2) == 0;
    if (below(2) == 0) now.sides[below(2)].map = below(now.maps.size());
    now.selected_material = below(3);
    return now;
  }

  std::string_view groupOf(const Workspace& now) {
    const auto groups = *panelsOf(now);
    return groups[below(groups.size())].title;
  }

  /// Sets a row as a panel does.
  void setRow(History& history) {
    const Material material;
    const auto groups = *panelsOf(history.now(), &material);
    const PanelGroup& group = groups[below(groups.size())];
    const PanelRow& row = group.rows[below(group.rows.size())];
    if (!row.texts.empty() && below(2) == 0)
      return history.change("Remove", withoutText(history.now(), row.table, row.name, below(row.texts.size() + 1)));
    if (auto changed = withValue(history.now(), row, valueFor(row)))
      history.change(std::string(row.name), std::move(*changed), below(2) == 0);
  }

  ControlValue valueFor(const PanelRow& row) {
    const float low = std::isfinite(row.control.minimum) ? float(row.control.minimum) : -10.0f;
    const float high = std::isfinite(row.control.maximum) ? float(row.control.maximum) : 10.0f;
    switch (row.control.kind) {
      case ControlKind::flag:
        return below(2) == 0;
      case ControlKind::choice:
        return int(below(row.choices.size() + 1));  // one of them is none
      case ControlKind::integer:
        return int(between(low, high));
      case ControlKind::number:
      case ControlKind::numbers:
      case ControlKind::color: {
        std::vector<float> numbers;
        for (std::size_t i = 0; i < row.control.count; ++i) numbers.push_back(between(low, high));
        return numbers;
      }
      case ControlKind::file:
      case ControlKind::text:
        break;
    }
    return row.names.empty() ? std::string("blur") : std::string(row.names[below(row.names.size())]);
  }

  std::mt19937 random_;
};

// Every state that a user can come to can be drawn, is told by its file bit by bit, and leads back to the start.
TEST(History, AnythingThatIsDoneCanBeUndoneToTheStart) {
  constexpr int kEvents = 10'000;
  const Workspace start = ofModel("teapot");
  History history(start);
  RandomUser user(20261127);
  std::size_t states = 0;
  for (int event = 0; event < kEvents; ++event) {
    const Workspace before = history.now();
    user.act(history);
    if (history.now() == before) continue;
    ++states;
    for (std::size_t side = 0; side < 2; ++side) ASSERT_TRUE(frameOf(history.now(), side)) << "after event " << event;
    if (event % 10 != 0) continue;
    const auto read = readWorkspace(writtenWorkspace(history.now()));
    ASSERT_TRUE(read) << read.error().message << "\n" << writtenWorkspace(history.now());
    ASSERT_EQ(*read, history.now()) << writtenWorkspace(history.now());
  }
  EXPECT_GT(states, std::size_t(kEvents) / 2) << "too little was done";
  EXPECT_FALSE(history.now().photos.empty());
  const Workspace last = history.now();
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(history.now(), start);
  EXPECT_EQ(writtenWorkspace(history.now()), writtenWorkspace(start));
  for (; undone > 0; --undone) ASSERT_TRUE(history.redo());
  EXPECT_EQ(history.now(), last);
}

}  // namespace
}  // namespace mirrorball
