#include "mirrorball/view/map/map_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/image/resize.h"
#include "mirrorball/view/map/false_colors.h"

namespace mirrorball {
namespace {

using Color = glm::vec<4, std::uint8_t>;

constexpr Color kPaper{28, 28, 28, 255};
constexpr Color kFaultMark{255, 0, 255, 255};
constexpr Color kLampMark{0, 200, 255, 255};

/// Adds a share of a map's image to a part of a picture.
///
/// texels   3 channels, or 4 with alpha, premultiplied
void addShare(const Image& texels, float share, const PixelRectangle& place, Image& light) {
  for (int y = 0; y < place.extent.y; ++y)
    for (int x = 0; x < place.extent.x; ++x) {
      const glm::vec4 texel = share * rgbaAt(texels, x, y);
      float* const sum = light.texel(place.corner.x + x, place.corner.y + y);
      for (int channel = 0; channel < 4; ++channel) sum[channel] += texel[channel];
    }
}

/// The panes of one projection, from the first of them on.
Result<void> drawProjection(const PreparedMap& map, const MapViewSettings& settings, const MapPane* panes,
                            const ProgressFunction& progress, Image& light) {
  const Projection projection = panes->projection;
  const int size = panes->place.extent.y;
  // The sheet's small pictures are for seeing all at once: there a third less detail is enough, at a third of the cost.
  const float enough = settings.page == MapPage::all ? 0.7f : 1.0f;
  const auto parts = lightOf(map, settings, enough * texelDensity(projection, size));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].share == 0.0f) continue;
    MIRRORBALL_TRY(converted, convert(*parts[i].light, projection, size, {}, partOf(progress, i, 1, parts.size())));
    for (int face = 0; face < converted.faces(); ++face)
      addShare(converted.face(face), parts[i].share, panes[face].place, light);
  }
  return {};
}

/// The mean of what four rays through a pixel see.
glm::vec3 seenThrough(const MapEye& eye, glm::ivec2 pixel, const std::vector<LightShare>& parts) {
  glm::vec3 sum(0.0f);
  for (const glm::vec2 place : {glm::vec2(0.25f), glm::vec2(0.75f, 0.25f), glm::vec2(0.25f, 0.75f), glm::vec2(0.75f)}) {
    const glm::vec3 direction = glm::normalize(eye.rayAt(glm::vec2(pixel) + place));
    for (const LightShare& part : parts) sum += part.share * part.light->radiance(direction);
  }
  return sum / 4.0f;
}

Result<void> drawInside(const PreparedMap& map, const MapViewSettings& settings, const PixelRectangle& place,
                        const ProgressFunction& progress, Image& light) {
  constexpr std::size_t kRowsPerPiece = 8;
  const MapEye eye = mapEye(settings, place);
  // Texels at least half a pixel wide, which lie no closer than the rays.
  const std::vector<LightShare> parts = lightOf(map, settings, eye.focal_px);
  ProgressCounter counter(progress, std::size_t(place.extent.y));
  parallelFor(std::size_t(place.extent.y), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < place.extent.x; ++x) {
        const glm::ivec2 pixel = place.corner + glm::ivec2(x, y);
        const glm::vec4 seen(seenThrough(eye, pixel, parts), 1.0f);
        std::copy_n(&seen.x, 4, light.texel(pixel.x, pixel.y));
      }
    counter.advance(end - begin);
  });
  return counter.result();
}

void drawPhotograph(const Image& photograph, const PixelRectangle& place, Image& light) {
  addShare(resized(photograph, place.extent), 1.0f, place, light);
}

void drawPixel(glm::ivec2 pixel, Color color, Image8& picture) {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.width() || pixel.y >= picture.height()) return;
  std::copy_n(&color.x, 4, picture.texel(pixel.x, pixel.y));
}

