#include "mirrorball/render/stage/scene_forms.h"

#include <algorithm>
#include <cstddef>
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

/// What vertices know of the scene depends on all of it.
Result<void> SceneForms::forgetGivenOcclusion() {
  std::erase_if(forms_, [](const Form& form) { return form.preparation.finds_occlusion; });
  const auto known = [](const Instance& each) { return !each.occlusion.empty(); };
  if (std::none_of(given_->instances.begin(), given_->instances.end(), known)) return {};
  auto forgotten = std::make_shared<Scene>(*given_);
  forgetOcclusion(*forgotten);
  MIRRORBALL_TRY(staged, StagedScene::make(forgotten, as_given_.get()));
  given_ = std::move(forgotten);
  as_given_ = std::move(staged);
  return {};
}

Result<void> SceneForms::setMaterial(std::size_t index, Material material) {
  MIRRORBALL_TRY_VOID(forgetGivenOcclusion());
  versions_.change(StagePart::materials);
  if (!haveSameBuffers(given_->materials[index], material)) {
    // Views may still hold the old form, which stays as it is.
    auto changed = std::make_shared<Scene>(*given_);
    changed->materials[index] = std::move(material);
    MIRRORBALL_TRY(staged, StagedScene::make(changed, as_given_.get()));
    given_ = std::move(changed);
    as_given_ = std::move(staged);
    forms_.clear();
    return {};
  }
  const Material before = std::exchange(given_->materials[index], material);
  as_given_->materialChanged(index, before);
  for (Form& form : forms_) {
    Material changed = material;
    Material& prepared = form.scene->materials[index];
    changed.height = prepared.height;
    changed.height_texture = prepared.height_texture;
    changed.height_scale = prepared.height_scale;
    const Material prepared_before = std::exchange(prepared, std::move(changed));
    form.staged->materialChanged(index, prepared_before);
  }
  return {};
}

Result<void> SceneForms::setTransform(std::size_t instance, const glm::mat4& world_from_object) {
  if (given_->instances[instance].world_from_object == world_from_object) return {};
  MIRRORBALL_TRY_VOID(forgetGivenOcclusion());
  given_->instances[instance].world_from_object = world_from_object;
  as_given_->transformChanged(instance);
  for (Form& form : forms_) {
    form.scene->instances[instance].world_from_object = world_from_object;
    form.staged->transformChanged(instance);
  }
  versions_.change(StagePart::transforms);
  return {};
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
  constexpr std::ptrdiff_t kMostUnused = 2;
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
  const auto is_unused = [](const Form& form) { return form.staged.use_count() == 1; };
  if (std::count_if(forms_.begin(), forms_.end(), is_unused) > kMostUnused)
    forms_.erase(std::find_if(forms_.begin(), forms_.end(), is_unused));
  forms_.push_back({preparation, std::move(scene), staged});
  return staged;
}

}  // namespace mirrorball
