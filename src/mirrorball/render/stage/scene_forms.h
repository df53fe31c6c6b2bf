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
/// ask for. They share its textures.
class SceneForms {
 public:
  SceneForms();

  /// Shows another scene.
  ///
  /// errors   too_large (a texture for this driver); then it is as before
  Result<void> set(Scene scene);

  /// errors   too_large, and those of preparing it again; then it is as before
  Result<void> setMaterial(std::size_t index, Material material);
  /// errors   too_large; then it is as before
  Result<void> setTransform(std::size_t instance, const glm::mat4& world_from_object);
  void setLights(std::vector<ModelLight> lights);

  /// As it was given, with its changes.
  const Scene& scene() const { return *given_; }
  /// Of it.
  const BoundingSphere& bounds() const { return as_given_->bounds(); }
  /// Another number after each change.
  std::uint64_t version() const { return versions_.of(StagePart::scene); }

  /// The form that frames show, made when they first ask for it; kept while it is held, and the last few longer.
  ///
  /// errors   as prepareScene's; too_large (a texture for this driver)
  Result<std::shared_ptr<StagedScene>> formFor(const ScenePreparation& preparation, const PreparationMeans& means);

 private:
  Result<void> forgetGivenOcclusion();

  struct Form {
    ScenePreparation preparation;
    std::shared_ptr<Scene> scene;
    std::shared_ptr<StagedScene> staged;
  };

  std::shared_ptr<Scene> given_;
  std::shared_ptr<StagedScene> as_given_;
  std::vector<Form> forms_;  ///< others, the last that was asked for at the end
  StageVersions versions_;
};

}  // namespace mirrorball
