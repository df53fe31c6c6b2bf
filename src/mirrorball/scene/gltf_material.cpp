#include "mirrorball/scene/gltf_material.h"

#include <algorithm>
#include <span>

#include "mirrorball/scene/picture_decoding.h"

namespace mirrorball {
namespace {

std::string quoted(const char* array, int index) { return std::string(array) + "[" + std::to_string(index) + "]"; }

/// A number of the JSON as a float; far beyond what any factor means it is cut, so that the cast is defined.
float toFloat(double number) { return static_cast<float>(std::clamp(number, -1e30, 1e30)); }
float toShare(double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); }

/// A number of an extension's object.
float numberOr(const tinygltf::Value& object, const char* key, float otherwise) {
  if (!object.Has(key) || !object.Get(key).IsNumber()) return otherwise;
  return toFloat(object.Get(key).GetNumberAsDouble());
}

const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

/// The factors of the extensions to the metallic-roughness model.
void applyExtensions(const tinygltf::ExtensionMap& extensions, Material& material) {
  // An index of 0 is the extension's way to ask for a reflectance of 1, which this program's `mirror` stands for: it is
  // read as the default.
  if (const auto* object = extensionOf(extensions, "KHR_materials_ior"))
    if (const float ior = numberOr(*object, "ior", 1.5f); ior >= 1.0f) material.ior = ior;
  if (const auto* object = extensionOf(extensions, "KHR_materials_specular"))
    material.specular = toShare(numberOr(*object, "specularFactor", 1.0f));
  if (const auto* object = extensionOf(extensions, "KHR_materials_transmission"))
    material.transmission = toShare(numberOr(*object, "transmissionFactor", 0.0f));
  if (const auto* object = extensionOf(extensions, "KHR_materials_dispersion"))
    material.dispersion = std::max(numberOr(*object, "dispersion", 0.0f), 0.0f);
  if (const auto* object = extensionOf(extensions, "KHR_materials_emissive_strength"))
    material.emission *= std::max(numberOr(*object, "emissiveStrength", 1.0f), 0.0f);
}

Wrap wrapOf(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  return Wrap::repeat;
}

}  // namespace

Result<int> GltfMaterials::sceneMaterial(int index, const std::string& key) {
  if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
  Material material;
  material.base_color = glm::vec3(1.0f);  // glTF's default material (section 3.9.6): white, and the factors' defaults
  material.metallic = 1.0f;
  material.perceptual_roughness = 1.0f;
  if (index != -1) {
    MIRRORBALL_TRY_VOID(checkIndex(file_, index, file_.model.materials.size(), key, "materials"));
    MIRRORBALL_TRY(converted, convert(index));
    material = std::move(converted);
  }
  scene_.materials.push_back(std::move(material));
  return materials_[index] = static_cast<int>(scene_.materials.size()) - 1;
}

Result<Material> GltfMaterials::convert(int index) {
  const tinygltf::Material& source = file_.model.materials[std::size_t(index)];
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const std::string key = quoted("materials", index);
  Material material;
  material.name = source.name;

  const std::vector<double>& color = pbr.baseColorFactor;
  const std::vector<double>& emission = source.emissiveFactor;
  if (color.size() != 4 || emission.size() != 3)
    return fail(ErrorCode::bad_file, file_.name + ": " + key + " has a colour without its 4 or 3 numbers");
  material.base_color = glm::vec3(toShare(color[0]), toShare(color[1]), toShare(color[2]));
  material.metallic = toShare(pbr.metallicFactor);
  material.perceptual_roughness = toShare(pbr.roughnessFactor);
  material.emission = glm::max(glm::vec3(toFloat(emission[0]), toFloat(emission[1]), toFloat(emission[2])), 0.0f);
  material.normal_scale = toFloat(source.normalTexture.scale);
  material.occlusion_strength = toShare(source.occlusionTexture.strength);
  material.double_sided = source.doubleSided;
  material.alpha_cutoff = toFloat(source.alphaCutoff);
  if (source.alphaMode == "MASK") material.alpha_mode = AlphaMode::mask;
  if (source.alphaMode == "BLEND") material.alpha_mode = AlphaMode::blend;
  if (material.alpha_mode != AlphaMode::opaque) material.opacity = toShare(color[3]);
  applyExtensions(source.extensions, material);

  const std::string pbr_key = key + ".pbrMetallicRoughness.";
  MIRRORBALL_TRY(base_color, slot(pbr.baseColorTexture, true, pbr_key + "baseColorTexture"));
  MIRRORBALL_TRY(roughness, slot(pbr.metallicRoughnessTexture, false, pbr_key + "metallicRoughnessTexture"));
  MIRRORBALL_TRY(normal, slot(source.normalTexture, false, key + ".normalTexture"));
  MIRRORBALL_TRY(occlusion, slot(source.occlusionTexture, false, key + ".occlusionTexture"));
  MIRRORBALL_TRY(emissive, slot(source.emissiveTexture, true, key + ".emissiveTexture"));
  material.base_color_texture = base_color;
  material.metallic_roughness_texture = roughness;
  material.normal_texture = normal;
  material.occlusion_texture = occlusion;
  material.emission_texture = emissive;
  return material;
}

