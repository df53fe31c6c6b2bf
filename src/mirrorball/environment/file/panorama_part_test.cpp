#include "mirrorball/environment/file/panorama_part.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

/// Smooth light at the centres of the texels of a part of a panorama.
Image partOfLight(glm::ivec2 size, const PanoramaPart& part) {
  Image picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec2 inside = (glm::dvec2(x, y) + 0.5) / glm::dvec2(size);
      const glm::vec2 uv(part.begin + inside * (part.end - part.begin));
      const glm::vec3 light = testing::smoothRadiance(directionAt(Projection::equirect, {0, uv}));
      std::copy_n(&light.x, 3, picture.texel(x, y));
    }
  return picture;
}

/// The greatest difference to that light in a rectangle of a panorama.
float errorIn(const Image& panorama, glm::ivec2 begin, glm::ivec2 end) {
  float greatest = 0.0f;
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) {
      const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(panorama.width(), panorama.height());
      const glm::vec3 off = rgbAt(panorama, x, y) - testing::smoothRadiance(directionAt(Projection::equirect, {0, uv}));
      greatest = std::max(greatest, glm::length(off));
    }
  return greatest;
}

PanoramaPart named(std::string_view word) {
  const auto part = panoramaPartNamed(word);
  EXPECT_TRUE(part) << word << ": " << part.error().message;
  return part.value_or(PanoramaPart{});
}

TEST(PanoramaPart, WordsNameItInTexelsOrDegrees) {
  const PanoramaPart crop = named("crop=128,64,256,128/512x256");
  EXPECT_EQ(crop.begin, glm::dvec2(0.25, 0.25));
  EXPECT_EQ(crop.end, glm::dvec2(0.75, 0.75));
  EXPECT_EQ(textOf(crop), "180 x 90 degrees");
  const PanoramaPart strip = named("fov=360x90");
  EXPECT_EQ(strip.begin, glm::dvec2(0.0, 0.25));
  EXPECT_EQ(strip.end, glm::dvec2(1.0, 0.75));
  EXPECT_TRUE(named("fov=360x180").isWhole());
  EXPECT_TRUE(named("crop=0,0,512,256/512x256").isWhole());
}

TEST(PanoramaPart, WordsThatCannotBeMeantAreRefused) {
  for (const auto& [word, line] : std::initializer_list<std::pair<std::string_view, std::string_view>>{
           {"crop=1,2,3/512x256", "crop=X,Y,W,H/FULLWxFULLH in texels"},
           {"crop=", "crop=X,Y,W,H/FULLWxFULLH in texels"},
           {"crop=0,0,256,128", "crop=X,Y,W,H/FULLWxFULLH in texels"},
           {"crop=0,0,2.5,128/512x256", "crop=X,Y,W,H/FULLWxFULLH in texels"},
           {"crop=0,0,1e30,128/512x256", "crop=X,Y,W,H/FULLWxFULLH in texels"},
           {"crop=0,200,256,128/512x256", "is 256x128 at (0, 200), which reaches beyond a panorama of 512x256"},
           {"crop=512,0,256,128/512x256", "reaches beyond"},
           {"crop=0,0,513,128/512x256", "reaches beyond"},
           {"crop=-1,0,256,128/512x256", "reaches beyond"},
           {"crop=0,0,0,128/512x256", "a whole panorama is 2:1"},
           {"crop=0,0,16,16/512x400", "16x16 of a panorama of 512x400, and a whole panorama is 2:1"},
           {"crop=0,0,16,16/512x100", "16x16 of a panorama of 512x100, and a whole panorama is 2:1"},
           {"fov=0x90", "at most 360x180"},
           {"fov=361x90", "at most 360x180"},
           {"fov=360x181", "at most 360x180"},
           {"fov=nanx90", "at most 360x180"},
           {"fov=360", "fov=HxV in degrees"},
           {"fov=", "fov=HxV in degrees"}}) {
    const auto part = panoramaPartNamed(word);
    ASSERT_FALSE(part) << word;
    EXPECT_EQ(part.error().code, ErrorCode::usage);
    EXPECT_THAT(part.error().message, HasSubstr(std::string(line))) << word;
  }
}

