#include "mirrorball/environment/file/picture_content.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/image/resize.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Sky above ground, with a sun and hills: what most panoramas show.
glm::vec3 landscape(glm::vec3 d) {
  const float hill = 0.1f * std::sin(5.0f * std::atan2(d.x, d.z));
  const float sun = glm::dot(d, glm::normalize(glm::vec3(0.5f, 0.4f, -0.7f))) > 0.995f ? 50.0f : 0.0f;
  const glm::vec3 ground = glm::vec3(0.2f, 0.12f, 0.05f) * (1.2f + std::sin(20.0f * d.x) * std::cos(17.0f * d.z));
  return d.y > hill ? glm::vec3(0.3f, 0.5f, 0.9f) * (1.5f - d.y) + sun : ground;
}

/// A picture of that light, by default, in a projection.
Image pictureOfLight(Projection projection, int size, const RadianceFunction& light = landscape) {
  return pictureOf(*convert(Environment(light, 64), projection, size), {projection, CubeLayout::hcross});
}

/// A picture of one light above or beside another of the same size.
Image joined(const Image& first, const Image& second, bool is_above) {
  const glm::ivec2 size(first.width(), first.height());
  const glm::ivec2 step = is_above ? glm::ivec2(0, size.y) : glm::ivec2(size.x, 0);
  Image both(size.x + step.x, size.y + step.y, 3);
  for (int y = 0; y < size.y; ++y) {
    std::copy_n(first.texel(0, y), 3 * size.x, both.texel(0, y));
    std::copy_n(second.texel(0, y), 3 * size.x, both.texel(step.x, y + step.y));
  }
  return both;
}

/// What the other of two eyes sees: everything a degree further to the right, the ground by three.
glm::vec3 seenByOtherEye(glm::vec3 d) {
  const float angle = glm::radians(d.y < 0.0f ? 3.0f : 1.0f);
  return landscape({std::cos(angle) * d.x + std::sin(angle) * d.z, d.y, std::cos(angle) * d.z - std::sin(angle) * d.x});
}

/// Light in the rows of a panorama between two shares of its height, black in the others.
Image stripOnBlack(float begin, float end) {
  Image picture = pictureOfLight(Projection::equirect, 128);
  for (int y = 0; y < 128; ++y)
    if (const float share = (float(y) + 0.5f) / 128.0f; share < begin || share > end)
      std::fill_n(picture.texel(0, y), 3 * 256, 0.0f);
  return picture;
}

/// A picture whose light is a function of the place, of both coordinates from -1 to 1.
Image painted(glm::ivec2 size, const std::function<float(glm::vec2)>& light) {
  Image picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec2 place = 2.0f * (glm::vec2(x, y) + 0.5f) / glm::vec2(size) - 1.0f;
      std::fill_n(picture.texel(x, y), 3, light(place));
    }
  return picture;
}

/// The reflection in a ball of a radius, before a wall.
Image ballBefore(float radius, const std::function<float(glm::vec2)>& wall) {
  return painted(glm::ivec2(256), [&](glm::vec2 p) {
    return glm::dot(p, p) < radius * radius ? 0.5f + 0.35f * p.x + 0.3f * std::sin(5.0f * p.y) : wall(p);
  });
}

TEST(PictureContent, ADiscOnBlackIsSeen) {
  for (const Projection projection : {Projection::sphere, Projection::angular, Projection::ball})
    EXPECT_TRUE(showsDisc(pictureOfLight(projection, 128))) << testing::testName(projection);
  Image noisy = pictureOfLight(Projection::sphere, 128);
  for (float& sample : noisy.samples()) sample += 0.001f;
  EXPECT_TRUE(showsDisc(noisy)) << "a camera's black";
  for (const Projection projection : {Projection::octahedral, Projection::equal_area, Projection::hemioctahedral})
    EXPECT_FALSE(showsDisc(pictureOfLight(projection, 128))) << testing::testName(projection);
  EXPECT_FALSE(showsDisc(Image(64, 64, 3)));
  EXPECT_FALSE(showsDisc(Image(64, 64, 3, 1.0f)));
  EXPECT_FALSE(showsDisc(Image(1, 1, 3, 1.0f)));
}

TEST(PictureContent, TwoDiscsAreNoPanorama) {
  EXPECT_TRUE(showsTwoDiscs(pictureOfLight(Projection::paraboloid, 128)));
  EXPECT_FALSE(showsTwoDiscs(pictureOfLight(Projection::equirect, 128)));
  for (const float margin : {0.1f, 0.2f, 0.25f, 0.3f, 0.4f})
    EXPECT_FALSE(showsTwoDiscs(stripOnBlack(margin, 1.0f - margin))) << margin;
  EXPECT_FALSE(showsTwoDiscs(stripOnBlack(0.5f, 1.0f)));
  EXPECT_FALSE(showsTwoDiscs(Image(2, 1, 3, 1.0f)));
}

