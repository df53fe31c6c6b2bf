#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/render/stage/staged_scene.h"

namespace mirrorball {

/// A scene in all forms that frames show it in: as it was given, and with the relief or the occlusion that some frames
/// ask for. What they have in common is there once.
class SceneForms {
 public:
  SceneForms();

  /// Shows another scene. What it shares with the one before stays, as do forms that are the same for both.
  ///
  /// levels   of textures, where they were made before
  /// errors   too_large (a texture for this driver); then it is as before
  Result<void> set(Scene scene, const LevelsOfMaps& levels = {});

  /// errors   too_large; then it is as before
  Result<void> setMaterial(std::size_t index, Material material);
  /// errors   too_large; then it is as before
  Result<void> setTransform(std::size_t instance, const glm::mat4& world_from_object);
  void setLights(std::vector<ModelLight> lights);

  /// As it was given, with its changes.
  const Scene& scene() const { return *given_; }
  /// Of it.
  const BoundingSphere& bounds() const { return as_given_->bounds(); }
  /// Another number after each change of these parts of StagePart::scene.
  std::uint64_t version(unsigned parts = StagePart::scene) const { return versions_.of(parts); }

  /// The form that frames show; null: it is not there yet. It is kept while it is held, and the last few longer.
  std::shared_ptr<StagedScene> find(const ScenePreparation& preparation);
  /// Takes a form that was made elsewhere: prepareScene() of this scene.
  ///
  /// errors   too_large (a texture for this driver)
  Result<std::shared_ptr<StagedScene>> add(const ScenePreparation& preparation, std::shared_ptr<Scene> prepared);

 private:
  struct Form {
    ScenePreparation preparation;
    std::shared_ptr<Scene> scene;
    std::shared_ptr<StagedScene> staged;
  };
  bool knowsOcclusion() const;
  /// Makes a form one of the scene as it is now, if what it was prepared for is still so.
  ///
  /// returns  whether it is
  bool follow(Form& form, const Scene& before, unsigned changed, const LevelsOfMaps& levels);

  std::shared_ptr<Scene> given_;
  std::shared_ptr<StagedScene> as_given_;
  std::vector<Form> forms_;  ///< others, the last that was asked for at the end
  StageVersions versions_;
};

}  // namespace mirrorball