/// A square around what is marked, which itself stays to be seen; a smaller one in the small pictures of the sheet.
void drawFaultMarks(const PreparedMap& map, const MapLayout& layout, const MapViewSettings& settings, Image8& picture) {
  const int reach = settings.page == MapPage::all ? 1 : 2;
  for (const glm::vec3 direction : map.faulty.directions)
    for (const glm::ivec2 middle : pixelsOf(layout, settings, direction))
      for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
          if (std::max(std::abs(x), std::abs(y)) == reach) drawPixel(middle + glm::ivec2(x, y), kFaultMark, picture);
}

/// A ring of dots on the sphere, a little outside the disc of a lamp's solid angle: each projection bends it as it
/// bends the lamp.
void drawLampMarks(const PreparedMap& map, const MapLayout& layout, const MapViewSettings& settings, Image8& picture) {
  constexpr int kDots = 360;
  constexpr float kBeside_rad = 0.03f;
  for (const MapLamp& lamp : map.lamps) {
    const glm::mat3 frame = centredOn(lamp.direction);
    const float angle = std::min(lamp.angular_size_rad / 2.0f + kBeside_rad, std::numbers::pi_v<float>);
    for (int dot = 0; dot < kDots; ++dot) {
      const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(dot) / kDots;
      const glm::vec3 beside(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
      for (const glm::ivec2 pixel : pixelsOf(layout, settings, frame * beside)) drawPixel(pixel, kLampMark, picture);
    }
  }
}

}  // namespace

Result<Image> mapLight(const PreparedMap& map, const MapViewSettings& settings, const MapCanvas& canvas,
                       const ProgressFunction& progress) {
  Image light(canvas.size_px.x, canvas.size_px.y, 4);
  const MapLayout layout = mapLayout(settings, canvas);
  if (layout.photograph && map.photograph) drawPhotograph(*map.photograph, *layout.photograph, light);
  if (layout.inside) MIRRORBALL_TRY_VOID(drawInside(map, settings, *layout.inside, progress, light));
  for (std::size_t pane = 0; pane < layout.panes.size();) {
    const auto images = static_cast<std::size_t>(faceCount(layout.panes[pane].projection));
    const ProgressFunction of_pane = partOf(progress, pane, images, layout.panes.size());
    MIRRORBALL_TRY_VOID(drawProjection(map, settings, &layout.panes[pane], of_pane, light));
    pane += images;
  }
  return light;
}

bool haveSameLight(const MapViewSettings& a, const MapViewSettings& b) {
  MapViewSettings shown = a;
  shown.display = b.display;
  shown.stops = b.stops;
  shown.marks_bad = b.marks_bad;
  shown.marks_lamps = b.marks_lamps;
  return shown == b;
}

Image8 mapPicture(const PreparedMap& map, const Image& light, const MapViewSettings& settings,
                  const MapCanvas& canvas) {
  const float exposure_ev = settings.display.exposure_ev;
  const glm::vec3 paper = formula::linearFromSrgb(glm::vec3(kPaper) / 255.0f);
  Image8 picture = settings.false_colors ? falseColors(light, exposure_ev, settings.stops, kPaper)
                                         : displayedPicture(settings.display, light, glm::vec4(paper, 1.0f));
  const MapLayout layout = mapLayout(settings, canvas);
  if (layout.waveform) drawWaveform(map.waveform, *layout.waveform, exposure_ev, settings.stops, picture);
  if (layout.legend) drawLegend(*layout.legend, settings.stops, picture);
  if (settings.marks_lamps) drawLampMarks(map, layout, settings, picture);
  if (settings.marks_bad) drawFaultMarks(map, layout, settings, picture);
  return picture;
}

Result<Image8> MapViewer::picture(const MapViewSettings& settings, const MapCanvas& canvas,
                                  const ProgressFunction& progress) {
  if (!light_ || !(canvas_ == canvas) || !haveSameLight(settings_, settings)) {
    light_.reset();
    MIRRORBALL_TRY(light, mapLight(map_, settings, canvas, progress));
    light_ = std::move(light);
    settings_ = settings;
    canvas_ = canvas;
  }
  return mapPicture(map_, *light_, settings, canvas);
}

}  // namespace mirrorball
