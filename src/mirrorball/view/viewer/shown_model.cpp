#include "mirrorball/view/viewer/shown_model.h"

#include <utility>

#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {

bool ShownModel::follow(const Workspace& workspace, bool inside_only) {
  loading_.askFor(workspace.model, [inside_only](const std::string& name, const ProgressFunction& progress) {
    return loadedModel(name, inside_only, progress);
  });
  const bool is_other = take();
  // What is said of materials is said of the model that is asked for.
  if (!isThere() || hasMaterials(workspace) || loading_.isRunning() || !loading_.problem().empty()) return is_other;
  const auto changed = changeMaterialsTo(workspace);
  problem_ = changed ? std::string() : changed.error().message;
  changed_for_ = workspace;
  return is_other;
}

bool ShownModel::take() {
  auto ready = loading_.take();
  if (!ready) return false;
  watch_.watch(ready->scene.files);
  changed_ = optioned_ = loaded_ = std::move(ready->scene);
  levels_ = std::move(ready->levels);
  hides_itself_ = ready->hides_itself;
  optioned_for_.clear();
  changed_for_.reset();
  problem_.clear();
  ++version_;
  return true;
}

bool ShownModel::isUpToDate(const Workspace& workspace) const {
  if (!loading_.isAskedFor(workspace.model) || loading_.isRunning()) return false;
  return !loading_.problem().empty() || hasMaterials(workspace);
}

SceneTraits ShownModel::traits() const {
  SceneTraits traits = traitsOf(changed_);
  traits.hides_itself = hides_itself_;
  traits.can_trace_rays = true;
  return traits;
}

bool ShownModel::hasMaterials(const Workspace& workspace) const {
  if (!changed_for_) return workspace.materials.empty() && workspace.parameters.empty();
  return changed_for_->materials == workspace.materials && changed_for_->parameters == workspace.parameters;
}

/// errors   usage: then they are as before
Result<void> ShownModel::changeMaterialsTo(const Workspace& workspace) {
  if (optioned_for_ != workspace.materials) {
    MIRRORBALL_TRY(changes, materialsOf(workspace.materials));
    Scene optioned = loaded_;
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