TEST(PictureContent, OnlyAnUnfoldedOctahedronFoldsAtItsEdges) {
  for (const Projection projection : {Projection::octahedral, Projection::equal_area})
    EXPECT_TRUE(foldsAtEdges(pictureOfLight(projection, 256))) << testing::testName(projection);
  for (const Projection projection : {Projection::sphere, Projection::angular, Projection::hemioctahedral})
    EXPECT_FALSE(foldsAtEdges(pictureOfLight(projection, 256))) << testing::testName(projection);
  EXPECT_FALSE(foldsAtEdges(convert(Environment(landscape, 64), Projection::cube, 128)->face(4)));
  EXPECT_FALSE(foldsAtEdges(Image(64, 64, 3, 1.0f))) << "one colour shows nothing";
  // Of foliage neighbouring texels differ.
  const auto garden = [](glm::vec3 d) {
    const float towards = 1.2f + d.x + 0.7f * d.z;
    return glm::vec3(towards * (1.0f + 0.5f * std::sin(48.0f * d.x) + 0.45f * std::cos(45.0f * d.z)));
  };
  EXPECT_TRUE(foldsAtEdges(pictureOfLight(Projection::equal_area, 256, garden)));
}

// What is symmetrical about its middle folds too, and its edges are alike.
TEST(PictureContent, BallsBeforeWallsAndOrnamentsAreNoOctahedra) {
  const auto vignette = [](glm::vec2 p) { return 0.8f / std::pow(1.0f + 0.35f * glm::dot(p, p), 2.0f); };
  for (const float radius : {0.6f, 0.95f, 1.0f, 1.005f}) {
    EXPECT_FALSE(foldsAtEdges(ballBefore(radius, vignette))) << radius;
    const auto lit_from_left = [&](glm::vec2 p) { return vignette(p) * (1.0f - 0.03f * p.x); };
    EXPECT_FALSE(foldsAtEdges(ballBefore(radius, lit_from_left))) << radius;
    EXPECT_FALSE(foldsAtEdges(ballBefore(radius, [](glm::vec2 p) { return 1.5f - glm::length(p); }))) << radius;
  }
  const auto continued = [](glm::vec2 p) { return 0.5f + 0.3f * std::cos(4.0f * std::atan2(p.y, p.x)); };
  EXPECT_FALSE(foldsAtEdges(ballBefore(0.9f, continued)));
  const auto ornament = [](glm::vec2 p) { return 0.5f + 0.2f * std::cos(9.0f * p.x) + 0.25f * std::cos(5.0f * p.y); };
  EXPECT_FALSE(foldsAtEdges(painted(glm::ivec2(256), ornament)));
}

TEST(PictureContent, APanoramaThatShowsTheSameTwiceIsNoPictureForTwoEyes) {
  const auto isRemarked = [](const Image& picture) {
    Recognition recognition = *recognize(picture.width(), picture.height(), {});
    const auto doubt = settleByContent(picture, recognition);
    EXPECT_TRUE(doubt) << doubt.error().message;
    return doubt && !doubt->message.empty();
  };
  EXPECT_FALSE(isRemarked(painted({256, 128}, [](glm::vec2 p) { return 0.5f - 0.4f * p.y; }))) << "an even sky";
  EXPECT_FALSE(isRemarked(painted({256, 128}, [](glm::vec2 p) {
    return glm::distance(p, glm::vec2(-0.6f, -0.5f)) < 0.12f ? 1.0f : p.y < 0.0f ? 0.6f : 0.2f;
  }))) << "a balloon in an even sky";
  const float turn = glm::pi<float>();
  for (const float times : {2.0f, 4.0f, 6.0f})
    EXPECT_FALSE(isRemarked(painted({256, 128}, [&](glm::vec2 p) {
      return 0.5f - 0.3f * p.y + 0.15f * std::cos(times * turn * p.x) * std::cos(p.y);
    }))) << times;
  const auto eye = [](float darkest) {
    return [=](glm::vec2 p) {
      const float x = 2.0f * (p.x < 0.0f ? p.x + 0.5f : p.x - 0.5f);
      return std::abs(x) > darkest ? 0.0f : 0.5f - 0.3f * p.y + 0.15f * std::sin(2.0f * x);
    };
  };
  EXPECT_TRUE(isRemarked(painted({256, 128}, eye(2.0f))));
  EXPECT_TRUE(isRemarked(painted({256, 128}, eye(0.9f)))) << "black at its edges";
}

