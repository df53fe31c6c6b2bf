#include "mirrorball/render/stage/scene_preparation.h"

#include <algorithm>

#include "mirrorball/rays/occlusion_cache.h"

namespace mirrorball {
namespace {

ReliefKind preparedAlike(ReliefKind kind) {
  if (kind == ReliefKind::geometry || kind == ReliefKind::cone) return kind;
  return movesSurface(kind) ? ReliefKind::steep : ReliefKind::bump;
}

/// Whether a material shows heights of a texture by that kind of relief, which it has not yet.
bool lacksHeights(const Material& material, ReliefKind relief) {
  if (material.height == HeightKind::none) return false;
  const bool is_bump_of_orange = material.height == HeightKind::orange && relief == ReliefKind::bump;
  if (material.height_texture < 0) return material.height != HeightKind::map && !is_bump_of_orange;
  return material.height_scale < 0.0f || relief == ReliefKind::geometry;
}

bool lacksSearch(const HeightTexture& texture, ReliefKind relief) {
  return texture.picture.empty() || texture.horizons.slopes.empty() ||
         (relief == ReliefKind::cone && texture.cones.empty());
}

bool isReliefPrepared(const Scene& scene, ReliefKind relief) {
  const auto lacks_heights = [&](const Material& each) { return lacksHeights(each, relief); };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), lacks_heights)) return false;
  if (!movesSurface(relief)) return true;
  const auto lacks_search = [&](const HeightTexture& each) { return lacksSearch(each, relief); };
  return std::none_of(scene.height_textures.begin(), scene.height_textures.end(), lacks_search);
}

/// Whether all that is to be found is known of each instance.
bool knowsOcclusion(const Scene& scene, const SceneOcclusionSettings& settings) {
  return std::all_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& each) {
    const bool is_empty = scene.meshes[std::size_t(each.mesh)]->vertices.empty();
    return is_empty || (!each.occlusion.empty() && (!settings.finds_materials || !each.vertex_materials.empty()));
  });
}

}  // namespace

SceneOcclusionSettings occlusionSettingsFor(const FrameSettings& settings) {
  return {.finds_materials = settings.self_reflection, .refines = settings.reflect_at == ReflectAt::fragment};
}

ScenePreparation preparationFor(const FrameSettings& settings) {
  ScenePreparation preparation{.relief = preparedAlike(settings.relief),
                               .finds_occlusion = settings.occlusion != OcclusionKind::none};
  if (preparation.finds_occlusion) preparation.occlusion = occlusionSettingsFor(settings);
  return preparation;
}

bool isPrepared(const Scene& scene, const ScenePreparation& preparation) {
  return isReliefPrepared(scene, preparation.relief) &&
         (!preparation.finds_occlusion || knowsOcclusion(scene, preparation.occlusion));
}

std::vector<int> meshesWithPrisms(const Scene& scene) {
  std::vector<int> meshes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (showsHeightTexture(scene.materials[std::size_t(scene.meshes[i]->material)], ReliefKind::exact))
      meshes.push_back(static_cast<int>(i));
  return meshes;
}

void forgetOcclusion(Scene& scene) {
  for (Instance& instance : scene.instances) {
    instance.occlusion.clear();
    instance.vertex_materials.clear();
    instance.holes.clear();
  }
}

Result<void> prepareScene(Scene& scene, const ScenePreparation& preparation, const PreparationMeans& means) {
  MIRRORBALL_TRY_VOID(prepareRelief(scene, preparation.relief, means.largest_texture));
  if (preparation.relief == ReliefKind::geometry) forgetOcclusion(scene);  // which was of other vertices
  if (!preparation.finds_occlusion || knowsOcclusion(scene, preparation.occlusion)) return {};
  forgetOcclusion(scene);
  return findOcclusionOnce(scene, preparation.occlusion, means.cache, means.progress);
}

}  // namespace mirrorball
