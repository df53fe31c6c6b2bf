#include "mirrorball/scene/gltf/gltf_document_material.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace mirrorball::gltf {
namespace {

float notNegative(const JsonReader& value, float otherwise) {
  return static_cast<float>(std::max(value.number(otherwise), 0.0));
}

TextureSlot parseSlot(const JsonReader& json) {
  TextureSlot slot;
  if (!json.exists()) return slot;
  slot.texture = json["index"].required().index();
  slot.uv_set = static_cast<int>(json["texCoord"].size(0));
  if (const JsonReader transform = json["extensions"]["KHR_texture_transform"]; transform.exists()) {
    const std::vector<double> offset = transform["offset"].numbers({0, 0});
    const std::vector<double> scale = transform["scale"].numbers({1, 1});
    slot.offset = glm::vec2(offset[0], offset[1]);
    slot.scale = glm::vec2(scale[0], scale[1]);
    slot.rotation_rad = static_cast<float>(transform["rotation"].number(0));
    if (transform["texCoord"].exists()) slot.uv_set = transform["texCoord"].index();  // overrides the one outside
  }
  if (slot.uv_set > 1) json["texCoord"].refuse("is above 1; only the sets 0 and 1 are read");
  return slot;
}

/// A parameter as glTF has it, cut to its range; what the file does not say stays as it is.
void readParameter(const MaterialParameter& parameter, const JsonReader& json, Material& material) {
  const JsonReader value = json.at(parameter.gltf);
  const auto inRange = [&](double number) {
    return static_cast<float>(std::clamp(number, parameter.text.minimum, parameter.text.maximum));
  };
  if (const auto* number = std::get_if<float Material::*>(&parameter.field)) {
    material.** number = inRange(value.number(material.**number));
  } else if (const auto* flag = std::get_if<bool Material::*>(&parameter.field)) {
    material.** flag = value.flag(material.**flag);
  } else if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field)) {
    const glm::vec3 before = material.**color;
    std::vector<double> numbers{before.x, before.y, before.z};
    if (*color == &Material::base_color) numbers.push_back(material.opacity);
    numbers = value.numbers(numbers);
    material.** color = {inRange(numbers[0]), inRange(numbers[1]), inRange(numbers[2])};
    if (numbers.size() == 4) material.opacity = static_cast<float>(std::clamp(numbers[3], 0.0, 1.0));
  }
}

}  // namespace

Material defaultMaterial() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = 1.0f;
  return material;
}

Material parseMaterial(const JsonReader& json) {
  Material material = defaultMaterial();
  material.name = json["name"].text("");
  for (const MaterialParameter& parameter : materialParameters())
    if (!parameter.gltf.empty()) readParameter(parameter, json, material);
  // An index of 0 asks for the specular-glossiness model's mirror; it is read as the default.
  if (material.ior < 1.0f) material.ior = defaultMaterial().ior;
  material.emission *= notNegative(json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 1.0f);
  // KHR_materials_volume: what has no thickness is an infinitely thin sheet.
  const JsonReader volume = json["extensions"]["KHR_materials_volume"];
  material.thin_walled = material.transmission > 0.0f && notNegative(volume["thicknessFactor"], 0.0f) == 0.0f;
  const std::string alpha_mode = json["alphaMode"].text("OPAQUE");
  if (alpha_mode == "MASK") material.alpha_mode = AlphaMode::mask;
  if (alpha_mode == "BLEND") material.alpha_mode = AlphaMode::blend;
  if (material.alpha_mode == AlphaMode::opaque) material.opacity = 1.0f;
  for (const MaterialMap& map : materialMaps()) material.*map.slot = parseSlot(json.at(map.gltf));
  return material;
}

}  // namespace mirrorball::gltf
