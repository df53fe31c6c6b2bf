#include "mirrorball/view/map/map_picture.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/view/map/false_colors.h"
#include "mirrorball/view/map/map_testing.h"

namespace mirrorball {
namespace {

using testing::constantMap;
using testing::mapOf;
using testing::prepared;
using testing::settingsOf;
using testing::Sun;
using testing::sunAt;

const MapCanvas kSmallCanvas{{320, 180}, 12};

/// The brightest pixel of a light's picture.
glm::ivec2 brightestOf(const Image& light) {
  glm::ivec2 found(0);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x)
      if (light.texel(x, y)[0] > light.texel(found.x, found.y)[0]) found = {x, y};
  return found;
}

double sumOf(const Image& light) {
  double sum = 0.0;
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) sum += double(light.texel(x, y)[0]);
  return sum;
}

TEST(MapPicture, ASunOfOneTexelIsWhereItsDirectionIsSeen) {
  // A map much finer than the picture, and one much coarser.
  for (const int height : {1024, 64}) {
    const Sun sun = sunAt({height * 13 / 10, height * 3 / 10}, height, 1e5f);
    const PreparedMap map = prepared(sun.map);
    for (std::size_t kind = 0; kind < Projection::kKinds; ++kind) {
      const MapViewSettings settings = settingsOf(static_cast<Projection::Kind>(kind));
      const auto pixels = pixelsOf(settings, kSmallCanvas, sun.direction);
      ASSERT_EQ(pixels.size(), 1u) << kind;
      const Image light = *mapLight(map, settings, kSmallCanvas);
      EXPECT_LT(glm::distance(glm::vec2(brightestOf(light)) + 0.5f, pixels[0]), 2.0f)
          << nameOf(settings.projection) << " of " << height;
    }
  }
}

TEST(MapPicture, IsWhatTheConverterMakesOfAMap) {
  const Sun sun = sunAt({20, 10}, 32, 1e5f);
  const PreparedMap map = prepared(sun.map);
  for (std::size_t kind = 0; kind < Projection::kKinds; ++kind) {
    const MapViewSettings settings = settingsOf(static_cast<Projection::Kind>(kind));
    const Projection projection = projectionOf(settings, settings.projection);
    const Image light = *mapLight(map, settings, kSmallCanvas);
    const MapLayout layout = mapLayout(settings, kSmallCanvas);
    const EnvironmentMap wanted = *convert(*map.given, projection, layout.panes[0].place.extent.y);
    for (const MapPane& pane : layout.panes)
      for (int y = 0; y < pane.place.extent.y; ++y)
        for (int x = 0; x < pane.place.extent.x; ++x)
          ASSERT_EQ(rgbAt(light, pane.place.corner.x + x, pane.place.corner.y + y), rgbAt(wanted.face(pane.face), x, y))
              << nameOf(projection) << " face " << pane.face << " at " << x << ", " << y;
  }
}

TEST(MapPicture, FromInsideASunKeepsItsPlaceAndItsLight) {
  MapViewSettings settings;
  settings.page = MapPage::inside;
  for (const int height : {1024, 64}) {
    const Sun sun = sunAt({height * 9 / 10, height * 4 / 10}, height, 1e5f);
    const PreparedMap map = prepared(sun.map);
    const auto pixels = pixelsOf(settings, kSmallCanvas, sun.direction);
    ASSERT_EQ(pixels.size(), 1u);
    const Image light = *mapLight(map, settings, kSmallCanvas);
    EXPECT_LT(glm::distance(glm::vec2(brightestOf(light)) + 0.5f, pixels[0]), 2.0f + 120.0f / float(height));
    // ∫ over the picture's plane: a solid angle is stretched there by 1 / cos³ of the angle from its middle.
    const MapEye eye = mapEye(settings, *mapLayout(settings, kSmallCanvas).inside);
    const float cosine = glm::dot(sun.direction, eye.world_from_eye[2]);
    const double flux = 1e5 * M_PI / height * M_PI / height * std::sqrt(1.0 - std::pow(sun.direction.y, 2));
    const double wanted = flux * std::pow(eye.focal_px, 2) / std::pow(cosine, 3);
    EXPECT_NEAR(sumOf(light) / wanted, 1.0, 0.06) << height;
  }
}

TEST(MapPicture, ShowsWhatADisplayShowsAndPaperBesideIt) {
  const glm::vec3 radiance(0.3f, 1.0f, 4.0f);
  const PreparedMap map = prepared(constantMap(Projection::cube, 8, radiance));
  MapViewSettings settings = settingsOf(Projection::sphere);
  settings.display = {-1.0f, ToneMap::aces};
  const Image8 picture = *MapViewer(map).picture(settings, kSmallCanvas);
  ASSERT_EQ(picture.channels(), 4);
  const glm::vec4 wanted = formula::displayed(glm::vec4(radiance, 1.0f), 0.5f, int(ToneMap::aces));
  for (int channel = 0; channel < 4; ++channel)
    EXPECT_NEAR(picture.texel(160, 90)[channel], 255.0f * wanted[channel], 1.01f);
  EXPECT_EQ(picture.texel(0, 0)[0], 28);
  EXPECT_EQ(picture.texel(0, 0)[3], 255);
}

