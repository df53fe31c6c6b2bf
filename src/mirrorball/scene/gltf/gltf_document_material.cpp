#include "mirrorball/scene/gltf/gltf_document_material.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "formula/bsdf.h"

namespace mirrorball::gltf {
namespace {

constexpr float kBrightest = 1e6f;  // as far as the table of parameters goes

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

/// KHR_materials_ior: an index of 0 stands for an infinite one. It reflects all light along the normal, so that the
/// specular colour alone is its reflectance there, and grows by Schlick's form: as one of the usual index does whose
/// colour is divided by that index's reflectance.
void readIndex(const JsonReader& json, Material& material) {
  const Material usual = defaultMaterial();
  if (material.ior >= 1.0f) return;
  material.ior = usual.ior;
  if (json["extensions"]["KHR_materials_ior"]["ior"].number(1.0) != 0.0) return;
  material.specular_color /= formula::fresnelDielectric(1.0f, usual.ior);
  material.fresnel = formula::kFresnelSchlick;
}

}  // namespace

Material defaultMaterial() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = 1.0f;
  return material;
}

Material unlitOf(const Material& material) {
  Material unlit = defaultMaterial();
  unlit.unlit = true;
  unlit.metallic = 0.0f;
  unlit.perceptual_roughness = 0.9f;
  unlit.name = material.name;
  unlit.base_color = material.base_color;
  unlit.base_color_map = material.base_color_map;
  unlit.opacity = material.opacity;
  unlit.alpha_mode = material.alpha_mode;
  unlit.alpha_cutoff = material.alpha_cutoff;
  unlit.double_sided = material.double_sided;
  return unlit;
}

Material parseMaterial(const JsonReader& json) {
  Material material = defaultMaterial();
  material.name = json["name"].text("");
  for (const MaterialParameter& parameter : materialParameters())
    if (!parameter.gltf.empty()) readParameter(parameter, json, material);
  readIndex(json, material);
  const JsonReader strength = json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
  material.emission = glm::min(material.emission * notNegative(strength, 1.0f), kBrightest);
  // KHR_materials_volume: what has no thickness is an infinitely thin sheet.
  const JsonReader volume = json["extensions"]["KHR_materials_volume"];
  material.thin_walled = material.transmission > 0.0f && notNegative(volume["thicknessFactor"], 0.0f) == 0.0f;
  const std::string alpha_mode = json["alphaMode"].text("OPAQUE");
  if (alpha_mode == "MASK") material.alpha_mode = AlphaMode::mask;
  if (alpha_mode == "BLEND") material.alpha_mode = AlphaMode::blend;
  if (material.alpha_mode == AlphaMode::opaque) material.opacity = 1.0f;
  for (const MaterialMap& map : materialMaps()) material.*map.slot = parseSlot(json.at(map.gltf));
  return json["extensions"]["KHR_materials_unlit"].exists() ? unlitOf(material) : material;
}

}  // namespace mirrorball::gltf
