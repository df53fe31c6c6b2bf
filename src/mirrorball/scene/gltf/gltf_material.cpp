#include "mirrorball/scene/gltf/gltf_material.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/scene/gltf/gltf_document_material.h"

namespace mirrorball::gltf {

Result<int> Materials::sceneMaterial(int index, const std::string& key) {
  if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
  Material material = defaultMaterial();
  if (index >= 0) {
    MIRRORBALL_TRY_VOID(checkIndex(index, file_.document.materials.size(), key, "material"));
    const FileMaterial& source = file_.document.materials[std::size_t(index)];
    material = source.material;
    const std::string own = quoted("materials", std::size_t(index)) + ".";
    for (const MaterialMap& map : materialMaps()) {
      const std::optional<float> glossiness = map.slot == &Material::roughness_map ? source.glossiness : std::nullopt;
      MIRRORBALL_TRY_VOID(bindTexture(material.*map.slot, map, glossiness, own + std::string(map.gltf)));
    }
  }
  MIRRORBALL_TRY_VOID(withName(key, file_.named.budget().take(sizeof(Material))));
  scene_.materials.push_back(std::move(material));
  return materials_[index] = static_cast<int>(scene_.materials.size()) - 1;
}

/// Turns the slot's index into glTF's textures into one into the scene's.
Result<void> Materials::bindTexture(TextureSlot& slot, const MaterialMap& map, std::optional<float> glossiness,
                                    const std::string& key) {
  if (slot.texture == -1) return {};
  MIRRORBALL_TRY(texture, sceneTexture(slot.texture, map, glossiness, key + ".index"));
  slot.texture = texture;
  return {};
}

Result<int> Materials::sceneTexture(int index, const MaterialMap& map, std::optional<float> glossiness,
                                    const std::string& key) {
  MIRRORBALL_TRY_VOID(checkIndex(index, file_.document.textures.size(), key, "texture"));
  const Texture& source = file_.document.textures[std::size_t(index)];
  const std::string texture_key = quoted("textures", std::size_t(index));
  if (source.image == -1) {
    if (without_picture_.insert(index).second)
      scene_.warnings.push_back(file_.name + ": " + texture_key +
                                " has its picture only in an extension that is not read; it is left out");
    return -1;
  }
  MIRRORBALL_TRY_VOID(checkIndex(source.image, file_.document.images.size(), texture_key + ".source", "image"));
  mirrorball::Texture texture;
  texture.srgb = map.srgb;
  if (source.sampler != -1) {
    MIRRORBALL_TRY_VOID(
        checkIndex(source.sampler, file_.document.samplers.size(), texture_key + ".sampler", "sampler"));
    const Sampler& sampler = file_.document.samplers[std::size_t(source.sampler)];
    texture.wrap_s = sampler.wrap_s;
    texture.wrap_t = sampler.wrap_t;
    texture.nearest = sampler.nearest;
  }
  const int image = sameImage(source.image);
  const auto [known, is_new] = textures_.try_emplace(
      {image, map.srgb, map.holdsNormals(), glossiness, texture.wrap_s, texture.wrap_t, texture.nearest},
      int(scene_.textures.size()));
  if (!is_new) return known->second;
  scene_.textures.push_back(std::move(texture));
  planned_.push_back({image, map.srgb, useOf(map), glossiness});
  return known->second;
}

int Materials::sameImage(int index) {
  const auto [known, is_new] = same_image_.try_emplace(index, index);
  if (is_new) known->second = firstOfSameSource(index);
  return known->second;
}

int Materials::firstOfSameSource(int index) {
  const Image& image = file_.document.images[std::size_t(index)];
  const auto sourceOf = [&](const std::string& uri) {
    ContentHash data;
    if (isData(uri)) return data.addAll(std::span<const char>(uri)), data.digits();
    const auto path = findFile(file_, uri, {});
    return path ? path->string() : uri;  // what is not found is told of when it is read
  };
  const std::string source = image.uri ? sourceOf(*image.uri) : "bufferViews " + std::to_string(image.buffer_view);
  return images_.try_emplace(source, index).first->second;
}

Result<std::span<const std::uint8_t>> Materials::encoded(int index) {
  const Image& image = file_.document.images[std::size_t(index)];
  const std::string key = quoted("images", std::size_t(index));
  if (!image.uri) return viewBytes(file_, image.buffer_view, key + ".bufferView");
  if (isData(*image.uri)) {
    MIRRORBALL_TRY(bytes, decodeData(*image.uri, key + ".uri"));
    return std::span<const std::uint8_t>(storage_[index] = std::move(bytes));
  }
  MIRRORBALL_TRY(path, findFile(file_, *image.uri, key + ".uri"));
  return file_.named.read(path);
}

namespace {

/// Puts 1 − glossiness · alpha where a roughness map has it.
///
/// greatest   sample, which stands for 1
template <typename Sample, typename Round>
void makeRoughness(ImageOf<Sample>& image, float glossiness, Sample greatest, const Round& round) {
  const std::span<Sample> samples = image.samples();
  for (std::size_t i = 0; i + 3 < samples.size(); i += 4) {
    const float gloss = glossiness * static_cast<float>(samples[i + 3]);
    samples[i] = samples[i + 2] = samples[i + 3] = greatest;
    samples[i + 1] = round(static_cast<float>(greatest) - gloss);
  }
}

void makeRoughness(SharedPicture& picture, float glossiness) {
  if (picture.hasNumbers())
    makeRoughness(picture.editNumbers(), glossiness, 1.0f, [](float number) { return number; });
  else
    makeRoughness(picture.edit(), glossiness, std::uint8_t{255},
                  [](float code) { return static_cast<std::uint8_t>(std::lround(code)); });
}

}  // namespace

/// Gives a texture its picture: codes are shared, floats are its own, since what they are to be bounds them.
Result<void> Materials::setPicture(std::size_t index, const SharedPicture& picture) {
  mirrorball::Texture& texture = scene_.textures[index];
  texture.image = picture;
  if (picture.hasNumbers()) {
    MIRRORBALL_TRY_VOID(file_.named.budget().take(picture.bytes()));
    MIRRORBALL_TRY(changes, setTexels(picture.numbers(), planned_[index].use, texture));
    for (const std::string& change : changes)
      scene_.warnings.push_back(file_.name + ": " + quoted("images", std::size_t(planned_[index].image)) + " " +
                                change);
  }
  if (planned_[index].glossiness) {
    // Shared codes are copied to be changed.
    if (!picture.hasNumbers()) MIRRORBALL_TRY_VOID(file_.named.budget().take(picture.bytes()));
    makeRoughness(texture.image, *planned_[index].glossiness);
  }
  return {};
}

Result<void> Materials::decodeTextures() {
  std::map<int, std::size_t> place;  // glTF image → which of `pictures`
  std::vector<EncodedPicture> pictures;
  for (const Planned& planned : planned_) {
    const auto [known, is_new] = place.emplace(planned.image, pictures.size());
    if (is_new) {
      MIRRORBALL_TRY(bytes, encoded(planned.image));
      pictures.push_back({bytes});
    }
    if (planned.srgb) pictures[known->second].shows_colors = true;
  }

  std::vector<Result<Texels>> decoded = decodePictures(pictures, file_.named.budget(), file_.named.progressOfHalf(1));
  for (const Result<Texels>& picture : decoded)
    if (!picture && picture.error().code == ErrorCode::interrupted) return tl::unexpected<Error>(picture.error());
  std::vector<SharedPicture> shared;
  for (Result<Texels>& picture : decoded) shared.emplace_back(picture ? std::move(*picture) : Texels());
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const std::size_t picture = place[planned_[i].image];
    const std::string key = quoted("images", std::size_t(planned_[i].image));
    if (!decoded[picture]) return fail(withName(key, std::move(decoded[picture])));
    MIRRORBALL_TRY_VOID(withName(key, setPicture(i, shared[picture])));
  }
  storage_.clear();
  return {};
}

}  // namespace mirrorball::gltf