TEST(PanoramaPart, TheWholeHasThePicturesDetail) {
  EXPECT_EQ(heightOfWhole({256, 128}, named("fov=180x90")), 256);
  EXPECT_EQ(heightOfWhole({4096, 1024}, named("fov=360x90")), 2048);
  EXPECT_EQ(heightOfWhole({4096, 2047}, PanoramaPart{}), 2048) << "nothing of its columns is lost";
  EXPECT_EQ(heightOfWhole({8191, 4096}, PanoramaPart{}), 4096);
  EXPECT_FALSE(heightOfWhole({4096, 900}, named("fov=360x90"))) << "another proportion";
  EXPECT_FALSE(heightOfWhole({1 << 15, 1 << 14}, named("crop=0,0,2,1/16777216x8388608"))) << "too large for an int";
}

TEST(PanoramaPart, ItMayGoOnAcrossTheSeam) {
  const PanoramaPart part = named("crop=384,64,256,128/512x256");
  EXPECT_TRUE(part.crossesSeam());
  EXPECT_EQ(part.begin, glm::dvec2(0.75, 0.25));
  EXPECT_EQ(part.end, glm::dvec2(1.25, 0.75));
  const PanoramaPart circle = named("crop=100,0,512,256/512x256");
  EXPECT_TRUE(circle.crossesSeam() && circle.showsAll() && !circle.isWhole());
  EXPECT_FALSE(named("crop=256,0,256,256/512x256").crossesSeam());
}

TEST(PanoramaPart, AWholeWiderThanTwoToOneIsAStripAboutTheHorizon) {
  const auto part = panoramaPartOfStrip({{0, 0}, {8000, 2000}, {8000, 2000}});
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_EQ(part->begin, glm::dvec2(0.0, 0.25));
  EXPECT_EQ(part->end, glm::dvec2(1.0, 0.75));
  const auto upper = panoramaPartOfStrip({{2000, 0}, {4000, 1000}, {8000, 2000}});
  EXPECT_EQ(upper->begin, glm::dvec2(0.25, 0.25));
  EXPECT_EQ(upper->end, glm::dvec2(0.75, 0.5));
  EXPECT_FALSE(panoramaPartOfStrip({{0, 0}, {512, 400}, {512, 400}})) << "narrower than 2:1";
  EXPECT_EQ(panoramaPartOfStrip({{128, 64}, {256, 128}, {512, 256}})->begin, glm::dvec2(0.25));
}

TEST(PanoramaPart, NearlyTwoToOneIsWhole) {
  for (const glm::ivec2 size : {glm::ivec2(4096, 2047), glm::ivec2(8191, 4096), glm::ivec2(4096, 2050),
                                glm::ivec2(4098, 2048), glm::ivec2(2, 1), glm::ivec2(128, 63)})
    EXPECT_TRUE(isNearlyWholePanorama(size)) << size.x << "x" << size.y;
  for (const glm::ivec2 size : {glm::ivec2(4096, 2045), glm::ivec2(12, 8), glm::ivec2(16, 7), glm::ivec2(4096, 1024),
                                glm::ivec2(0, 1), glm::ivec2(1, 1)})
    EXPECT_FALSE(isNearlyWholePanorama(size)) << size.x << "x" << size.y;
}

TEST(PanoramaPart, APictureInPlaceKeepsEveryBit) {
  Image picture(256, 128, 4);
  for (std::size_t i = 0; i < picture.samples().size(); ++i) picture.samples()[i] = -1.0f + 0.001f * float(i);
  picture.texel(7, 5)[1] = std::numeric_limits<float>::quiet_NaN();
  PictureWindow window;
  const auto whole = placedInPanorama(picture, named("crop=128,64,256,128/512x256"), window);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(window.whole, glm::ivec2(512, 256));
  EXPECT_EQ(window.corner, glm::ivec2(128, 64));
  EXPECT_EQ(window.size, glm::ivec2(256, 128));
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) {
      const bool is_inside = x >= 128 && x < 384 && y >= 64 && y < 192;
      for (int c = 0; c < 4; ++c) {
        const float expected = is_inside ? picture.texel(x - 128, y - 64)[c] : 0.0f;
        const float found = whole->texel(x, y)[c];
        ASSERT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << x << " " << y;
      }
    }
}

// A picture that was scaled after it had been cropped lies between the texels of every panorama.
TEST(PanoramaPart, AScaledPartIsWhereItsLightIs) {
  const PanoramaPart part = named("crop=1001,333,2002,1111/4096x2048");
  PictureWindow window;
  const auto whole = placedInPanorama(partOfLight({250, 139}, part), part, window);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->height(), 257);
  const glm::ivec2 begin = window.corner + 2, end = window.corner + window.size - 2;
  EXPECT_LT(errorIn(*whole, begin, end), 1e-3f);
  EXPECT_EQ(rgbAt(*whole, begin.x - 4, begin.y), glm::vec3(0.0f));
  EXPECT_EQ(rgbAt(*whole, begin.x, end.y + 4), glm::vec3(0.0f));
}

