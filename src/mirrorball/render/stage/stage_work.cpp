#include "mirrorball/render/stage/stage_work.h"

#include <utility>

#include "mirrorball/render/stage/stage_work_state.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/scene/relief/prism_list.h"

namespace mirrorball {

StageWork::StageWork(std::unique_ptr<State> state) : state_(std::move(state)) {}
StageWork::StageWork(StageWork&&) noexcept = default;
StageWork& StageWork::operator=(StageWork&&) noexcept = default;
StageWork::~StageWork() = default;

Result<void> StageWork::run(const ProgressFunction& progress) {
  constexpr std::size_t kOfForm = 700, kOfRest = 100, kAll = kOfForm + 3 * kOfRest;
  State& state = *state_;
  const auto go_on = [&](std::size_t done) -> Result<void> {
    if (!progress || progress(done, kAll)) return {};
    return fail(ErrorCode::interrupted, "interrupted");
  };
  if (!state.has_form) {
    state.means.progress = partOf(progress, 0, kOfForm, kAll);
    MIRRORBALL_TRY_VOID(prepareScene(state.scene, state.preparation, state.means));
    state.has_form = state.makes_form = true;
  }
  MIRRORBALL_TRY_VOID(go_on(kOfForm));
  if (state.settings.relief == ReliefKind::exact)
    for (const int mesh : meshesWithPrisms(state.scene)) state.made.prisms[mesh] = prismList(state.scene, mesh);
  MIRRORBALL_TRY_VOID(go_on(kOfForm + kOfRest));
  if (someRefract(state.scene, RefractionKind::traced, state.settings.refraction)) {
    MIRRORBALL_TRY(tree, bodyTree(state.scene));
    state.made.bodies = std::move(tree);
  }
  MIRRORBALL_TRY_VOID(go_on(kOfForm + 2 * kOfRest));
  if (state.settings.self_reflection) {
    MIRRORBALL_TRY(tree, sceneTree(state.scene));
    state.made.triangles = std::move(tree);
  }
  return go_on(kAll);
}

}  // namespace mirrorball
