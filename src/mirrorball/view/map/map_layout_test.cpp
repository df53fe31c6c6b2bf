#include "mirrorball/view/map/map_layout.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/option_control.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/view/map/map_hand.h"
#include "mirrorball/view/map/map_testing.h"

namespace mirrorball {
namespace {

using testing::manyDirections;
using testing::settingsOf;
using ::testing::SizeIs;

const MapCanvas kLayoutCanvas{{640, 360}, 16};

std::vector<MapViewSettings> everyPage() {
  std::vector<MapViewSettings> pages(2);
  pages[0].page = MapPage::all;
  pages[1].page = MapPage::inside;
  pages[1].yaw_deg = 123.0f;
  pages[1].pitch_deg = -40.0f;
  for (std::size_t kind = 0; kind < Projection::kKinds; ++kind)
    pages.push_back(settingsOf(static_cast<Projection::Kind>(kind)));
  return pages;
}

std::string pageName(const MapViewSettings& settings) { return written(mapViewOptions()[0], settings); }

TEST(MapLayout, EveryPixelThatShowsADirectionIsWhereThatDirectionIsSeen) {
  for (const MapViewSettings& settings : everyPage()) {
    int shown = 0;
    for (int y = 0; y < kLayoutCanvas.size_px.y; y += 3)
      for (int x = 0; x < kLayoutCanvas.size_px.x; x += 3) {
        const glm::vec2 pixel = glm::vec2(x, y) + 0.5f;
        const auto direction = directionAtPixel(settings, kLayoutCanvas, pixel);
        if (!direction) continue;
        ++shown;
        EXPECT_NEAR(glm::length(*direction), 1.0f, 1e-5f);
        float nearest = 1e9f;
        for (const glm::vec2 found : pixelsOf(settings, kLayoutCanvas, *direction))
          nearest = std::min(nearest, glm::distance(found, pixel));
        EXPECT_LT(nearest, 0.05f) << pageName(settings) << " at " << x << ", " << y;
      }
    EXPECT_GT(shown, 8000) << pageName(settings);
  }
}

TEST(MapLayout, EveryDirectionIsSeenOnceInEachProjectionThatCoversIt) {
  for (const MapViewSettings& settings : everyPage()) {
    if (settings.page != MapPage::one) continue;
    const Projection projection = projectionOf(settings, settings.projection);
    for (const glm::vec3 direction : manyDirections(500)) {
      const auto pixels = pixelsOf(settings, kLayoutCanvas, direction);
      ASSERT_THAT(pixels, SizeIs(covers(projection, direction) ? 1 : 0)) << pageName(settings);
      if (pixels.empty()) continue;
      const auto back = directionAtPixel(settings, kLayoutCanvas, pixels[0]);
      EXPECT_TRUE(!back || glm::dot(*back, direction) > 0.999f) << pageName(settings);
    }
  }
  MapViewSettings all;
  EXPECT_THAT(pixelsOf(all, kLayoutCanvas, {0.0f, 0.0f, 1.0f}), SizeIs(Projection::kKinds));
}

TEST(MapLayout, TheSheetHasEveryProjectionWithItsNameAndNothingTwice) {
  const MapLayout layout = mapLayout(MapViewSettings(), kLayoutCanvas);
  constexpr std::size_t kTooLong = 2;  // names that are wider than their maps
  ASSERT_THAT(layout.labels, SizeIs(Projection::kKinds - kTooLong));
  EXPECT_THAT(layout.panes, SizeIs(Projection::kKinds + 5 + 5 + 1));
  std::vector<int> taken(std::size_t(kLayoutCanvas.size_px.x * kLayoutCanvas.size_px.y), 0);
  for (const MapPane& pane : layout.panes)
    for (int y = 0; y < pane.place.extent.y; ++y)
      for (int x = 0; x < pane.place.extent.x; ++x) {
        const glm::ivec2 pixel = pane.place.corner + glm::ivec2(x, y);
        ASSERT_TRUE((PixelRectangle{glm::ivec2(0), kLayoutCanvas.size_px}.holds(pixel)));
        ++taken[std::size_t(pixel.y * kLayoutCanvas.size_px.x + pixel.x)];
      }
  EXPECT_EQ(*std::max_element(taken.begin(), taken.end()), 1);
  for (const MapLabel& label : layout.labels)
    for (int y = 0; y < kLayoutCanvas.line_px; ++y)
      EXPECT_EQ(paneAt(layout, glm::vec2(label.corner + glm::ivec2(0, y))), nullptr) << label.text;
}

TEST(MapLayout, LabelsDoNotLieOnEachOther) {
  for (const int width : {160, 240, 320, 640, 1280}) {
    MapCanvas canvas{.size_px = {width, width / 2}};
    const std::vector<MapLabel> labels = mapLayout(MapViewSettings(), canvas).labels;
    for (const MapLabel& a : labels)
      for (const MapLabel& b : labels) {
        const int ends = a.corner.x + static_cast<int>(a.text.size()) * canvas.line_px / 2;
        EXPECT_FALSE(a.corner.y == b.corner.y && a.corner.x < b.corner.x && ends > b.corner.x)
            << a.text << " on " << b.text << " at " << width;
      }
    EXPECT_EQ(labels.size() == Projection::kKinds, width == 1280) << width;
  }
}

TEST(MapLayout, WhatHasNoRoomIsLeftOut) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 900), glm::ivec2(900, 3), glm::ivec2(40, 40)})
    for (MapViewSettings settings : everyPage()) {
      settings.false_colors = settings.waveform = true;
      const MapLayout layout = mapLayout(settings, {size, 16});
      for (const MapPane& pane : layout.panes) {
        EXPECT_GE(std::min(pane.place.corner.x, pane.place.corner.y), 0);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(pane.place.corner + pane.place.extent, size)));
      }
    }
}

