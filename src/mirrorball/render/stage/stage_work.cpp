#include "mirrorball/render/stage/stage_work.h"

#include <utility>

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
constexpr std::size_t kAll = kOfForm + 5 * kOfRow;

using State = StageWork::State;

Result<void> makeForm(State& state) {
  if (state.has_form) return {};
  MIRRORBALL_TRY_VOID(prepareScene(*state.scene, state.preparation, state.means));
  state.has_form = state.makes_form = true;
  return {};
}

Result<void> makePrisms(State& state) {
  if (state.settings.relief != ReliefKind::exact) return {};
  for (const int mesh : meshesWithPrisms(*state.scene))
    if (!state.known.prisms.contains(mesh)) state.made.prisms[mesh] = prismList(*state.scene, mesh);
  return {};
}

Result<void> makeBodies(State& state) {
  if (state.known.bodies || !someRefract(*state.scene, RefractionKind::traced, state.settings.refraction)) return {};
  MIRRORBALL_TRY(tree, bodyTree(*state.scene));
  state.made.bodies = std::move(tree);
  return {};
}

Result<void> makeTriangles(State& state) {
  if (state.known.triangles || !state.settings.self_reflection) return {};
  MIRRORBALL_TRY(tree, sceneTree(*state.scene));
  state.made.triangles = std::move(tree);
  return {};
}

Result<void> makeRays(State& state) {
  if (state.known.rays || !state.picks) return {};
  MIRRORBALL_TRY(rays, SceneRays::make(state.scene));
  state.made.rays = std::move(rays);
  return {};
}

Result<void> makeGroundShadow(State& state) {
  if (state.settings.proxy.kind != ProxyKind::ground) return {};
  if (!state.known.casters) state.made.casters = shadowCasters(*state.scene);
  if (!state.environment) return {};
  MIRRORBALL_TRY(sampler, makeGroundSampler(*state.environment));
  state.ground_sampler = std::move(sampler);
  return {};
}

}  // namespace

Result<void> StageWork::run(const ProgressFunction& progress) {
  State& state = *state_;
  state.means.progress = partOf(progress, 0, kOfForm, kAll);
  MIRRORBALL_TRY_VOID(makeForm(state));
  std::size_t done = kOfForm;
  for (const auto make : {makePrisms, makeBodies, makeTriangles, makeRays, makeGroundShadow}) {
    if (progress && !progress(done, kAll)) return fail(ErrorCode::interrupted, "interrupted");
    MIRRORBALL_TRY_VOID(make(state));
    done += kOfRow;
  }
  if (progress && !progress(done, kAll)) return fail(ErrorCode::interrupted, "interrupted");
  return {};
}

}  // namespace mirrorball
