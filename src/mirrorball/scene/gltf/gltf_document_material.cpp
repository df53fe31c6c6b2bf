#include "mirrorball/scene/gltf/gltf_document_material.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "formula/bsdf.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {
namespace {

float notNegative(const JsonReader& value, float otherwise) {
  return static_cast<float>(std::max(value.number(otherwise), 0.0));
}

TextureSlot parseSlot(const JsonReader& json) {
  TextureSlot slot;
  if (!json.exists()) return slot;
  slot.texture = json["index"].required().index();
  slot.uv_set = std::max(json["texCoord"].index(), 0);
  if (const JsonReader transform = json["extensions"]["KHR_texture_transform"]; transform.exists()) {
    const std::vector<double> offset = transform["offset"].numbers({0, 0});
    const std::vector<double> scale = transform["scale"].numbers({1, 1});
    slot.offset = glm::vec2(offset[0], offset[1]);
    slot.scale = glm::vec2(scale[0], scale[1]);
    slot.rotation_rad = static_cast<float>(transform["rotation"].number(0));
    if (transform["texCoord"].exists()) slot.uv_set = transform["texCoord"].index();  // overrides the one outside
  }
  return slot;
}

/// A colour's numbers, of which some programs write three for four, or four for three (Unity-glTF-Exporter issue 18):
/// red, green and blue are the first in both.
///
/// key        of the colour in the material; not copied
/// otherwise  three or four numbers
std::vector<double> readColor(const JsonReader& material, std::string_view key, std::vector<double> otherwise,
                              std::vector<std::string_view>& miscounted) {
  const JsonReader color = material.at(key);
  const std::size_t count = color.isArray() ? color.elements().size() : 0;
  const std::size_t wanted = otherwise.size();
  if (count == wanted || (count != 3 && count != 4)) return color.numbers(std::move(otherwise));
  miscounted.push_back(key);
  const double alpha = otherwise.back();
  otherwise.resize(count, 1.0);
  std::vector<double> numbers = color.numbers(std::move(otherwise));
  numbers.resize(wanted, alpha);
  return numbers;
}

/// A parameter as glTF has it, cut to its range; what the file does not say stays as it is.
void readParameter(const MaterialParameter& parameter, const JsonReader& json, FileMaterial& read) {
  Material& material = read.material;
  const JsonReader value = json.at(parameter.gltf);
  std::vector<double> numbers;
  if (const auto* number = std::get_if<float Material::*>(&parameter.field)) {
    numbers = {value.number(material.**number)};
  } else if (const auto* flag = std::get_if<bool Material::*>(&parameter.field)) {
    numbers = {value.flag(material.**flag) ? 1.0 : 0.0};
  } else if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field)) {
    const glm::vec3 before = material.**color;
    numbers = {before.x, before.y, before.z};
    if (gltfNumbers(parameter) == 4) numbers.push_back(material.opacity);
    numbers = readColor(json, parameter.gltf, std::move(numbers), read.miscounted);
  }
  setGltfNumbers(parameter, numbers, material);
}

/// An infinite index reflects all light along the normal, so that the specular colour alone is the reflectance there,
/// and it grows by Schlick's form: as one of the usual index does whose colour is divided by that index's reflectance.
void setInfiniteIndex(Material& material) {
  material.ior = defaultMaterial().ior;
  material.specular_color /= formula::fresnelDielectric(1.0f, material.ior);
  material.fresnel = formula::kFresnelSchlick;
}

/// KHR_materials_ior, where 0 stands for an infinite index.
void readIndex(const JsonReader& json, Material& material) {
  if (material.ior >= 1.0f) return;
  material.ior = defaultMaterial().ior;
  if (json["extensions"]["KHR_materials_ior"]["ior"].number(1.0) == 0.0) setInfiniteIndex(material);
}

/// KHR_materials_pbrSpecularGlossiness of a material that has it, as KHR_materials_specular says that it is converted:
/// a dielectric of infinite index, whose specular colour is the model's, and whose base is weighed by what that leaves.
/// Nothing is lost, nor do the two textures need to be alike, as where the share of metal is solved for.
void readSpecularGlossiness(const JsonReader& material_json, FileMaterial& read) {
  const JsonReader json = material_json["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  if (!json.exists()) return;
  const auto share = [](double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); };
  const std::vector<double> diffuse = readColor(
      material_json, "extensions.KHR_materials_pbrSpecularGlossiness.diffuseFactor", {1, 1, 1, 1}, read.miscounted);
  const std::vector<double> specular = readColor(
      material_json, "extensions.KHR_materials_pbrSpecularGlossiness.specularFactor", {1, 1, 1}, read.miscounted);
  const float glossiness = share(json["glossinessFactor"].number(1.0));
  Material& material = read.material;
  material.metallic = 0.0f;
  material.base_color = {share(diffuse[0]), share(diffuse[1]), share(diffuse[2])};
  material.opacity = share(diffuse[3]);
  material.specular = 1.0f;
  material.specular_color = {share(specular[0]), share(specular[1]), share(specular[2])};
  setInfiniteIndex(material);
  material.base_color_map = parseSlot(json["diffuseTexture"]);
  material.specular_color_map = parseSlot(json["specularGlossinessTexture"]);
  material.metallic_map = material.specular_map = {};
  material.roughness_map = material.specular_color_map;
  const bool is_textured = material.roughness_map.texture >= 0;
  material.perceptual_roughness = is_textured ? 1.0f : 1.0f - glossiness;
  if (is_textured) read.glossiness = glossiness;
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

FileMaterial parseMaterial(const JsonReader& json) {
  FileMaterial read{.material = defaultMaterial()};
  Material& material = read.material;
  material.name = json["name"].text("");
  const std::string alpha_mode = lowerCase(json["alphaMode"].text("OPAQUE"));
  if (alpha_mode == "mask")
    material.alpha_mode = AlphaMode::mask;
  else if (alpha_mode == "blend")
    material.alpha_mode = AlphaMode::blend;
  else if (alpha_mode != "opaque")
    json["alphaMode"].refuse("is not OPAQUE, MASK or BLEND");
  for (const MaterialParameter& parameter : materialParameters())
    if (!parameter.gltf.empty()) readParameter(parameter, json, read);
  for (const MaterialMap& map : materialMaps()) material.*map.slot = parseSlot(json.at(map.gltf));
  readIndex(json, material);
  const JsonReader extensions = json["extensions"];
  read.emissive_factor = material.emission;
  read.emissive_strength = notNegative(extensions["KHR_materials_emissive_strength"]["emissiveStrength"], 1.0f);
  material.emission = glm::min(material.emission * read.emissive_strength, kBrightestEmission);
  // KHR_materials_volume: what has no thickness is an infinitely thin sheet.
  read.is_sheet = notNegative(extensions["KHR_materials_volume"]["thicknessFactor"], 0.0f) == 0.0f;
  material.thin_walled = material.transmission > 0.0f && read.is_sheet;
  readSpecularGlossiness(json, read);
  if (material.alpha_mode == AlphaMode::opaque) material.opacity = 1.0f;
  if (extensions["KHR_materials_unlit"].exists()) return {.material = unlitOf(material)};
  return read;
}

void tellOfMiscounted(std::span<const FileMaterial> materials, Remarks& remarks) {
  for (std::size_t i = 0; i < materials.size(); ++i)
    for (const std::string_view key : materials[i].miscounted)
      remarks.tellOnce(quoted("materials", i) + "." + std::string(key),
                       "has three numbers for four or four for three; its red, green and blue are read");
}

}  // namespace mirrorball::gltf
