#include "mirrorball/view/map/map_layout.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/text.h"
#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

constexpr CubeLayout kUnfolded = CubeLayout::hcross;

/// Columns and rows of images in which a projection is shown.
glm::ivec2 imagesAcross(Projection projection) {
  const int images = faceCount(projection);
  return images == 6 ? cellsOf(kUnfolded) : glm::ivec2(images, 1);
}

glm::ivec2 cellOfImage(Projection projection, int face) {
  return faceCount(projection) == 6 ? cellOf(kUnfolded, face) : glm::ivec2(face, 0);
}

/// The size of a whole projection whose images are `size` large.
glm::ivec2 shownSize(Projection projection, int size) { return imagesAcross(projection) * imageSize(projection, size); }

/// The size of the images with which the whole is at most so high.
int imageSizeForHeight(Projection projection, int height) { return height / imagesAcross(projection).y; }

void addPanes(Projection projection, int size, glm::ivec2 corner, MapLayout& layout) {
  const glm::ivec2 extent = imageSize(projection, size);
  for (int face = 0; face < faceCount(projection); ++face)
    layout.panes.push_back({projection, face, {corner + cellOfImage(projection, face) * extent, extent}});
}

void layOne(Projection projection, const PixelRectangle& room, MapLayout& layout) {
  const glm::ivec2 of_one = shownSize(projection, 1);
  const int size = std::min(room.extent.x / of_one.x, room.extent.y / of_one.y);
  if (size < 1) return;
  addPanes(projection, size, room.corner + (room.extent - shownSize(projection, size)) / 2, layout);
}

/// A row of the sheet: projections from `first` to before `end`.
struct SheetRow {
  std::size_t first;
  std::size_t end;
  int width;
};

/// All projections in rows of a height, as many in each as have room; nothing if one of them is too wide.
std::optional<std::vector<SheetRow>> sheetRows(const MapViewSettings& settings, int height, int gap, int width) {
  std::vector<SheetRow> rows;
  for (std::size_t kind = 0; kind < Projection::kKinds; ++kind) {
    const Projection projection = projectionOf(settings, static_cast<Projection::Kind>(kind));
    const int wide = shownSize(projection, imageSizeForHeight(projection, height)).x;
    if (wide > width) return std::nullopt;
    if (rows.empty() || rows.back().width + gap + wide > width)
      rows.push_back({kind, kind + 1, wide});
    else
      rows.back() = {rows.back().first, kind + 1, rows.back().width + gap + wide};
  }
  return rows;
}

/// A label, if a face has room for its text: a letter is about half as wide as its line is high.
void addLabel(MapLabel label, int room_px, int line_px, MapLayout& layout) {
  const auto wide = static_cast<float>(label.text.size()) * 0.5f * static_cast<float>(line_px);
  if (wide <= static_cast<float>(room_px)) layout.labels.push_back(std::move(label));
}

/// The highest rows that have room, with a line of text above each.
void layAll(const MapViewSettings& settings, const PixelRectangle& room, int line_px, MapLayout& layout) {
  const int gap = std::max(line_px / 2, 1);
  const glm::ivec2 inner = room.extent - 2 * gap;
  const auto rowsOf = [&](int height) -> std::optional<std::vector<SheetRow>> {
    auto rows = sheetRows(settings, height, gap, inner.x);
    const auto count = rows ? static_cast<int>(rows->size()) : 0;
    if (rows && count * (line_px + height) + (count - 1) * gap > inner.y) rows.reset();
    return rows;
  };
  int height = 3;  // a cube's faces are a third of it
  if (!rowsOf(height)) return;
  for (int too_high = inner.y + 1; height + 1 < too_high;) {
    const int middle = (height + too_high) / 2;
    (rowsOf(middle) ? height : too_high) = middle;
  }
  const std::vector<SheetRow> rows = *rowsOf(height);
  const int used = static_cast<int>(rows.size()) * (line_px + height + gap) - gap;
  int top = room.corner.y + (room.extent.y - used) / 2;
  for (const SheetRow& row : rows) {
    int left = room.corner.x + (room.extent.x - row.width) / 2;
    for (std::size_t kind = row.first; kind < row.end; ++kind) {
      const Projection projection = projectionOf(settings, static_cast<Projection::Kind>(kind));
      const int size = imageSizeForHeight(projection, height);
      const int wide = shownSize(projection, size).x;
      addLabel({textOf(projection), {left, top}}, wide + gap, line_px, layout);
      addPanes(projection, size, {left, top + line_px}, layout);
      left += wide + gap;
    }
    top += line_px + height + gap;
  }
}