TEST(PanoramaPart, NearlyTheWholeKeepsItsLight) {
  for (const glm::ivec2 size :
       {glm::ivec2(512, 255), glm::ivec2(511, 256), glm::ivec2(514, 256), glm::ivec2(512, 258)}) {
    Image picture = partOfLight(size, PanoramaPart{});
    PictureWindow window;
    const auto smooth = placedInPanorama(picture, PanoramaPart{}, window);
    ASSERT_TRUE(smooth) << smooth.error().message;
    EXPECT_EQ(smooth->width(), 2 * smooth->height());
    EXPECT_LT(errorIn(*smooth, {0, 0}, window.whole), 2e-3f) << size.x << "x" << size.y;

    // A sun of one texel, 10⁵ times as bright as the sky.
    const glm::ivec2 sun(size.x / 3, size.y / 4);
    picture.texel(sun.x, sun.y)[0] += 1e5f;
    const auto with_sun = placedInPanorama(picture, PanoramaPart{}, window);
    const double texel = 2.0 * std::numbers::pi * std::numbers::pi / (size.x * size.y) *
                         std::sin(std::numbers::pi * (sun.y + 0.5) / size.y);
    const auto fluxOf = [](Image panorama) {
      return testing::fluxOf(EnvironmentMap(Projection::equirect, ImageSet(std::move(panorama))));
    };
    EXPECT_NEAR((fluxOf(*with_sun) - fluxOf(*smooth)) / (1e5 * texel), 1.0, 0.01) << size.x << "x" << size.y;
  }
}

TEST(PanoramaPart, WhatIsTooLargeIsRefusedBeforeItIsMade) {
  PictureWindow window;
  const auto whole = placedInPanorama(Image(2, 1, 3), named("crop=0,0,2,1/16000000x8000000"), window);
  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().code, ErrorCode::too_large);
}

TEST(PanoramaPart, ItsShareOfTheSphereIsThatOfTheZone) {
  EXPECT_NEAR(shareOfSphere({.whole = {512, 256}, .corner = {128, 64}, .size = {256, 128}}), 0.5 * std::sqrt(0.5),
              1e-9);
  EXPECT_NEAR(shareOfSphere({.whole = {512, 256}, .corner = {0, 128}, .size = {512, 128}}), 0.5, 1e-9);
  EXPECT_NEAR(shareOfSphere({.whole = {512, 256}, .corner = {-8, -4}, .size = {528, 264}}), 1.0, 1e-9) << "overscan";
  EXPECT_EQ(shareOfSphere({.whole = {512, 256}, .corner = {600, 0}, .size = {8, 8}}), 0.0) << "beside the whole";
}

// Light of one colour stays it; what varies stays between its least and its greatest; what is known stays as it is.
TEST(PanoramaPart, TheRestIsContinuedFromTheEdge) {
  const PictureWindow strip{.whole = {256, 128}, .corner = {0, 32}, .size = {256, 64}};
  Image grey(256, 128, 1);
  for (int y = 32; y < 96; ++y)
    for (int x = 0; x < 256; ++x) grey.texel(x, y)[0] = 0.5f;
  ASSERT_TRUE(fillAround(strip, grey));
  for (const float sample : grey.samples()) ASSERT_NEAR(sample, 0.5f, 1e-5f);

  Image sky(256, 128, 3);
  for (int y = 32; y < 96; ++y)
    for (int x = 0; x < 256; ++x) std::fill_n(sky.texel(x, y), 3, y < 64 ? 2.0f : 1.0f);
  const Image before = sky;
  ASSERT_TRUE(fillAround(strip, sky));
  EXPECT_GT(rgbAt(sky, 0, 0).x, 1.7f) << "the zenith has the light of the upper edge";
  EXPECT_LT(rgbAt(sky, 0, 127).x, 1.3f);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      if (y >= 32 && y < 96) ASSERT_EQ(rgbAt(sky, x, y), rgbAt(before, x, y));
      ASSERT_GE(rgbAt(sky, x, y).y, 1.0f - 1e-5f);
      ASSERT_LE(rgbAt(sky, x, y).y, 2.0f + 1e-5f);
    }
  Image dot(256, 128, 3);
  EXPECT_EQ(fillAround({.whole = {256, 128}, .corner = {9, 60}, .size = {1, 1}}, dot).error().code,
            ErrorCode::bad_shape);
}

}  // namespace
}  // namespace mirrorball
