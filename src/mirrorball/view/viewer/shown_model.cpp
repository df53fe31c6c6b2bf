#include "mirrorball/view/viewer/shown_model.h"

#include <utility>

#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {

bool ShownModel::follow(const Workspace& workspace, bool inside_only) {
  const bool has_begun =
      loading_.askFor(workspace.model, [inside_only](const std::string& name, const ProgressFunction& progress) {
        return loadedModel(name, inside_only, progress);
      });
  if (has_begun) watch_.watch({workspace.model});  // until it is known what was read
  const bool is_other = take();
  // What is said of a model is said of the one that is asked for.
  if (!isThere() || isAs(workspace) || loading_.isRunning() || !loading_.problem().empty()) return is_other;
  const auto changed = changeTo(workspace);
  problem_ = changed ? std::string() : changed.error().message;
  changed_for_ = workspace;
  return is_other;
}

bool ShownModel::take() {
  auto ready = loading_.take();
  if (!ready) return false;
  watch_.watch(ready->scene.files);
  changed_ = optioned_ = standing_ = loaded_ = std::move(ready->scene);
  levels_ = std::move(ready->levels);
  hides_itself_ = ready->hides_itself;
  standing_for_.clear();
  optioned_for_.clear();
  changed_for_.reset();
  problem_.clear();
  ++version_;
  return true;
}

bool ShownModel::isUpToDate(const Workspace& workspace) const {
  if (!loading_.isAskedFor(workspace.model) || loading_.isRunning()) return false;
  return !loading_.problem().empty() || isAs(workspace);
}

SceneTraits ShownModel::traits() const {
  SceneTraits traits = traitsOf(changed_);
  traits.hides_itself = hides_itself_;
  traits.can_trace_rays = true;
  return traits;
}

bool ShownModel::isAs(const Workspace& workspace) const {
  if (!changed_for_) return workspace.stance.empty() && workspace.materials.empty() && workspace.parameters.empty();
  return changed_for_->stance == workspace.stance && changed_for_->materials == workspace.materials &&
         changed_for_->parameters == workspace.parameters;
}

/// errors   usage: then they are as before
Result<void> ShownModel::changeTo(const Workspace& workspace) {
  const bool stands_otherwise = standing_for_ != workspace.stance;
  if (stands_otherwise) {
    MIRRORBALL_TRY(stance, stanceOf(workspace.stance));
    MIRRORBALL_TRY(standing, atMoment(loaded_, stance.animation));
    standUpright(standing, stance.up);
    standing_ = std::move(standing);
    standing_for_ = workspace.stance;
  }
  if (stands_otherwise || optioned_for_ != workspace.materials) {
    MIRRORBALL_TRY(changes, materialsOf(workspace.materials));
    Scene optioned = standing_;
    MIRRORBALL_TRY_VOID(changeMaterials(optioned, changes));
    optioned_ = std::move(optioned);
    optioned_for_ = workspace.materials;
  }
  Scene changed = optioned_;
  MIRRORBALL_TRY_VOID(changeParameters(changed, workspace));
  changed_ = std::move(changed);
  ++version_;
  return {};
}

}  // namespace mirrorball