/// "+4", "0", "-4"
std::string stopsText(float stops) { return (stops > 0.0f ? "+" : "") + formatNumber(double(stops)); }

/// Cuts a legend off below: a bar with five numbers under it.
void layLegend(const MapViewSettings& settings, int line_px, PixelRectangle& room, MapLayout& layout) {
  const int height = 2 * line_px;
  if (room.extent.y <= 2 * height) return;
  room.extent.y -= height;
  const glm::ivec2 corner(room.corner.x, room.corner.y + room.extent.y);
  layout.legend = PixelRectangle{corner, {room.extent.x, line_px}};
  constexpr int kIntervals = 4;
  for (int part = 0; part <= kIntervals; ++part) {
    const float share = static_cast<float>(part) / kIntervals;
    // The last number ends with the bar.
    const int most_left = std::max(room.extent.x - 2 * line_px, 0);
    const auto left = static_cast<int>(share * static_cast<float>(most_left));
    addLabel({stopsText(settings.stops * (2.0f * share - 1.0f)), {corner.x + left, corner.y + line_px}},
             most_left / kIntervals, line_px, layout);
  }
}

/// Cuts a waveform off below, a quarter of what is there.
void layWaveform(int line_px, PixelRectangle& room, MapLayout& layout) {
  const int height = room.extent.y / 4;
  if (height < line_px) return;
  room.extent.y -= height;
  layout.waveform = PixelRectangle{{room.corner.x, room.corner.y + room.extent.y}, {room.extent.x, height}};
}

/// Below a panorama that stands alone, its waveform lies column under column.
void alignWaveform(const MapViewSettings& settings, int line_px, MapLayout& layout) {
  PixelRectangle& place = *layout.waveform;
  if (layout.panes.size() == 1 && layout.panes[0].projection == Projection::equirect) {
    place.corner.x = layout.panes[0].place.corner.x;
    place.extent.x = layout.panes[0].place.extent.x;
  }
  for (const int part : {0, 1, 2}) {
    const float stops = settings.stops * static_cast<float>(1 - part);
    layout.labels.push_back({stopsText(stops), place.corner + glm::ivec2(0, part * (place.extent.y - line_px) / 2)});
  }
}

/// Gives a photograph the left half, or of a high picture the upper one.
void layPhotograph(glm::ivec2 size, int line_px, PixelRectangle& room, MapLayout& layout) {
  const int axis = room.extent.x >= room.extent.y ? 0 : 1;
  PixelRectangle half = room;
  half.extent[axis] /= 2;
  room.corner[axis] += half.extent[axis];
  room.extent[axis] -= half.extent[axis];
  const int gap = std::max(line_px / 2, 1);
  const glm::vec2 inner(half.extent - 2 * gap);
  const float scale = std::min(inner.x / static_cast<float>(size.x), inner.y / static_cast<float>(size.y));
  const glm::ivec2 extent(scale * glm::vec2(size) + 0.5f);
  if (extent.x < 1 || extent.y < 1) return;
  layout.photograph = PixelRectangle{half.corner + (half.extent - extent) / 2, extent};
}

}  // namespace

bool PixelRectangle::holds(glm::vec2 pixel) const {
  const glm::vec2 inside = pixel - glm::vec2(corner);
  return inside.x >= 0.0f && inside.y >= 0.0f && inside.x < static_cast<float>(extent.x) &&
         inside.y < static_cast<float>(extent.y);
}

