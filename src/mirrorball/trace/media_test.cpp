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
}

TEST(Media, OfMoreThanEightTheFirstAreKnown) {
  Media media;
  for (int body = 0; body < 20; ++body) media = entered(media, body, 0);
  EXPECT_EQ(fillingBody(media), 7);
  EXPECT_EQ(timesEntered(media, 8), 0);
  for (int body = 0; body < 8; ++body) media = left(media, body);
  EXPECT_FALSE(isWithinBody(media));
}

TEST(Media, BodiesAreLeftInAnyOrder) {
  Media media;
  for (int body = 0; body < 8; ++body) media = entered(media, body, 0);
  for (const int body : {3, 7, 0, 5, 4}) media = left(media, body);
  EXPECT_EQ(fillingBody(media), 6);
  EXPECT_EQ(fillingBody(left(media, 6)), 2);
  EXPECT_EQ(fillingBody(left(left(media, 6), 2)), 1);
  EXPECT_EQ(fillingBody(left(entered(entered(media, 6, 0), 9, 0), 6)), 9) << "one of the two times";
}

TEST(Media, PrioritiesAndNumbersAreKnownToTheirEnds) {
  const int last = int(kBodyBits) - 1;
  const Media media = entered(entered(Media(), last, -kGreatestPriority), 5, kGreatestPriority);
  EXPECT_EQ(fillingBody(media), 5);
  EXPECT_EQ(fillingBody(left(media, 5)), last);
  EXPECT_FALSE(hasSurface(media, 6, kGreatestPriority - 1, true));
  EXPECT_TRUE(hasSurface(media, 6, kGreatestPriority, true));
  EXPECT_TRUE(hasSurface(left(media, 5), 6, -kGreatestPriority, true));
  EXPECT_EQ(fillingBody(entered(entered(Media(), 0, 2000), 1, 0)), 0) << "as the greatest";
  EXPECT_TRUE(hasSurface(media, 6, 2000, true));
  EXPECT_FALSE(isWithinBody(entered(Media(), last + 1, 0))) << "too great a number for a word";
}

}  // namespace
}  // namespace mirrorball::formula