TEST(MapLayout, FromInsideOneSeesTheWorldTheRightWayRound) {
  MapViewSettings settings;
  settings.page = MapPage::inside;
  const glm::vec2 middle = glm::vec2(kLayoutCanvas.size_px) / 2.0f;
  const auto at = [&](glm::vec2 pixel) { return *directionAtPixel(settings, kLayoutCanvas, pixel); };
  EXPECT_NEAR(glm::distance(at(middle), glm::vec3(0, 0, 1)), 0.0f, 1e-5f);
  EXPECT_GT(at({0.0f, middle.y}).x, 0.5f) << "+X is on the left";
  EXPECT_GT(at({middle.x, 0.0f}).y, 0.5f) << "+Y is above";
  settings.yaw_deg = 90.0f;
  EXPECT_NEAR(glm::distance(at(middle), glm::vec3(1, 0, 0)), 0.0f, 1e-5f);
  settings.pitch_deg = 90.0f;
  EXPECT_NEAR(glm::distance(at(middle), glm::vec3(0, 1, 0)), 0.0f, 1e-5f);
  EXPECT_THAT(pixelsOf(settings, kLayoutCanvas, {0.0f, -1.0f, 0.0f}), SizeIs(0)) << "it lies behind";
}

TEST(MapLayout, WhatIsUnderTheHandStaysUnderIt) {
  MapViewSettings settings;
  settings.page = MapPage::inside;
  settings.yaw_deg = 170.0f;
  settings.pitch_deg = 20.0f;
  const glm::vec2 from(100.0f, 90.0f);
  const glm::vec2 to(420.0f, 160.0f);
  const glm::vec3 held = *directionAtPixel(settings, kLayoutCanvas, from);
  const MapViewSettings moved = dragged(settings, kLayoutCanvas, from, to);
  EXPECT_NEAR(glm::distance(*directionAtPixel(moved, kLayoutCanvas, to), held), 0.0f, 1e-4f);
  EXPECT_GE(moved.yaw_deg, -180.0f);
  EXPECT_LT(moved.yaw_deg, 180.0f);
  const MapViewSettings closer = zoomed(settings, kLayoutCanvas, 0.5f, from);
  EXPECT_LT(closer.fov_deg, settings.fov_deg);
  EXPECT_NEAR(glm::distance(*directionAtPixel(closer, kLayoutCanvas, from), held), 0.0f, 1e-4f);
  EXPECT_EQ(zoomed(settings, kLayoutCanvas, 1e-9f, from).fov_deg, MapViewSettings::kMinFov_deg);
  EXPECT_LE(dragged(settings, kLayoutCanvas, {320.0f, 0.0f}, {320.0f, 1e5f}).pitch_deg, 90.0f);
  EXPECT_EQ(dragged(settingsOf(Projection::cube), kLayoutCanvas, from, to), settingsOf(Projection::cube));
  EXPECT_EQ(exposedBy(settings, 1.5f).display.exposure_ev, 1.5f);
  EXPECT_EQ(exposedBy(settings, 1e9f).display.exposure_ev, 30.0f);
}

TEST(MapViewOptions, EveryOptionTakesItsOwnValueAndSaysWhatItIs) {
  for (const auto& option : mapViewOptions()) {
    MapViewSettings settings;
    const ControlValue value = valueOf(option, settings);
    ASSERT_TRUE(setValue(option, settings, value)) << option.text.name;
    EXPECT_EQ(settings, MapViewSettings()) << option.text.name;
    EXPECT_FALSE(option.text.help.empty() || option.text.group.empty()) << option.text.name;
  }
}

TEST(MapViewOptions, PicturesAreThePagesAndEveryProjection) {
  const Option<MapViewSettings>& picture = mapViewOptions()[0];
  ASSERT_THAT(choicesOf(picture.text), SizeIs(2 + Projection::kKinds));
  MapViewSettings settings;
  for (const std::string_view name : choicesOf(picture.text)) {
    ASSERT_TRUE(assign(picture, settings, name));
    EXPECT_EQ(written(picture, settings), name);
  }
  EXPECT_EQ(settings, settingsOf(Projection::eac));
  ASSERT_TRUE(assign(picture, settings, "inside"));
  EXPECT_EQ(settings.page, MapPage::inside);
}

TEST(MapLayout, APhotographHasHalfOfThePicture) {
  for (const glm::ivec2 size : {glm::ivec2(640, 360), glm::ivec2(360, 640)}) {
    const MapCanvas canvas{.size_px = size, .photograph_px = {900, 700}};
    for (const MapViewSettings& settings : everyPage()) {
      const MapLayout layout = mapLayout(settings, canvas);
      ASSERT_TRUE(layout.photograph);
      const PixelRectangle place = *layout.photograph;
      EXPECT_NEAR(float(place.extent.x) / float(place.extent.y), 900.0f / 700.0f, 0.01f);
      EXPECT_GT(place.extent.x * place.extent.y, size.x * size.y / 5);
      for (int y = place.corner.y; y < place.corner.y + place.extent.y; y += 7)
        for (int x = place.corner.x; x < place.corner.x + place.extent.x; x += 7)
          EXPECT_FALSE(directionAtPixel(layout, settings, {x, y})) << pageName(settings) << ": the map lies over it";
      EXPECT_TRUE(layout.inside || !layout.panes.empty());
    }
  }
  EXPECT_FALSE(mapLayout({}, kLayoutCanvas).photograph);
  EXPECT_FALSE(mapLayout({}, MapCanvas{.size_px = {3, 2}, .photograph_px = {900, 700}}).photograph);
}

}  // namespace
}  // namespace mirrorball