MapLayout mapLayout(const MapViewSettings& settings, const MapCanvas& canvas) {
  MapLayout layout;
  PixelRectangle room{glm::ivec2(0), canvas.size_px};
  if (canvas.photograph_px.x > 0 && canvas.photograph_px.y > 0)
    layPhotograph(canvas.photograph_px, canvas.line_px, room, layout);
  if (settings.false_colors) layLegend(settings, canvas.line_px, room, layout);
  if (settings.waveform) layWaveform(canvas.line_px, room, layout);
  if (settings.page == MapPage::inside)
    layout.inside = room;
  else if (settings.page == MapPage::one)
    layOne(projectionOf(settings, settings.projection), room, layout);
  else
    layAll(settings, room, canvas.line_px, layout);
  if (layout.waveform) alignWaveform(settings, canvas.line_px, layout);
  return layout;
}

const MapPane* paneAt(const MapLayout& layout, glm::vec2 pixel) {
  const auto found = std::find_if(layout.panes.begin(), layout.panes.end(),
                                  [pixel](const MapPane& pane) { return pane.place.holds(pixel); });
  return found == layout.panes.end() ? nullptr : &*found;
}

std::optional<glm::vec3> directionAtPixel(const MapLayout& layout, const MapViewSettings& settings, glm::vec2 pixel) {
  if (layout.inside && layout.inside->holds(pixel))
    return glm::normalize(mapEye(settings, *layout.inside).rayAt(pixel));
  const MapPane* pane = paneAt(layout, pixel);
  if (!pane) return std::nullopt;
  const glm::vec2 uv = (pixel - glm::vec2(pane->place.corner)) / glm::vec2(pane->place.extent);
  if (!covers(pane->projection, uv)) return std::nullopt;
  return directionAt(pane->projection, {pane->face, uv});
}

std::vector<glm::vec2> pixelsOf(const MapLayout& layout, const MapViewSettings& settings, glm::vec3 direction) {
  std::vector<glm::vec2> pixels;
  if (layout.inside)
    if (const auto pixel = mapEye(settings, *layout.inside).pixelOf(direction); pixel && layout.inside->holds(*pixel))
      pixels.push_back(*pixel);
  for (const MapPane& pane : layout.panes) {
    if (!covers(pane.projection, direction)) continue;
    const MapPosition position = positionOf(pane.projection, direction);
    if (position.face != pane.face) continue;
    const glm::vec2 extent(pane.place.extent);
    // An image's end belongs to its last pixel.
    pixels.push_back(glm::vec2(pane.place.corner) + glm::min(position.uv * extent, extent - 0x1p-8f));
  }
  return pixels;
}

std::optional<glm::vec3> directionAtPixel(const MapViewSettings& settings, const MapCanvas& canvas, glm::vec2 pixel) {
  return directionAtPixel(mapLayout(settings, canvas), settings, pixel);
}

std::vector<glm::vec2> pixelsOf(const MapViewSettings& settings, const MapCanvas& canvas, glm::vec3 direction) {
  return pixelsOf(mapLayout(settings, canvas), settings, direction);
}

MapEye mapEye(const MapViewSettings& settings, const PixelRectangle& place) {
  const glm::vec3 ahead = directionAtAngles(settings.yaw_deg, settings.pitch_deg);
  // A quarter of a turn before where it looks, on the horizon: so there is a right hand at the poles, too.
  const glm::vec3 right = directionAtAngles(settings.yaw_deg - 90.0f, 0.0f);
  const auto height = static_cast<float>(place.extent.y);
  return {.world_from_eye = glm::mat3(right, glm::cross(right, ahead), ahead),
          .focal_px = 0.5f * height / std::tan(glm::radians(settings.fov_deg) / 2.0f),
          .middle_px = glm::vec2(place.corner) + glm::vec2(place.extent) / 2.0f};
}

glm::vec3 MapEye::rayAt(glm::vec2 pixel) const {
  const glm::vec2 tangent = (pixel - middle_px) / focal_px;
  return world_from_eye * glm::vec3(tangent.x, -tangent.y, 1.0f);
}

std::optional<glm::vec2> MapEye::pixelOf(glm::vec3 direction) const {
  const glm::vec3 seen = glm::transpose(world_from_eye) * direction;
  if (seen.z <= 0.0f) return std::nullopt;
  return middle_px + glm::vec2(seen.x, -seen.y) * (focal_px / seen.z);
}

}  // namespace mirrorball