TEST(MapPicture, EachLightOfAConstantMapIsThatLight) {
  const glm::vec3 radiance(0.5f, 2.0f, 7.0f);
  const PreparedMap map = prepared(constantMap(Projection::equirect, 16, radiance));
  for (int light = 0; light <= int(MapLight::harmonics); ++light)
    for (const float roughness : {0.0f, 0.1f, 0.77f, 1.0f}) {
      MapViewSettings settings = settingsOf(Projection::octahedral);
      settings.light = static_cast<MapLight>(light);
      settings.perceptual_roughness = roughness;
      settings.level = 20;
      settings.degree = 4;
      const Image shown = *mapLight(map, settings, kSmallCanvas);
      const glm::vec3 middle = rgbAt(shown, 160, 90);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(middle[channel], radiance[channel], 2e-3f * radiance[channel]) << light << " at " << roughness;
      EXPECT_NEAR(glm::distance(shownRadiance(map, settings, {0.0f, 0.6f, 0.8f}), radiance), 0.0f, 0.02f);
    }
}

TEST(MapPicture, FalseColorsAreTheLegendsAndGrowLighterWithTheLight) {
  MapViewSettings settings = settingsOf(Projection::equirect);
  settings.false_colors = true;
  settings.stops = 6.0f;
  settings.display.exposure_ev = 1.0f;
  const MapLayout layout = mapLayout(settings, kSmallCanvas);
  ASSERT_TRUE(layout.legend);
  EXPECT_EQ(layout.labels.front().text, "-6");
  EXPECT_EQ(layout.labels.back().text, "+6");
  float before = -1.0f;
  for (int stops = -7; stops <= 5; stops += 2) {
    const PreparedMap map = prepared(constantMap(Projection::cube, 4, glm::vec3(std::exp2(float(stops)))));
    const Image8 picture = *MapViewer(map).picture(settings, kSmallCanvas);
    const std::uint8_t* shown = picture.texel(layout.panes[0].place.corner.x + 5, layout.panes[0].place.corner.y + 5);
    const float share = (float(stops + 1) / settings.stops + 1.0f) / 2.0f;
    const int column = std::min(int(share * float(layout.legend->extent.x)), layout.legend->extent.x - 1);
    const std::uint8_t* told = picture.texel(layout.legend->corner.x + column, layout.legend->corner.y);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(shown[channel], told[channel], 3) << stops;
    const float lightness = formula::luminance(glm::vec3(shown[0], shown[1], shown[2]));
    EXPECT_GT(lightness, before) << stops;
    before = lightness;
  }
}

TEST(MapPicture, FalseColorsOfNoLightAreTheDarkest) {
  const auto darkest = falseColor(-8.0f, 8.0f);
  EXPECT_EQ(falseColor(stopsOf(glm::vec3(0.0f), 0.0f), 8.0f), darkest);
  EXPECT_EQ(falseColor(stopsOf(glm::vec3(-1.0f), 0.0f), 8.0f), darkest);
  EXPECT_EQ(falseColor(stopsOf(glm::vec3(NAN), 0.0f), 8.0f), darkest);
  EXPECT_EQ(falseColor(stopsOf(glm::vec3(INFINITY), 0.0f), 8.0f), falseColor(8.0f, 8.0f));
}

bool hasColor(const Image8& picture, glm::ivec2 middle, int reach, glm::ivec3 color) {
  for (int y = std::max(middle.y - reach, 0); y <= std::min(middle.y + reach, picture.height() - 1); ++y)
    for (int x = std::max(middle.x - reach, 0); x <= std::min(middle.x + reach, picture.width() - 1); ++x) {
      const std::uint8_t* texel = picture.texel(x, y);
      if (glm::ivec3(texel[0], texel[1], texel[2]) == color) return true;
    }
  return false;
}

TEST(MapPicture, BadTexelsAreMarkedInEveryProjectionAndLampsRinged) {
  Sun sun = sunAt({60, 20}, 64, 1e5f);
  sun.map.face(0).texel(90, 40)[1] = NAN;
  const glm::vec3 bad = directionAt(Projection::equirect, {0, {90.5f / 128.0f, 40.5f / 64.0f}});
  MapViewer viewer(prepared(sun.map));
  MapViewSettings settings;
  settings.marks_lamps = true;
  const MapCanvas canvas{{1280, 720}, 16};
  const Image8 picture = *viewer.picture(settings, canvas);
  for (const glm::vec2 pixel : pixelsOf(settings, canvas, bad))
    EXPECT_TRUE(hasColor(picture, pixel, 2, {255, 0, 255})) << pixel.x << ", " << pixel.y;
  for (const glm::vec2 pixel : pixelsOf(settings, canvas, sun.direction))
    EXPECT_TRUE(hasColor(picture, pixel, 20, {0, 200, 255})) << pixel.x << ", " << pixel.y;
  settings.marks_lamps = settings.marks_bad = false;
  const Image8 unmarked = *viewer.picture(settings, canvas);
  EXPECT_FALSE(hasColor(unmarked, {640, 360}, 1280, {255, 0, 255}));
  EXPECT_FALSE(hasColor(unmarked, {640, 360}, 1280, {0, 200, 255}));
}

