#include "mirrorball/render/surface/scene_blocks.h"

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {
namespace {

/// Every parameter that the block has; what a choice only chooses a part by, it has not.
void setParameters(gl::UniformBlock& block, const Material& material) {
  for (const MaterialParameter& parameter : materialParameters()) {
    const std::string name = "material." + std::string(parameter.text.name);
    if (const auto* number = std::get_if<float Material::*>(&parameter.field)) block.set(name, material.**number);
    if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field)) block.set(name, material.**color);
  }
  block.set("material.sellmeier_b", material.sellmeier_b);
  block.set("material.sellmeier_c", material.sellmeier_c);
  block.set("material.fresnel", material.fresnel);
}

/// KHR_texture_transform: translation · rotation · scale, as the columns of a matrix and an offset.
void setMaps(gl::UniformBlock& block, const Material& material) {
  std::vector<glm::vec4> matrices;
  std::vector<glm::vec4> offsets;
  for (const MaterialMap& map : materialMaps()) {
    const TextureSlot& slot = material.*map.slot;
    const glm::mat2 matrix = uvMatrix(slot);
    matrices.emplace_back(matrix[0], matrix[1]);
    offsets.emplace_back(slot.offset, static_cast<float>(slot.uv_set), 0.0f);
  }
  block.set("map_matrix", std::span<const glm::vec4>(matrices));
  block.set("map_offset", std::span<const glm::vec4>(offsets));
}

void setInstance(gl::UniformBlock& block, const Scene& scene, std::size_t index) {
  const glm::mat4& world_from_object = scene.instances[index].world_from_object;
  block.set("world_from_object", world_from_object);
  block.set("normal_matrix", glm::transpose(glm::inverse(glm::mat3(world_from_object))));
  block.set("instance", static_cast<int>(index));
  block.set("knows_backs", knowsBacks(scene, index) ? 1 : 0);
}

void setMaterialBlock(gl::UniformBlock& block, const Material& material) {
  setParameters(block, material);
  setMaps(block, material);
}

}  // namespace

void SceneBlocks::make(const Scene& scene, const Layout& of_instances, const Layout& of_materials) {
  if (!instances_ && of_instances) {
    instances_.emplace(of_instances, scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) setInstance(instances_->at(i), scene, i);
  }
  if (!materials_ && of_materials) {
    materials_.emplace(of_materials, scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) setMaterialBlock(materials_->at(i), scene.materials[i]);
  }
}

void SceneBlocks::instanceChanged(const Scene& scene, std::size_t index) {
  if (instances_) setInstance(instances_->at(index), scene, index);
}

void SceneBlocks::materialChanged(const Scene& scene, std::size_t index) {
  if (materials_) setMaterialBlock(materials_->at(index), scene.materials[index]);
}

void SceneBlocks::bind(int instance, unsigned instance_point, int material, unsigned material_point) {
  if (instances_) instances_->bind(instance_point, std::size_t(instance));
  if (materials_) materials_->bind(material_point, std::size_t(material));
}

std::size_t SceneBlocks::bytesSent() const {
  return (instances_ ? instances_->bytesSent() : 0) + (materials_ ? materials_->bytesSent() : 0);
}

}  // namespace mirrorball
