#include "mirrorball/view/viewer/shown_map.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mirrorball/view/inspect/map_marks.h"
#include "mirrorball/view/map/map_facts.h"
#include "mirrorball/view/viewer/told.h"

namespace mirrorball {
namespace {

void addRows(const std::vector<MapFact>& facts, std::vector<InspectionRow>& rows) {
  for (const MapFact& fact : facts) rows.push_back({std::string(fact.name), fact.value, std::string(fact.unit)});
}

/// Around all images of a projection.
PixelRectangle around(const MapLayout& layout) {
  PixelRectangle all;
  if (layout.panes.empty()) return all;
  all.corner = layout.panes.front().place.corner;
  glm::ivec2 end = all.corner;
  for (const MapPane& pane : layout.panes) {
    all.corner = glm::min(all.corner, pane.place.corner);
    end = glm::max(end, pane.place.corner + pane.place.extent);
  }
  all.extent = end - all.corner;
  return all;
}

constexpr int kSmallHeight_px = 120;

}  // namespace

ShownMap::ShownMap(const Device& device) : on_(new OnDevice{device}) {}

void ShownMap::follow(const AskedMap& map, const std::optional<CacheFolder>& cache) {
  const bool has_begun = loading_.askFor(map, [cache](const AskedMap& asked, const ProgressFunction& progress) {
    return viewedMap(asked, cache, progress);
  });
  if (has_begun) watch_.watch({map.name});
  auto ready = loading_.take();
  if (!ready) return;
  watch_.watch({loading_.name()});
  drawing_.cancel();
  begun_.reset();
  small_display_.reset();
  maker_ = std::make_shared<Maker>(std::move(ready->map));
  ball_ = std::move(ready->ball);
  asked_ = loading_.asked();
  remark_ = std::move(ready->remark);
}

Result<bool> ShownMap::draw(const MapViewSettings& settings, const MapCanvas& canvas) {
  if (!maker_) return false;
  if (begun_ != settings || begun_canvas_ != canvas) {
    // What is drawn now is shown first: a hand that moves would else see nothing.
    if (drawing_.isRunning() && begun_) {
      auto ready = drawing_.take();
      if (!ready) return false;
      if (*ready) MIRRORBALL_TRY_VOID(tell(keep(std::move(**ready)), problem_));
    }
    begun_ = settings;
    begun_canvas_ = canvas;
    drawing_.begin([maker = maker_, settings, canvas](const ProgressFunction& progress) {
      const std::lock_guard one_at_a_time(maker->mutex);
      return maker->viewer.picture(settings, canvas, progress);
    });
  }
  auto ready = drawing_.take();
  if (!ready) return false;
  const bool is_drawn = ready->has_value();
  MIRRORBALL_TRY_VOID(tell(is_drawn ? keep(std::move(**ready)) : fail(std::move(*ready)), problem_));
  return is_drawn;
}

Result<void> ShownMap::keep(Image8 picture) {
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  MIRRORBALL_TRY_VOID(gl::resize(on_->picture, gl::Format::rgba8, {picture.width(), picture.height()}));
  on_->picture->upload(std::move(picture));
  return {};
}

bool ShownMap::isDone(const AskedMap& map, const MapViewSettings& settings, const MapCanvas& canvas) const {
  if (!loading_.isAskedFor(map) || loading_.isRunning()) return false;
  return !maker_ || (begun_ == settings && begun_canvas_ == canvas && !drawing_.isRunning());
}

std::vector<InspectionRow> ShownMap::factsAt(const MapViewSettings& settings, const MapCanvas& canvas,
                                             std::optional<glm::vec2> pixel) const {
  std::vector<InspectionRow> rows;
  if (!maker_) return rows;
  const PreparedMap& map = maker_->viewer.map();
  if (pixel) addRows(mapFactsAt(map, settings, canvas, *pixel), rows);
  addRows(mapFacts(map, settings), rows);
  return rows;
}

Result<void> ShownMap::makeSmall(const Display& display) {
  if (!maker_ || small_display_ == display) return {};
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  const std::array<std::pair<Projection::Kind, float>, 3> shapes{
      {{Projection::equirect, 2.0f}, {Projection::cube, 4.0f / 3.0f}, {Projection::sphere, 1.0f}}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Small& small = on_->small[i];
    small.settings = {.page = MapPage::one, .projection = shapes[i].first, .display = display, .marks_bad = false};
    small.canvas = {.size_px = {int(shapes[i].second * kSmallHeight_px), kSmallHeight_px + 1}, .line_px = 1};
    small.place = around(mapLayout(small.settings, small.canvas));
    const PreparedMap& map = maker_->viewer.map();
    MIRRORBALL_TRY(light, mapLight(map, small.settings, small.canvas));
    MIRRORBALL_TRY_VOID(gl::resize(small.picture, gl::Format::rgba8, small.canvas.size_px));
    small.picture->upload(mapPicture(map, light, small.settings, small.canvas));
  }
  small_display_ = display;
  return {};
}

std::vector<MarkedPicture> ShownMap::marked(glm::vec3 direction, std::span<const glm::vec3> outline,
                                            glm::vec3 color) const {
  std::vector<MarkedPicture> pictures;
  if (!small_display_) return pictures;
  const MapMarks marks = marksOf(direction, outline);
  const std::array<std::pair<const char*, const MapMark*>, 3> named{
      {{"panorama", &marks.panorama}, {"cross", &marks.cross}, {"sphere map", &marks.sphere_map}}};
  for (std::size_t i = 0; i < named.size(); ++i) {
    const Small& small = on_->small[i];
    const auto placed = [&](glm::vec2 share) {
      return glm::vec2(small.place.corner) + share * glm::vec2(small.place.extent);
    };
    MarkedPicture picture{.title = named[i].first,
                          .texture = small.picture->color().name(),
                          .size_px = small.canvas.size_px,
                          .dots = {{{placed(named[i].second->dot)}, color}}};
    for (const std::vector<glm::vec2>& line : named[i].second->outline) {
      DrawnLine& drawn = picture.lines.emplace_back(DrawnLine{{}, color});
      std::transform(line.begin(), line.end(), std::back_inserter(drawn.places), placed);
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace mirrorball
