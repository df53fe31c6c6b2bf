#include "mirrorball/render/stage/stage_work.h"

#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/render/light/ground_caustics.h"
#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/render/stage/stage_work_state.h"
#include "mirrorball/render/stage/staged_light.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/scene/relief/prism_list.h"

namespace mirrorball {

StageWork::StageWork(std::unique_ptr<State> state) : state_(std::move(state)) {}
StageWork::StageWork(StageWork&&) noexcept = default;
StageWork& StageWork::operator=(StageWork&&) noexcept = default;
StageWork::~StageWork() = default;

namespace {

// How much of the work each part is, of a thousand: the form's occlusion takes the longest by far.
constexpr std::size_t kOfForm = 700;
constexpr std::size_t kOfRow = 60;

using State = StageWork::State;

bool lacksForm(const State& state) { return !state.has_form && !isPrepared(*state.scene, state.preparation); }

std::vector<int> lackingPrisms(const State& state) {
  if (state.settings.relief != ReliefKind::exact) return {};
  std::vector<int> meshes = meshesWithPrisms(*state.scene);
  std::erase_if(meshes, [&](int mesh) { return state.known.prisms.contains(mesh); });
  return meshes;
}

bool lacksBodies(const State& state) {
  return !state.known.bodies && someRefract(*state.scene, RefractionKind::traced, state.settings.refraction);
}

bool lacksTriangles(const State& state) { return !state.known.triangles && state.settings.self_reflection; }

bool lacksRays(const State& state) {
  const bool lights_ground = state.settings.proxy.kind == ProxyKind::ground && hasCaustics(*state.scene);
  return !state.known.rays && (state.picks || lights_ground);
}

bool lacksCasters(const State& state) { return !state.known.casters && state.settings.proxy.kind == ProxyKind::ground; }

/// The light of a ground's shadow.
bool lacksSampler(const State& state) {
  return state.environment != nullptr && state.settings.proxy.kind == ProxyKind::ground;
}

bool lacksCubes(const State& state) { return state.lacks_cubes != nullptr; }

Result<void> makeForm(State& state) {
  if (state.has_form) return {};
  MIRRORBALL_TRY_VOID(prepareScene(*state.scene, state.preparation, state.means));
  state.has_form = state.makes_form = true;
  return {};
}

Result<void> makePrisms(State& state) {
  for (const int mesh : lackingPrisms(state)) state.made.prisms[mesh] = prismList(*state.scene, mesh);
  return {};
}

Result<void> makeBodies(State& state) {
  if (!lacksBodies(state)) return {};
  MIRRORBALL_TRY(tree, bodyTree(*state.scene));
  state.made.bodies = std::move(tree);
  return {};
}

Result<void> makeTriangles(State& state) {
  if (!lacksTriangles(state)) return {};
  MIRRORBALL_TRY(tree, sceneTree(*state.scene));
  state.made.triangles = std::move(tree);
  return {};
}

Result<void> makeRays(State& state) {
  if (!lacksRays(state)) return {};
  MIRRORBALL_TRY(rays, SceneRays::make(state.scene));
  state.made.rays = std::move(rays);
  return {};
}

Result<void> makeGroundShadow(State& state) {
  if (lacksCasters(state)) state.made.casters = shadowCasters(*state.scene);
  if (!lacksSampler(state)) return {};
  MIRRORBALL_TRY(sampler, makeGroundSampler(*state.environment));
  state.ground_sampler = std::move(sampler);
  return {};
}

Result<void> makeCubes(State& state) {
  if (!lacksCubes(state)) return {};
  MIRRORBALL_TRY(
      made, prepareEnvironment(*state.lacks_cubes, state.means.cache, state.means.progress, state.settings.sunShown()));
  state.cubes = std::move(made);
  return {};
}

/// Of which none needs another.
constexpr std::array<Result<void> (*)(State&), 6> kRows = {makePrisms, makeBodies,       makeTriangles,
                                                           makeRays,   makeGroundShadow, makeCubes};
constexpr std::size_t kAll = kOfForm + kRows.size() * kOfRow;

}  // namespace

bool StageWork::isNeeded() const {
  const State& state = *state_;
  return lacksForm(state) || !lackingPrisms(state).empty() || lacksBodies(state) || lacksTriangles(state) ||
         lacksRays(state) || lacksCasters(state) || lacksSampler(state) || lacksCubes(state);
}

Result<void> StageWork::run(const ProgressFunction& progress) {
  State& state = *state_;
  state.means.progress = partOf(progress, 0, kOfForm, kAll);
  MIRRORBALL_TRY_VOID(makeForm(state));
  std::mutex telling;
  std::size_t done = 0;
  bool is_stopped = false;
  const auto goesOn = [&](std::size_t rows) {
    const std::lock_guard one_at_a_time(telling);
    done += rows;
    is_stopped = is_stopped || (progress && !progress(kOfForm + done * kOfRow, kAll));
    return !is_stopped;
  };
  state.means.progress = [&](std::size_t, std::size_t) { return goesOn(0); };
  std::array<Result<void>, kRows.size()> made;
  // Most of a row's work is done by one thread.
  parallelFor(kRows.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && goesOn(0); ++row) {
      made[row] = kRows[row](state);
      goesOn(1);
    }
  });
  for (Result<void>& row : made) MIRRORBALL_TRY_VOID(std::move(row));
  if (is_stopped) return fail(ErrorCode::interrupted, "interrupted");
  return {};
}

}  // namespace mirrorball
