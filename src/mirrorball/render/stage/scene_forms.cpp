#include "mirrorball/render/stage/scene_forms.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "mirrorball/render/stage/scene_difference.h"

namespace mirrorball {
namespace {

/// Gives a material the heights of another one: its own as they were prepared.
void takeHeights(Material& material, const Material& prepared) {
  material.height = prepared.height;
  material.height_texture = prepared.height_texture;
  material.height_scale = prepared.height_scale;
  material.height_frequency = prepared.height_frequency;
}

/// Tells the instances of a form which nodes show them.
void takeNodes(Scene& form, const Scene& given) {
  for (std::size_t i = 0; i < form.instances.size(); ++i) form.instances[i].node = given.instances[i].node;
}

}  // namespace

// Of an empty scene nothing is on the GPU.
SceneForms::SceneForms() : given_(std::make_shared<Scene>()), as_given_(*StagedScene::make(given_)) {}

Result<void> SceneForms::set(Scene scene, const LevelsOfMaps& levels) {
  auto now = std::make_shared<Scene>(std::move(scene));
  const unsigned changed = differingParts(*given_, *now);
  MIRRORBALL_TRY_VOID(as_given_->become(now, changed, nullptr, levels));
  const std::shared_ptr<Scene> before = std::exchange(given_, std::move(now));
  std::erase_if(forms_, [&](Form& form) { return !follow(form, *before, changed, levels); });
  versions_.change(changed);
  return {};
}

bool SceneForms::follow(Form& form, const Scene& before, unsigned changed, const LevelsOfMaps& levels) {
  // What vertices know of a scene depends on all of it but its lamps, which are not in the environment.
  if (form.preparation.finds_occlusion && (changed & ~StagePart::lights) != 0) return false;
  if (!haveSameRelief(before, *given_)) return false;
  auto now = std::make_shared<Scene>(*given_);
  now->meshes = form.scene->meshes;
  now->height_textures = form.scene->height_textures;
  for (std::size_t i = 0; i < now->materials.size(); ++i) takeHeights(now->materials[i], form.scene->materials[i]);
  // As prepareScene does: what was known is of other vertices.
  if (form.preparation.relief == ReliefKind::geometry) forgetOcclusion(*now);
  if (form.preparation.finds_occlusion) now->instances = form.scene->instances;
  takeNodes(*now, *given_);
  if (!form.staged->become(now, changed, as_given_.get(), levels)) return false;
  form.scene = std::move(now);
  return true;
}

bool SceneForms::knowsOcclusion() const {
  return std::any_of(given_->instances.begin(), given_->instances.end(),
                     [](const Instance& each) { return !each.occlusion.empty(); });
}

Result<void> SceneForms::setMaterial(std::size_t index, Material material) {
  if (knowsOcclusion() || !haveSameBuffers(given_->materials[index], material)) {
    Scene changed = *given_;
    forgetOcclusion(changed);
    changed.materials[index] = std::move(material);
    return set(std::move(changed));
  }
  std::erase_if(forms_, [](const Form& form) { return form.preparation.finds_occlusion; });
  const Material before = std::exchange(given_->materials[index], material);
  as_given_->materialChanged(index, before);
  for (Form& form : forms_) {
    Material changed = material;
    Material& prepared = form.scene->materials[index];
    takeHeights(changed, prepared);
    const Material prepared_before = std::exchange(prepared, std::move(changed));
    form.staged->materialChanged(index, prepared_before);
  }
  versions_.change(StagePart::materials);
  return {};
}

Result<void> SceneForms::setTransform(std::size_t instance, const glm::mat4& world_from_object) {
  if (given_->instances[instance].world_from_object == world_from_object) return {};
  if (knowsOcclusion()) {
    Scene changed = *given_;
    forgetOcclusion(changed);
    changed.instances[instance].world_from_object = world_from_object;
    return set(std::move(changed));
  }
  std::erase_if(forms_, [](const Form& form) { return form.preparation.finds_occlusion; });
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
  if (lights.size() != given_->lights.size()) given_->rig.light_nodes.clear();
  given_->lights = std::move(lights);
  as_given_->lightsChanged();
  for (Form& form : forms_) {
    form.scene->lights = given_->lights;
    form.staged->lightsChanged();
  }
  versions_.change(StagePart::lights);
}

std::shared_ptr<StagedScene> SceneForms::find(const ScenePreparation& preparation) {
  if (isPrepared(*given_, preparation)) return as_given_;
  const auto known =
      std::find_if(forms_.begin(), forms_.end(), [&](const Form& form) { return form.preparation == preparation; });
  if (known == forms_.end()) return nullptr;
  std::rotate(known, known + 1, forms_.end());
  return forms_.back().staged;
}

Result<std::shared_ptr<StagedScene>> SceneForms::add(const ScenePreparation& preparation,
                                                     std::shared_ptr<Scene> scene) {
  constexpr std::ptrdiff_t kMostUnused = 2;
  takeNodes(*scene, *given_);
  MIRRORBALL_TRY(staged, StagedScene::make(scene, as_given_.get()));
  const auto is_unused = [](const Form& form) { return form.staged.use_count() == 1; };
  if (std::count_if(forms_.begin(), forms_.end(), is_unused) > kMostUnused)
    forms_.erase(std::find_if(forms_.begin(), forms_.end(), is_unused));
  forms_.push_back({preparation, std::move(scene), staged});
  return staged;
}

}  // namespace mirrorball