TEST(PictureContent, TwoEyesAreNearlyEqual) {
  const Image left = pictureOfLight(Projection::equirect, 256);
  const Image right = pictureOfLight(Projection::equirect, 256, seenByOtherEye);
  EXPECT_EQ(equalHalves(joined(left, right, true)), PictureHalf::top);
  EXPECT_EQ(equalHalves(joined(left, right, false)), PictureHalf::left);
  EXPECT_EQ(equalHalves(joined(left, pictureOfLight(Projection::equirect, 256, testing::waves), true)), std::nullopt);
  for (const Projection projection : {Projection::sphere, Projection::angular, Projection::octahedral,
                                      Projection::equal_area, Projection::hemioctahedral})
    EXPECT_EQ(equalHalves(pictureOfLight(projection, 256)), std::nullopt) << testing::testName(projection);
  Image stripes(256, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) std::fill_n(stripes.texel(x, y), 3, 0.5f + 0.4f * std::sin(0.1f * float(x)));
  EXPECT_EQ(equalHalves(stripes), std::nullopt) << "as equal as any two parts of it";
  EXPECT_EQ(equalHalves(Image(256, 256, 3, 1.0f)), std::nullopt);
  EXPECT_EQ(equalHalves(Image(4, 1, 3, 1.0f)), std::nullopt);
}

TEST(PictureContent, APhotographFillsTheCellsThatACrossLeavesEmpty) {
  const EnvironmentMap cube = *convert(Environment(landscape, 64), Projection::cube, 64);
  for (const CubeLayout layout : {CubeLayout::hcross, CubeLayout::vcross, CubeLayout::lecture}) {
    Image cross = pictureOf(cube, {Projection::cube, layout});
    const CubeLayout shape = layout == CubeLayout::lecture ? CubeLayout::hcross : layout;
    EXPECT_FALSE(fillsEmptyCells(cross, shape)) << int(layout);
    for (float& sample : cross.samples()) sample = sample == 0.0f ? 1.0f : sample;
    EXPECT_FALSE(fillsEmptyCells(cross, shape)) << int(layout) << " on white";
  }
  EXPECT_TRUE(
      fillsEmptyCells(resized(pictureOfLight(Projection::hemioctahedral, 192), {256, 192}), CubeLayout::hcross));
  EXPECT_TRUE(
      fillsEmptyCells(resized(pictureOfLight(Projection::hemioctahedral, 192), {144, 192}), CubeLayout::vcross));
  EXPECT_FALSE(fillsEmptyCells(resized(pictureOfLight(Projection::hemioctahedral, 48), {16, 12}), CubeLayout::hcross))
      << "too small to show it";
  EXPECT_FALSE(fillsEmptyCells(Image(192, 128, 3, 1.0f), CubeLayout::tiles)) << "it leaves none empty";
}

TEST(PictureContent, WhatAShapeLeavesOpenIsSettledOrRemarked) {
  const auto settled = [](const Image& picture, Recognition& recognition) {
    recognition = *recognize(picture.width(), picture.height(), {});
    const auto doubt = settleByContent(picture, recognition);
    EXPECT_TRUE(doubt) << doubt.error().message;
    return doubt.value_or(FormDoubt{});
  };
  Recognition recognition;
  EXPECT_THAT(settled(pictureOfLight(Projection::sphere, 128), recognition).other_forms,
              ElementsAre("angular", "ball"));
  EXPECT_EQ(recognition.form.projection, Projection::sphere);
  EXPECT_THAT(settled(pictureOfLight(Projection::equal_area, 256), recognition).other_forms,
              ElementsAre("octahedral", "sphere"));
  EXPECT_EQ(recognition.form.projection, Projection::equal_area);
  EXPECT_EQ(recognition.told_by, "its shape, 1:1, and how its edges fold");
  const FormDoubt face = settled(convert(Environment(landscape, 64), Projection::cube, 128)->face(4), recognition);
  EXPECT_THAT(face.message, HasSubstr("with light in its corners"));
  EXPECT_THAT(face.other_forms, ElementsAre("angular", "ball", "equal-area", "octahedral"));
  EXPECT_EQ(recognition.form.projection, Projection::sphere);
  EXPECT_EQ(settled(Image(64, 64, 3, 0.5f), recognition).message, "") << "the same light in every form";
  EXPECT_EQ(settled(pictureOfLight(Projection::equirect, 128), recognition).message, "");
  const Image front = convert(Environment(landscape, 64), Projection::cube, 128)->face(4);
  EXPECT_THAT(settled(joined(front, front, false), recognition).other_forms,
              ElementsAre("equirect:eye=left,fov=180x180"));
  recognition = *recognize(256, 128, {});
  const auto refused = settleByContent(pictureOfLight(Projection::paraboloid, 128), recognition);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_shape);
  EXPECT_THAT(refused.error().message, HasSubstr("shows two discs on black"));
  recognition = *recognize(256, 128, {}, *formHintNamed("equirect"));
  EXPECT_TRUE(settleByContent(pictureOfLight(Projection::paraboloid, 128), recognition)) << "who names it knows better";
}

}  // namespace
}  // namespace mirrorball
