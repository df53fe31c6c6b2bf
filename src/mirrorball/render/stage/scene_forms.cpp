#include "mirrorball/render/stage/scene_forms.h"

#include <algorithm>
#include <utility>

namespace mirrorball {

// Of an empty scene nothing is on the GPU.
SceneForms::SceneForms() : given_(std::make_shared<Scene>()), as_given_(*StagedScene::make(given_)) {}

Result<void> SceneForms::set(Scene scene) {
  auto given = std::make_shared<Scene>(std::move(scene));
  MIRRORBALL_TRY(staged, StagedScene::make(given));
  given_ = std::move(given);
  as_given_ = std::move(staged);
  forms_.clear();
  versions_.change(StagePart::scene);
  return {};
}

Result<void> SceneForms::setMaterial(std::size_t index, Material material) {
  Material& shown = given_->materials[index];
  const bool is_alike = areDrawnAlike(shown, material);
  std::swap(shown, material);
  if (!is_alike) {
    auto staged = StagedScene::make(given_, as_given_.get());
    if (!staged) {
      shown = std::move(material);
      return fail(std::move(staged));
    }
    as_given_ = std::move(*staged);
  } else {
    as_given_->materialChanged(index);
  }
  // What vertices know of the scene depends on all materials.
  std::erase_if(forms_, [&](const Form& form) { return !is_alike || form.preparation.finds_occlusion; });
  for (Form& form : forms_) {
    Material& prepared = form.scene->materials[index];
    Material changed = given_->materials[index];
    changed.height = prepared.height;
    changed.height_texture = prepared.height_texture;
    changed.height_scale = prepared.height_scale;
    prepared = std::move(changed);
    form.staged->materialChanged(index);
  }
  versions_.change(StagePart::materials);
  return {};
}

void SceneForms::setTransform(std::size_t instance, const glm::mat4& world_from_object) {
  glm::mat4& shown = given_->instances[instance].world_from_object;
  if (shown == world_from_object) return;
  shown = world_from_object;
  as_given_->transformChanged(instance);
  std::erase_if(forms_, [](const Form& form) { return form.preparation.finds_occlusion; });
  for (Form& form : forms_) {
    form.scene->instances[instance].world_from_object = world_from_object;
    form.staged->transformChanged(instance);
  }
  versions_.change(StagePart::transforms);
}

void SceneForms::setLights(std::vector<ModelLight> lights) {
  given_->lights = std::move(lights);
  as_given_->lightsChanged();
  for (Form& form : forms_) {
    form.scene->lights = given_->lights;
    form.staged->lightsChanged();
  }
  versions_.change(StagePart::lights);
}

Result<std::shared_ptr<StagedScene>> SceneForms::formFor(const ScenePreparation& preparation,
                                                         const PreparationMeans& means) {
  constexpr std::size_t kMostKept = 3;
  if (isPrepared(*given_, preparation)) return as_given_;
  const auto known =
      std::find_if(forms_.begin(), forms_.end(), [&](const Form& form) { return form.preparation == preparation; });
  if (known != forms_.end()) {
    std::rotate(known, known + 1, forms_.end());
    return forms_.back().staged;
  }
  auto scene = std::make_shared<Scene>(*given_);
  MIRRORBALL_TRY_VOID(prepareScene(*scene, preparation, means));
  MIRRORBALL_TRY(staged, StagedScene::make(scene, as_given_.get()));
  if (forms_.size() == kMostKept) forms_.erase(forms_.begin());
  forms_.push_back({preparation, std::move(scene), staged});
  return staged;
}

}  // namespace mirrorball
