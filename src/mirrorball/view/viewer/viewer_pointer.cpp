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
  return {.size_px = glm::max(canvas.size_px / 3, glm::ivec2(1)),
          .line_px = std::max(canvas.line_px / 3, 1),
          .photograph_px = canvas.photograph_px};
}

constexpr glm::vec3 kBallColor(1.0f, 0.55f, 0.1f);

/// The parts of a ball's outline that lie in its photograph.
std::vector<DrawnLine> drawnOutline(const ShownBall& ball) {
  constexpr int kPlaces = 180;
  std::vector<DrawnLine> lines;
  bool was_inside = false;
  std::vector<glm::dvec2> outline = ball.view.outline(kPlaces);
  outline.push_back(outline.front());
  for (const glm::dvec2 place_px : outline) {
    const glm::vec2 place = ball.placeOf(place_px);
    const bool is_inside = ball.place.holds(place);
    if (is_inside && !was_inside) lines.push_back({{}, kBallColor});
    if (is_inside) lines.back().places.push_back(place);
    was_inside = is_inside;
  }
  return lines;
}

/// A small cross at each place.
std::vector<DrawnLine> crosses(const std::vector<glm::vec2>& places) {
  constexpr float kReach_px = 5.0f;
  std::vector<DrawnLine> lines;
  for (const glm::vec2 place : places)
    for (const glm::vec2 arm : {glm::vec2(kReach_px, 0.0f), glm::vec2(0.0f, kReach_px)})
      lines.push_back({{place - arm, place + arm}, kBallColor});
  return lines;
}

}  // namespace

MapCanvas Viewer::State::canvas() const { return mapCanvas(size_px, map.ball() ? map.ball()->size_px : glm::ivec2(0)); }

std::optional<ShownBall> Viewer::State::shownBall() const {
  const PhotographedBall* ball = map.ball();
  const AskedMap wanted = askedMap(now(), sideOfMap());
  if (!now().shows_map || !ball || !wanted.photo || wanted.name != map.asked().name) return std::nullopt;
  const auto settings = ballPhotoOf(*wanted.photo);
  const MapLayout layout = mapLayout(map_settings, canvas());
  if (!settings || !layout.photograph) return std::nullopt;
  ShownBall shown{.view = ball->view, .place = *layout.photograph, .size_px = ball->size_px};
  if (const std::vector<float>& circle = settings->circle; !circle.empty())
    if (const auto given = ballOfCircle({{circle[0], circle[1]}, circle[2]}, ball->size_px,
                                        perspectiveOf(*settings, ball->exif, ball->size_px)))
      shown.view = given->view;
  return shown;
}

std::vector<glm::vec2> Viewer::State::seenInMap() const {
  const auto ball = shownBall();
  if (!ball || !pointer_px || !ball->place.holds(*pointer_px)) return {};
  // Of the circle that the map was unwrapped from.
  const auto direction = map.ball()->view.directionAt(ball->photographPixel(*pointer_px));
  return direction ? pixelsOf(map_settings, canvas(), glm::vec3(*direction)) : std::vector<glm::vec2>();
}

std::size_t Viewer::State::sideOfMap() const { return now().shows_map ? editedSide(now()) : seenSides().front(); }

Result<bool> Viewer::State::advanceMap() {
  const auto settings = mapViewOf(now());
  problem_of_picking = settings ? std::string() : settings.error().message;
  if (settings) map_settings = *settings;
  return map.draw(map_settings, moves() ? movingCanvas(map_settings, canvas()) : canvas());
}

bool Viewer::State::isMapDone() const {
  const MapViewSettings settings = mapViewOf(now()).value_or(map_settings);
  return map.isDone(askedMap(now(), sideOfMap()), settings, canvas());
}

bool Viewer::State::isInspectorDone() const {
  const std::size_t side = seenSides().front();
  if (!now().inspects || !stageOf(side).isReady()) return true;
  const auto frame = wanted(side);
  const bool is_map_there = map.loading().isAskedFor(askedMap(now(), sideOfMap())) && !map.loading().isRunning();
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
  const std::vector<glm::vec2> reflected = seenInMap();
  UnderPointer under{
      .rows = map.factsAt(map_settings, canvas(), reflected.empty() ? pointer_px : std::optional(reflected.front())),
      .lines = crosses(reflected)};
  for (const MapLabel& label : mapLayout(map_settings, canvas()).labels)
    under.texts.push_back({label.text, glm::vec2(label.corner)});
  if (const auto ball = shownBall())
    for (DrawnLine& line : drawnOutline(*ball)) under.lines.push_back(std::move(line));
  return under;
}

}  // namespace mirrorball