TEST(MapPicture, TheWaveformShowsEachColumnsStops) {
  // The left half of the panorama is at 2 stops, the right half at −3.
  const EnvironmentMap halves =
      mapOf(Projection::equirect, 64, [](glm::vec3 d) { return glm::vec3(d.x > 0.0f ? 4.0f : 0.125f); });
  MapViewSettings settings = settingsOf(Projection::equirect);
  settings.waveform = true;
  settings.stops = 5.0f;
  const PreparedMap map = prepared(halves);
  EXPECT_NEAR(map.waveform.share(20, 25, 1.9f, 2.2f), 1.0f, 1e-3f);
  EXPECT_NEAR(map.waveform.share(100, 105, -3.1f, -2.8f), 1.0f, 1e-3f);
  EXPECT_NEAR(map.waveform.share(100, 105, 0.0f, 30.0f), 0.0f, 1e-3f);
  const Image8 picture = *MapViewer(map).picture(settings, kSmallCanvas);
  const PixelRectangle place = *mapLayout(settings, kSmallCanvas).waveform;
  const auto rowOf = [&](float stops) {
    return place.corner.y + int((settings.stops - stops) / (2.0f * settings.stops) * float(place.extent.y));
  };
  const int left = place.corner.x + place.extent.x / 4;
  const int right = place.corner.x + 3 * place.extent.x / 4;
  EXPECT_GT(picture.texel(left, rowOf(2.06f))[1], 200);
  EXPECT_LT(picture.texel(left, rowOf(-2.94f))[1], 100);
  EXPECT_GT(picture.texel(right, rowOf(-2.94f))[1], 200);
  EXPECT_LT(picture.texel(right, rowOf(2.06f))[1], 100);
}

TEST(MapPicture, OnlyWhatChangesTheLightMakesItAnew) {
  MapViewSettings shown;
  MapViewSettings other = shown;
  other.display.exposure_ev = 3.0f;
  other.display.tone_map = ToneMap::agx;
  other.marks_lamps = true;
  EXPECT_TRUE(haveSameLight(shown, other));
  other.light = MapLight::harmonics;
  EXPECT_FALSE(haveSameLight(shown, other));
  // The viewer's second picture is that of a new one.
  const PreparedMap map = prepared(sunAt({60, 20}, 64, 1e5f).map);
  MapViewer viewer(map);
  ASSERT_TRUE(viewer.picture(shown, kSmallCanvas));
  const Image8 second = *viewer.picture(other, kSmallCanvas);
  const Image8 afresh = *MapViewer(map).picture(other, kSmallCanvas);
  EXPECT_TRUE(std::equal(second.samples().begin(), second.samples().end(), afresh.samples().begin()));
}

TEST(MapPicture, CanBeStopped) {
  const PreparedMap map = prepared(constantMap(Projection::cube, 4, glm::vec3(1.0f)));
  const ProgressFunction stop = [](std::size_t, std::size_t) { return false; };
  for (const MapPage page : {MapPage::all, MapPage::inside, MapPage::one}) {
    MapViewSettings settings;
    settings.page = page;
    const auto light = mapLight(map, settings, kSmallCanvas, stop);
    ASSERT_FALSE(light);
    EXPECT_EQ(light.error().code, ErrorCode::interrupted);
  }
}

TEST(MapPicture, ShowsThePhotographThatAMapIsUnwrappedFrom) {
  PreparedMap map = prepared(constantMap(Projection::equirect, 16, glm::vec3(0.25f)));
  const MapCanvas canvas{.size_px = {320, 180}, .photograph_px = {40, 30}};
  Image photograph(40, 30, 3, 1.0f);
  for (int y = 0; y < 30; ++y) std::fill_n(photograph.texel(0, y), 3 * 20, 3.0f);
  map.photograph = std::make_shared<const Image>(photograph);
  const PixelRectangle place = *mapLayout({}, canvas).photograph;
  const Image light = *mapLight(map, {}, canvas);
  const auto at = [&](float x, float y) {
    const glm::ivec2 pixel = glm::vec2(place.corner) + glm::vec2(x, y) * glm::vec2(place.extent);
    return glm::vec2(light.texel(pixel.x, pixel.y)[1], light.texel(pixel.x, pixel.y)[3]);
  };
  EXPECT_EQ(at(0.1f, 0.1f), glm::vec2(3.0f, 1.0f));
  EXPECT_EQ(at(0.9f, 0.9f), glm::vec2(1.0f, 1.0f));
  EXPECT_EQ(at(0.5f, -0.02f), glm::vec2(0.0f)) << "above it";
}

}  // namespace
}  // namespace mirrorball