template <typename TextureInfo>
Result<TextureSlot> GltfMaterials::slot(const TextureInfo& info, bool srgb, const std::string& key) {
  TextureSlot slot;
  if (info.index == -1) return slot;
  slot.uv_set = info.texCoord;
  if (const auto* transform = extensionOf(info.extensions, "KHR_texture_transform"))
    MIRRORBALL_TRY_VOID(applyTransform(*transform, slot, key));
  if (slot.uv_set < 0 || slot.uv_set > 1)
    return fail(ErrorCode::unsupported, file_.name + ": " + key + ".texCoord is " + std::to_string(slot.uv_set) +
                                            "; only the sets 0 and 1 are read");
  MIRRORBALL_TRY(texture, sceneTexture(info.index, srgb, key + ".index"));
  slot.texture = texture;
  return slot;
}

Result<void> GltfMaterials::applyTransform(const tinygltf::Value& transform, TextureSlot& slot,
                                           const std::string& key) {
  const auto pair = [&](const char* name, glm::vec2& out) {
    if (!transform.Has(name)) return true;
    const tinygltf::Value& numbers = transform.Get(name);
    if (numbers.ArrayLen() != 2 || !numbers.Get(0).IsNumber() || !numbers.Get(1).IsNumber()) return false;
    out = glm::vec2(toFloat(numbers.Get(0).GetNumberAsDouble()), toFloat(numbers.Get(1).GetNumberAsDouble()));
    return true;
  };
  if (!pair("offset", slot.offset) || !pair("scale", slot.scale))
    return fail(ErrorCode::bad_file,
                file_.name + ": " + key + ".extensions.KHR_texture_transform: offset and scale are two numbers each");
  slot.rotation_rad = numberOr(transform, "rotation", 0.0f);
  // The extension's own texCoord overrides the one beside it.
  if (transform.Has("texCoord") && transform.Get("texCoord").IsInt())
    slot.uv_set = transform.Get("texCoord").GetNumberAsInt();
  return {};
}

Result<int> GltfMaterials::sceneTexture(int index, bool srgb, const std::string& key) {
  MIRRORBALL_TRY_VOID(checkIndex(file_, index, file_.model.textures.size(), key, "textures"));
  if (const auto found = textures_.find({index, srgb}); found != textures_.end()) return found->second;

  const tinygltf::Texture& source = file_.model.textures[std::size_t(index)];
  const std::string texture_key = quoted("textures", index);
  if (source.source == -1) {
    scene_.warnings.push_back(file_.name + ": " + texture_key +
                              " has its picture only in an extension that is not read; it is left out");
    return textures_[{index, srgb}] = -1;
  }
  MIRRORBALL_TRY_VOID(checkIndex(file_, source.source, file_.model.images.size(), texture_key + ".source", "images"));
  Texture texture;
  texture.srgb = srgb;
  if (source.sampler != -1) {
    MIRRORBALL_TRY_VOID(
        checkIndex(file_, source.sampler, file_.model.samplers.size(), texture_key + ".sampler", "samplers"));
    const tinygltf::Sampler& sampler = file_.model.samplers[std::size_t(source.sampler)];
    texture.wrap_s = wrapOf(sampler.wrapS);
    texture.wrap_t = wrapOf(sampler.wrapT);
    texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  scene_.textures.push_back(std::move(texture));
  images_.push_back(source.source);
  return textures_[{index, srgb}] = static_cast<int>(scene_.textures.size()) - 1;
}

Result<std::span<const std::uint8_t>> GltfMaterials::encoded(int index) const {
  const tinygltf::Image& image = file_.model.images[std::size_t(index)];
  const std::string key = quoted("images", index);
  if (image.bufferView >= 0) return viewBytes(file_, image.bufferView, key + ".bufferView");
  if (!image.image.empty()) return std::span<const std::uint8_t>(image.image);
  if (image.uri.starts_with("data:"))
    return fail(ErrorCode::bad_file, file_.name + ": " + key + ".uri is no base64 data of a PNG or JPEG picture");
  return fail(ErrorCode::bad_file,
              file_.name + ": " + key + ".uri: '" + image.uri + "' is missing or empty; put it beside the model");
}

Result<void> GltfMaterials::decodeTextures() {
  std::map<int, std::size_t> place;  // glTF image → which of `pictures`
  std::vector<EncodedPicture> pictures;
  for (const int image : images_) {
    if (!place.emplace(image, pictures.size()).second) continue;
    MIRRORBALL_TRY(bytes, encoded(image));
    const std::string& uri = file_.model.images[std::size_t(image)].uri;
    pictures.push_back({file_.name + ": " + quoted("images", image) + (uri.empty() ? "" : " '" + uri + "'"), bytes});
  }

  std::vector<Result<Image8>> decoded = decodePictures(pictures);
  for (Result<Image8>& image : decoded)
    if (!image) return fail(std::move(image));
  std::vector<std::size_t> users(pictures.size(), 0);
  for (const int image : images_) ++users[place[image]];
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const std::size_t picture = place[images_[i]];
    // The last texture that shows a picture takes it; those before it need a copy.
    scene_.textures[i].image = --users[picture] == 0 ? std::move(*decoded[picture]) : *decoded[picture];
  }
  return {};
}

}  // namespace mirrorball
