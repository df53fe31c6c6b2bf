// formula/bodies/media.glsl: which body fills a place, and which surfaces are there.

#include <gtest/gtest.h>

#include "formula/bodies.h"

namespace mirrorball::formula {
namespace {

TEST(Media, AmongEqualsTheOneEnteredLastFillsThePlace) {
  Media media;
  EXPECT_EQ(fillingBody(media), -1);
  media = entered(media, 0, 0);
  EXPECT_TRUE(hasSurface(media, 1, 0, true)) << "a bubble";
  media = entered(media, 1, 0);
  EXPECT_EQ(fillingBody(media), 1);
  EXPECT_EQ(fillingBody(left(media, 1)), 0);
  EXPECT_FALSE(hasSurface(media, 0, 0, false)) << "the glass ends inside of what lies in it";
  media = left(media, 1);
  EXPECT_EQ(fillingBody(media), 0);
  EXPECT_EQ(fillingBody(left(media, 0)), -1);
}

// Water that reaches into the wall of its glass ends where the glass begins.
TEST(Media, ThePriorityDecides) {
  const int glass = 0, of_glass = 1, water = 1, of_water = 0;
  Media media = entered(Media(), water, of_water);
  EXPECT_TRUE(hasSurface(media, glass, of_glass, true));
  media = entered(media, glass, of_glass);
  EXPECT_EQ(fillingBody(media), glass);
  EXPECT_FALSE(hasSurface(media, water, of_water, false)) << "inside of the wall, the water's surface is not there";
  media = left(media, water);
  EXPECT_TRUE(hasSurface(media, glass, of_glass, false));
  EXPECT_FALSE(hasSurface(media, water, of_water, true));
}

// Two closed parts of one mesh that overlap: only the outer surface is there.
TEST(Media, ABodyThatOverlapsItselfIsOne) {
  Media media = entered(Media(), 0, 0);
  EXPECT_FALSE(hasSurface(media, 0, 0, true));
  media = entered(media, 0, 0);
  EXPECT_EQ(timesEntered(media, 0), 2);
  EXPECT_FALSE(hasSurface(media, 0, 0, false));
  EXPECT_TRUE(hasSurface(left(media, 0), 0, 0, false));
}

TEST(Media, WhatWasNotEnteredIsLeftWithoutAChange) {
  Media media = left(entered(Media(), 0, 0), 1);
  EXPECT_EQ(timesEntered(media, 0), 1);
  EXPECT_EQ(fillingBody(media), 0);
  EXPECT_TRUE(hasSurface(media, 1, 5, false)) << "the back of an open mesh";
  for (int i = 0; i < 2 * kMaxMedia; ++i) media = entered(media, 0, 0);
  for (int i = 0; i < kMaxMedia; ++i) media = left(media, 0);
  EXPECT_EQ(fillingBody(media), -1) << "no more than kMaxMedia are known";
}

}  // namespace
}  // namespace mirrorball::formula
