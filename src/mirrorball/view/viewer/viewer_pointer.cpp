// What a viewer tells of the place under the pointer.

#include <utility>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/view/map/map_layout.h"
#include "mirrorball/view/viewer/told.h"
#include "mirrorball/view/viewer/viewer_state.h"

namespace mirrorball {
namespace {

/// Of a map that moves, in place of the whole one, where it looks the same but for its sharpness.
MapCanvas movingCanvas(const MapViewSettings& settings, const MapCanvas& canvas) {
  if (settings.page != MapPage::inside || settings.waveform || settings.false_colors) return canvas;
  return {.size_px = glm::max(canvas.size_px / 3, glm::ivec2(1)), .line_px = std::max(canvas.line_px / 3, 1)};
}

}  // namespace

Result<bool> Viewer::State::advanceMap() {
  const auto settings = mapViewOf(now());
  problem_of_picking = settings ? std::string() : settings.error().message;
  if (settings) map_settings = *settings;
  const MapCanvas canvas = mapCanvas(size_px);
  return map.draw(map_settings, moves() ? movingCanvas(map_settings, canvas) : canvas);
}

bool Viewer::State::isMapDone() const {
  const MapViewSettings settings = mapViewOf(now()).value_or(map_settings);
  return map.isDone(mapOf(now(), editedSide(now())), settings, mapCanvas(size_px));
}

bool Viewer::State::isInspectorDone() const {
  const std::size_t side = seenSides().front();
  if (!now().inspects || !stageOf(side).isReady()) return true;
  const auto frame = wanted(side);
  const bool is_map_there = map.loading().isAskedFor(mapOf(now(), editedSide(now()))) && !map.loading().isRunning();
  return !frame || (is_map_there && inspector.isDone(stageOf(side), frame->drawn));
}

/// Asks anew whenever something may have changed: an answer costs less than a thousandth of a second.
Result<void> Viewer::State::advanceInspection() {
  inspected = {};
  const std::size_t side = seenSides().front();
  if (!now().inspects || !stageOf(side).isReady()) return {};
  const auto frame = wanted(side);
  if (!frame) return {};
  FrameSettings seen = frame->drawn;
  seen.size = size_px;
  inspector.follow(stageOf(side), seen);
  MIRRORBALL_TRY_VOID(map.makeSmall(seen.display));
  if (!pointer_px) return {};
  auto inspection = inspector.at(stageOf(side), seen, *pointer_px);
  if (!inspection) return tell(fail(std::move(inspection)), problem_of_picking);
  if (!*inspection) return {};
  const Scene& scene = stageOf(side).stage().scene();
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), seen.camera, seen.size));
  inspected = drawnInspection(**inspection, camera, size_px);
  const auto mark = [&](const std::optional<RayPath>& path, glm::vec3 color) {
    if (!path || path->end != PathEnd::environment) return;
    std::vector<MarkedPicture> marked = map.marked(path->direction, path->lobe, color);
    if (inspected.maps.empty()) {
      inspected.maps = std::move(marked);
      return;
    }
    for (std::size_t i = 0; i < marked.size(); ++i) {
      for (DrawnLine& line : marked[i].lines) inspected.maps[i].lines.push_back(std::move(line));
      for (DrawnLine& dot : marked[i].dots) inspected.maps[i].dots.push_back(std::move(dot));
    }
  };
  if (const auto& surface = (*inspection)->surface) {
    mark(surface->reflected, kReflectedColor);
    mark(surface->refracted, kRefractedColor);
  }
  mark((*inspection)->behind, kReflectedColor);
  return {};
}

UnderPointer Viewer::State::underPointer() const {
  if (!now().shows_map) return inspected;
  const MapCanvas canvas = mapCanvas(size_px);
  UnderPointer under{.rows = map.factsAt(map_settings, canvas, pointer_px)};
  for (const MapLabel& label : mapLayout(map_settings, canvas).labels)
    under.texts.push_back({label.text, glm::vec2(label.corner)});
  return under;
}

}  // namespace mirrorball
