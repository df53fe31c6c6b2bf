// What a viewer's two halves show.

#include <algorithm>
#include <set>
#include <utility>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/trace/trace_settings.h"
#include "mirrorball/view/viewer/told.h"
#include "mirrorball/view/viewer/viewer_state.h"

namespace mirrorball {

std::vector<std::size_t> Viewer::State::seenSides() const {
  switch (now().compare_by) {
    case CompareBy::slider:
      return {0, 1};
    case CompareBy::flip:
      return {editedSide(now())};
    default:
      return {0};
  }
}

std::vector<std::size_t> Viewer::State::wantedSides() const {
  std::vector<std::size_t> sides = seenSides();
  if (isComparing() && !moves() && sides.size() == 1) sides.push_back(1 - sides.front());
  return sides;
}

Result<WantedFrame> Viewer::State::wanted(std::size_t side) const {
  const GivenTexts given = givenFrame(now(), side);
  MIRRORBALL_TRY(frame, frameOf(given));
  MIRRORBALL_TRY(quality, qualityOf(given));
  frame.proxy.load.inside_only = options.inside_only;
  frame.size = size_px;
  standInView(frame, side);
  MIRRORBALL_TRY(still, player.standingStill(std::move(frame), stageOf(side).stage().bounds()));
  frame = std::move(still);
  WantedFrame wanted{.drawn = frame, .traced = frame};
  if (!given.contains("samples")) wanted.traced.samples = TraceSettings().samples;
  std::set<std::string_view> names;
  for (const auto& [name, texts] : given) names.insert(name);
  SceneTraits traits = model.traits();
  traits.has_strong_sun = stageOf(side).strongSun().has_value();
  wanted.chosen = fillIn(quality, traits, names, wanted.drawn);
  if (moves()) {
    wanted.drawn.size = drawn[side].movingSize(size_px);
    wanted.drawn.samples = 1;
  }
  return wanted;
}

/// What moves is drawn in all halves that are seen; of what rests, the half that has fewer samples.
Result<bool> Viewer::State::advanceSides() {
  bool is_other = false;
  std::optional<std::size_t> next;
  for (const std::size_t side : wantedSides()) {
    MIRRORBALL_TRY(is_new, advance(side));
    is_other = is_other || is_new;
    if (canGoOn(side) && (!next || samplesOf(side) < samplesOf(*next))) next = side;
  }
  if (next && !moves()) {
    MIRRORBALL_TRY(is_new, draw(*next));
    is_other = is_other || is_new;
  }
  MIRRORBALL_TRY(is_compared, advanceComparison());
  return is_other || is_compared;
}

/// Takes what was found beside it; what moves is drawn at once.
Result<bool> Viewer::State::advance(std::size_t side) {
  if (!stageOf(side).isReady()) return false;
  const auto frame = wanted(side);
  problems_of_frames[side] = frame ? std::string() : frame.error().message;
  if (!frame) return false;
  if (isTraced(side) && !moves()) return traced[side].trace(stageOf(side), frame->traced);
  traced[side].stop();
  const bool goes_on = moves() || !drawn[side].hasBegun(stageOf(side), frame->drawn);
  return goes_on ? draw(side) : Result<bool>(false);
}

Result<bool> Viewer::State::draw(std::size_t side) {
  const auto frame = wanted(side);
  return frame ? drawn[side].draw(stageOf(side), frame->drawn) : Result<bool>(false);
}

int Viewer::State::samplesOf(std::size_t side) const {
  const auto frame = wanted(side);
  return frame && drawn[side].hasBegun(stageOf(side), frame->drawn) ? drawn[side].samples() : 0;
}

bool Viewer::State::isSideDone(std::size_t side) const {
  if (!stageOf(side).isReady()) return isUpToDate();  // it cannot be shown
  const auto frame = wanted(side);
  if (!frame) return true;
  if (isTraced(side) && !moves()) return traced[side].isDone(stageOf(side), frame->traced);
  return drawn[side].isDone(stageOf(side), frame->drawn);
}

bool Viewer::State::isMomentSeen() const {
  const std::vector<std::size_t> sides = seenSides();
  return isUpToDate() && std::all_of(sides.begin(), sides.end(),
                                     [&](std::size_t side) { return samplesOf(side) > 0 || isSideDone(side); });
}

bool Viewer::State::canGoOn(std::size_t side) const {
  if (!stageOf(side).isReady() || drawn[side].isWaiting(stageOf(side))) return false;
  const auto frame = wanted(side);
  if (!frame || drawn[side].isDone(stageOf(side), frame->drawn)) return false;
  return !isTraced(side) || pictureOf(side) == drawn[side].picture();
}

const gl::Framebuffer* Viewer::State::pictureOf(std::size_t side) const {
  if (isTraced(side) && !moves() && stageOf(side).isReady())
    if (const auto frame = wanted(side))
      if (const gl::Framebuffer* picture = traced[side].pictureOf(stageOf(side), frame->traced)) return picture;
  return drawn[side].picture();
}

ComparedSides::Version Viewer::State::comparedVersion() const {
  return {drawn[0].pictureVersion(),  drawn[1].pictureVersion(), traced[0].pictureVersion(),
          traced[1].pictureVersion(), isTraced(0) ? 1 : 0,       isTraced(1) ? 1 : 0};
}

bool Viewer::State::canCompare() const {
  if (!isComparing() || moves()) return false;
  for (const std::size_t side : {0, 1}) {
    const gl::Framebuffer* picture = pictureOf(side);
    const bool is_whole = picture && glm::ivec2(picture->width(), picture->height()) == size_px;
    // A traced picture is worth a comparison before it is done.
    if (!is_whole || (picture == drawn[side].picture() && !isSideDone(side))) return false;
  }
  return true;
}

Result<bool> Viewer::State::advanceComparison() {
  MIRRORBALL_TRY(is_new, compared.take());
  if (canCompare()) MIRRORBALL_TRY_VOID(compared.compare(*pictureOf(0), *pictureOf(1), comparedVersion()));
  return is_new;
}

const gl::Framebuffer* Viewer::State::heatMap() const {
  if (moves()) return nullptr;
  const bool is_difference = now().compare_by == CompareBy::difference;
  if (!is_difference && now().compare_by != CompareBy::flip_error) return nullptr;
  return compared.heatMap(is_difference ? HeatMapKind::difference : HeatMapKind::flip, comparedVersion());
}

void Viewer::State::show(const FramebufferPart& part) const {
  const gl::Context& context = device.state().context;
  if (now().shows_map) return showPicture(context, *map.picture(), part);
  const gl::Framebuffer* first = pictureOf(0);
  const gl::Framebuffer* second = pictureOf(1);
  if (const gl::Framebuffer* heat = heatMap()) return showPicture(context, *heat, part);
  if (now().compare_by == CompareBy::slider && first && second)
    return showBeside(context, *first, *second, now().divider, part);
  showPicture(context, *pictureOf(seenSides().front()), part);
}

SideStatus Viewer::State::statusOf(std::size_t side) const {
  const gl::Framebuffer* picture = pictureOf(side);
  SideStatus status{.is_traced = picture && picture != drawn[side].picture(), .light = drawn[side].lightCost()};
  if (picture) status.size_px = {picture->width(), picture->height()};
  if (const auto frame = wanted(side)) status.chosen = frame->chosen;
  if (isTraced(side) && !moves()) {
    status.samples = status.is_traced ? traced[side].paths() : 0;
    status.wanted_samples = traced[side].wantedPaths();
    status.noise = traced[side].noise();
    return status;
  }
  status.samples = drawn[side].samples();
  status.wanted_samples = drawn[side].wantedSamples();
  status.programs_left = drawn[side].programsLeft();
  status.sample_s = drawn[side].sampleSeconds();
  status.gpu_s = drawn[side].gpuSeconds();
  return status;
}

void Viewer::State::tellLoading(ViewerStatus& status) const {
  const auto tell = [&](std::string what, double share) {
    if (!status.loading.empty()) return;
    status.loading = std::move(what);
    status.loaded = share;
  };
  if (needsMap() && map.loading().isRunning()) tell(map.loading().name(), map.loading().share());
  if (now().shows_map && map.isDrawing()) tell("the picture of the map", 0.0);
  if (now().inspects && inspector.isRunning()) tell("the triangles, to inspect", 0.0);
  if (now().shows_map) return;
  if (model.loading().isRunning()) tell(model.loading().name(), model.loading().share());
  for (const std::size_t side : wantedSides()) {
    const LitStage& stage = stageOf(side);
    if (stage.loading().isRunning()) tell(stage.loading().name(), stage.loading().share());
    const bool shows_paths = pictureOf(side) != drawn[side].picture();
    if (drawn[side].preparing().isRunning() && !shows_paths)
      tell("what frames need of the scene", drawn[side].preparing().share());
    if (drawn[side].isPicking()) tell("the triangles, to pick among", 0.0);
    if (traced[side].isRunning()) tell("paths", traced[side].share());
  }
  if (compared.isRunning()) tell("the difference of both halves", 0.0);
}

const std::string& Viewer::State::remark() const {
  if (now().shows_map) return map.remark();
  const std::vector<std::size_t> sides = wantedSides();
  const auto doubted =
      std::find_if(sides.begin(), sides.end(), [&](std::size_t side) { return !stageOf(side).remark().empty(); });
  return stageOf(doubted == sides.end() ? sides.front() : *doubted).remark();
}

const std::string& Viewer::State::problem() const {
  if (needsMap() && !map.problem().empty()) return map.problem();
  if (now().shows_map) return problem_of_picking;
  if (now().inspects && !inspector.problem().empty()) return inspector.problem();
  if (!model.problem().empty()) return model.problem();
  for (const std::size_t side : wantedSides())
    for (const std::string* each :
         {&stageOf(side).problem(), &problems_of_frames[side], &drawn[side].problem(), &traced[side].problem()})
      if (!each->empty()) return *each;
  return problem_of_picking;
}

}  // namespace mirrorball
