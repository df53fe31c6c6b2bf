#include "mirrorball/trace/media.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Bodies of these priorities, instance by instance.
Scene bodiesOf(std::initializer_list<int> priorities) {
  Scene scene;
  for (const int priority : priorities) {
    const int index = static_cast<int>(scene.meshes.size());
    scene.materials.emplace_back().priority = priority;
    scene.meshes.emplace_back().material = index;
    scene.instances.push_back({.mesh = index});
  }
  return scene;
}

TEST(Media, AmongEqualsTheOneEnteredLastFillsThePlace) {
  const Scene scene = bodiesOf({0, 0});
  Media media;
  EXPECT_FALSE(media.filling(scene));
  media.enter(0);
  EXPECT_TRUE(media.hasSurface(scene, 1, true)) << "a bubble";
  media.enter(1);
  EXPECT_EQ(media.filling(scene), 1u);
  EXPECT_EQ(media.fillingWithout(scene, 1), 0u);
  EXPECT_FALSE(media.hasSurface(scene, 0, false)) << "the glass ends inside of what lies in it";
  media.leave(1);
  EXPECT_EQ(media.filling(scene), 0u);
  media.leave(0);
  EXPECT_FALSE(media.filling(scene));
}

// Water that reaches into the wall of its glass ends where the glass begins.
TEST(Media, ThePriorityDecides) {
  const Scene scene = bodiesOf({1, 0});  // glass, water
  Media media;
  media.enter(1);
  EXPECT_TRUE(media.hasSurface(scene, 0, true));
  media.enter(0);
  EXPECT_EQ(media.filling(scene), 0u);
  EXPECT_FALSE(media.hasSurface(scene, 1, false)) << "inside of the wall, the water's surface is not there";
  media.leave(1);
  EXPECT_TRUE(media.hasSurface(scene, 0, false));
  EXPECT_FALSE(media.hasSurface(scene, 1, true));
}

// Two closed parts of one mesh that overlap: only the outer surface is there.
TEST(Media, ABodyThatOverlapsItselfIsOne) {
  const Scene scene = bodiesOf({0});
  Media media;
  media.enter(0);
  EXPECT_FALSE(media.hasSurface(scene, 0, true));
  media.enter(0);
  EXPECT_FALSE(media.hasSurface(scene, 0, false));
  media.leave(0);
  EXPECT_TRUE(media.hasSurface(scene, 0, false));
}

TEST(Media, WhatWasNotEnteredIsLeftWithoutAChange) {
  const Scene scene = bodiesOf({0, 5});
  Media media;
  media.enter(0);
  media.leave(1);
  EXPECT_TRUE(media.contains(0));
  EXPECT_EQ(media.filling(scene), 0u);
  EXPECT_TRUE(media.hasSurface(scene, 1, false)) << "the back of an open mesh";
  for (std::uint32_t i = 0; i < 2 * Media::kMax; ++i) media.enter(0);
  for (std::uint32_t i = 0; i < Media::kMax; ++i) media.leave(0);
  EXPECT_FALSE(media.filling(scene)) << "no more than kMax are known";
}

}  // namespace
}  // namespace mirrorball
