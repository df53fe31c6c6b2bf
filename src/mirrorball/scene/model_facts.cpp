#include "mirrorball/scene/model_facts.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_document_material.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

bool isBlack(const Material& material) {
  return material.base_color == glm::vec3(0.0f) && material.emission == glm::vec3(0.0f) &&
         material.transmission == 0.0f && material.conductor_k == glm::vec3(0.0f);
}

bool isInvisible(const Material& material) {
  return material.alpha_mode != AlphaMode::opaque && material.opacity == 0.0f;
}

bool hasMaps(const Material& material) {
  const auto& maps = materialMaps();
  return std::any_of(maps.begin(), maps.end(),
                     [&](const MaterialMap& map) { return (material.*map.slot).texture >= 0; });
}

bool allOf(const Scene& scene, bool (*is)(const Material&)) {
  if (scene.instances.empty()) return false;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (!is(materialOf(scene, i))) return false;
  return true;
}

}  // namespace

std::vector<MaterialFacts> materialFacts(const Scene& scene) {
  std::vector<MaterialFacts> all;
  const Material usual = gltf::defaultMaterial();
  for (const Material& material : scene.materials) {
    MaterialFacts& facts = all.emplace_back();
    facts.name = material.name;
    for (const MaterialParameter& parameter : materialParameters())
      if (std::string value = written(parameter, material); value != written(parameter, usual))
        facts.parameters.emplace_back(parameter.text.name, std::move(value));
    for (const MaterialMap& map : materialMaps()) {
      const int texture = (material.*map.slot).texture;
      if (texture < 0) continue;
      const SharedPicture& picture = scene.textures[std::size_t(texture)].image;
      facts.maps.push_back({map.name, {picture.width(), picture.height()}, picture.hasNumbers()});
    }
  }
  return all;
}

std::size_t triangleCount(const Scene& scene) {
  std::size_t corners = 0;
  for (const Instance& instance : scene.instances) corners += scene.meshes[std::size_t(instance.mesh)]->indices.size();
  return corners / 3;
}

std::vector<std::string> likelyMistakes(const Scene& scene) {
  constexpr float kSmall = 1e-3f, kLarge = 1e3f;  // metres, in glTF
  std::vector<std::string> mistakes;
  if (scene.empty()) return mistakes;
  if (allOf(scene, isBlack)) mistakes.emplace_back("all base colours are black, and nothing glows: it only mirrors");
  if (allOf(scene, isInvisible)) mistakes.emplace_back("all of it has an opacity of 0: nothing is seen");
  const bool has_coordinates = std::any_of(scene.meshes.begin(), scene.meshes.end(), hasTextureCoordinates);
  const bool has_maps = std::any_of(scene.materials.begin(), scene.materials.end(), hasMaps);
  if (has_maps && !has_coordinates)
    mistakes.emplace_back("it has pictures but no texture coordinates: each shows one texel");
  const float radius = boundingSphere(scene).radius;
  if (radius > 0.0f && radius < kSmall)
    mistakes.emplace_back("its radius is less than a millimetre, if its unit is the metre");
  if (radius > kLarge) mistakes.emplace_back("its radius is more than a kilometre, if its unit is the metre");
  return mistakes;
}

}  // namespace mirrorball
