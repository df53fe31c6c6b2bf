#include "mirrorball/scene/gltf/gltf_material.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mirrorball/scene/gltf/gltf_document_material.h"

namespace mirrorball::gltf {

Result<int> Materials::sceneMaterial(int index, const std::string& key) {
  if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
  Material material = defaultMaterial();
  if (index >= 0) {
    MIRRORBALL_TRY_VOID(checkIndex(index, file_.document.materials.size(), key, "materials"));
    const FileMaterial& source = file_.document.materials[std::size_t(index)];
    material = source.material;
    const std::string own = quoted("materials", std::size_t(index)) + ".";
    for (const MaterialMap& map : materialMaps()) {
      const std::optional<float> glossiness = map.slot == &Material::roughness_map ? source.glossiness : std::nullopt;
      MIRRORBALL_TRY_VOID(bindTexture(material.*map.slot, map.srgb, glossiness, own + std::string(map.gltf)));
    }
  }
  scene_.materials.push_back(std::move(material));
  return materials_[index] = static_cast<int>(scene_.materials.size()) - 1;
}

/// Turns the slot's index into glTF's textures into one into the scene's.
Result<void> Materials::bindTexture(TextureSlot& slot, bool srgb, std::optional<float> glossiness,
                                    const std::string& key) {
  if (slot.texture == -1) return {};
  MIRRORBALL_TRY(texture, sceneTexture(slot.texture, srgb, glossiness, key + ".index"));
  slot.texture = texture;
  return {};
}

Result<int> Materials::sceneTexture(int index, bool srgb, std::optional<float> glossiness, const std::string& key) {
  MIRRORBALL_TRY_VOID(checkIndex(index, file_.document.textures.size(), key, "textures"));
  const TextureUse use{index, srgb, glossiness};
  if (const auto found = textures_.find(use); found != textures_.end()) return found->second;

  const Texture& source = file_.document.textures[std::size_t(index)];
  const std::string texture_key = quoted("textures", std::size_t(index));
  if (source.image == -1) {
    scene_.warnings.push_back(file_.name + ": " + texture_key +
                              " has its picture only in an extension that is not read; it is left out");
    return textures_[use] = -1;
  }
  MIRRORBALL_TRY_VOID(checkIndex(source.image, file_.document.images.size(), texture_key + ".source", "images"));
  mirrorball::Texture texture;
  texture.srgb = srgb;
  if (source.sampler != -1) {
    MIRRORBALL_TRY_VOID(
        checkIndex(source.sampler, file_.document.samplers.size(), texture_key + ".sampler", "samplers"));
    const Sampler& sampler = file_.document.samplers[std::size_t(source.sampler)];
    texture.wrap_s = sampler.wrap_s;
    texture.wrap_t = sampler.wrap_t;
    texture.nearest = sampler.nearest;
  }
  scene_.textures.push_back(std::move(texture));
  planned_.push_back({source.image, glossiness});
  return textures_[use] = static_cast<int>(scene_.textures.size()) - 1;
}

Result<std::size_t> Materials::pictureOf(int index) {
  if (const auto known = picture_of_image_.find(index); known != picture_of_image_.end()) return known->second;
  const Image& image = file_.document.images[std::size_t(index)];
  const std::string key = quoted("images", std::size_t(index));
  std::string source;  // what images that show the same have in common
  std::span<const std::uint8_t> bytes;
  if (!image.uri) {
    MIRRORBALL_TRY(view, viewBytes(file_, image.buffer_view, key + ".bufferView"));
    source = "bufferViews " + std::to_string(image.buffer_view);
    bytes = view;
  } else if (isData(*image.uri)) {
    MIRRORBALL_TRY(decoded, decodeData(*image.uri, key + ".uri"));
    source = *image.uri;
    bytes = storage_[index] = std::move(decoded);
  } else {
    MIRRORBALL_TRY(path, findFile(file_, *image.uri, key + ".uri"));
    MIRRORBALL_TRY(read, file_.named.read(path));
    source = path.string();
    bytes = read;
  }
  const auto [picture, is_new] = pictures_.try_emplace(source, encoded_.size());
  if (is_new) encoded_.push_back(bytes);
  return picture_of_image_[index] = picture->second;
}

namespace {

/// Puts 1 − glossiness · alpha where a roughness map has it.
void makeRoughness(Image8& image, float glossiness) {
  const std::span<std::uint8_t> samples = image.samples();
  for (std::size_t i = 0; i + 3 < samples.size(); i += 4) {
    const float gloss = glossiness * static_cast<float>(samples[i + 3]);
    samples[i] = samples[i + 2] = samples[i + 3] = 255;
    samples[i + 1] = static_cast<std::uint8_t>(std::lround(255.0f - gloss));
  }
}

}  // namespace

Result<void> Materials::decodeTextures() {
  std::vector<std::size_t> place;  // of each texture's picture
  for (const Planned& planned : planned_) {
    MIRRORBALL_TRY(picture, pictureOf(planned.image));
    place.push_back(picture);
  }
  std::vector<Result<Image8>> decoded = decodePictures(encoded_);
  for (std::size_t i = 0; i < planned_.size(); ++i)
    if (Result<Image8>& picture = decoded[place[i]]; !picture)
      return fail(withName(quoted("images", std::size_t(planned_[i].image)), std::move(picture)));
  std::vector<std::size_t> users(encoded_.size(), 0);
  for (const std::size_t picture : place) ++users[picture];
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const std::size_t picture = place[i];
    // The last texture that shows a picture takes it; those before it need a copy.
    Image8& image = scene_.textures[i].image;
    image = --users[picture] == 0 ? std::move(*decoded[picture]) : *decoded[picture];
    if (planned_[i].glossiness) makeRoughness(image, *planned_[i].glossiness);
  }
  storage_.clear();
  return {};
}

}  // namespace mirrorball::gltf
