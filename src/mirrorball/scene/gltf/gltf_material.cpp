#include "mirrorball/scene/gltf/gltf_material.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/scene/gltf/gltf_document_material.h"
#include "mirrorball/scene/gltf/gltf_uri.h"
#include "mirrorball/scene/material/lost_textures.h"

namespace mirrorball::gltf {

Result<int> Materials::sceneMaterial(int index, const std::string& key) {
  if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
  Material material = defaultMaterial();
  if (index >= 0) {
    if (const auto exists = checkIndex(index, file_.document.materials.size(), key, "material"); !exists) {
      file_.remarks.leaveOut(exists.error(), "material");
      return sceneMaterial(-1, key);
    }
    const FileMaterial& source = file_.document.materials[std::size_t(index)];
    material = source.material;
    const std::string own = quoted("materials", std::size_t(index)) + ".";
    for (const MaterialMap& map : materialMaps()) {
      const std::optional<float> glossiness = map.slot == &Material::roughness_map ? source.glossiness : std::nullopt;
      bindTexture(material.*map.slot, map, glossiness, own + std::string(map.gltf));
    }
  }
  MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(sizeof(Material))));
  scene_.materials.push_back(std::move(material));
  return materials_[index] = static_cast<int>(scene_.materials.size()) - 1;
}

/// Turns the slot's index into glTF's textures into one into the scene's, and its set of texture coordinates into one
/// of our vertices'.
void Materials::bindTexture(TextureSlot& slot, const MaterialMap& map, std::optional<float> glossiness,
                            const std::string& key) {
  if (slot.texture == -1) return;
  const TexCoordSets& sets = file_.document.tex_coord_sets;
  const auto set = std::find(sets.begin(), sets.end(), slot.uv_set);
  if (set == sets.end()) {
    file_.remarks.leaveOut({ErrorCode::unsupported, key + ".texCoord is " + std::to_string(slot.uv_set) +
                                                        ", and only the sets " + std::to_string(sets[0]) + " and " +
                                                        std::to_string(sets[1]) + " of the model are read"},
                           "texture on other coordinates");
    slot = {};
    return;
  }
  slot.texture = sceneTexture(slot.texture, map, glossiness, key + ".index");
  slot.uv_set = static_cast<int>(set - sets.begin());
}

/// The index in the scene of a texture of the file; −1: it has no picture, for which there is a remark.
int Materials::sceneTexture(int index, const MaterialMap& map, std::optional<float> glossiness,
                            const std::string& key) {
  const auto isThere = [&](int which, std::size_t count, const std::string& name, const char* thing) {
    const Result<void> exists = checkIndex(which, count, name, thing);
    if (!exists) file_.remarks.leaveOut(exists.error(), thing);
    return exists.has_value();
  };
  if (!isThere(index, file_.document.textures.size(), key, "texture")) return -1;
  const Texture& source = file_.document.textures[std::size_t(index)];
  const std::string texture_key = quoted("textures", std::size_t(index));
  if (source.image == -1) {
    if (without_picture_.insert(index).second)
      file_.remarks.leaveOut(texture_key + " has its picture only in an extension that is not read", "texture");
    return -1;
  }
  if (!isThere(source.image, file_.document.images.size(), texture_key + ".source", "image")) return -1;
  mirrorball::Texture texture;
  texture.srgb = map.srgb;
  if (source.sampler != -1 &&
      isThere(source.sampler, file_.document.samplers.size(), texture_key + ".sampler", "sampler")) {
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
    const auto bytes = readNamedFile(file_, uri, {});
    // What is not found is reported when it is decoded.
    return bytes ? "file " + std::to_string(reinterpret_cast<std::uintptr_t>(bytes->data())) : uri;
  };
  const std::string source = image.uri ? sourceOf(*image.uri) : "bufferViews " + std::to_string(image.buffer_view);
  return images_.try_emplace(source, index).first->second;
}

Result<std::span<const std::uint8_t>> Materials::encoded(int index) {
  const Image& image = file_.document.images[std::size_t(index)];
  const std::string key = quoted("images", std::size_t(index));
  if (!image.uri && image.buffer_view == -1)
    return fail(ErrorCode::bad_file, key + " has neither a bufferView nor a uri");
  if (!image.uri) return viewBytes(file_, image.buffer_view, key + ".bufferView");
  if (!isData(*image.uri)) return readNamedFile(file_, *image.uri, key + ".uri");
  MIRRORBALL_TRY(bytes, decodeData(*image.uri, key + ".uri"));
  return std::span<const std::uint8_t>(storage_[index] = std::move(bytes));
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
    MIRRORBALL_TRY_VOID(file_.files.budget().take(picture.bytes()));
    MIRRORBALL_TRY(changes, setTexels(picture.numbers(), planned_[index].use, texture));
    for (const std::string& change : changes)
      file_.remarks.tell(quoted("images", std::size_t(planned_[index].image)) + " " + change);
  }
  if (planned_[index].glossiness) {
    // Shared codes are copied to be changed.
    if (!picture.hasNumbers()) MIRRORBALL_TRY_VOID(file_.files.budget().take(picture.bytes()));
    makeRoughness(texture.image, *planned_[index].glossiness);
  }
  return {};
}

/// Decodes pictures of the file: of those that cannot be, why.
///
/// returns  those that would be others, read as numbers
std::set<int> Materials::decodeInto(Pictures& pictures, std::span<const PictureKey> wanted,
                                    const ProgressFunction& progress) {
  std::vector<EncodedPicture> encoded_pictures;
  std::vector<PictureKey> keys;  // of each
  for (const PictureKey& key : wanted) {
    const std::string name = quoted("images", std::size_t(key.image));
    Result<std::span<const std::uint8_t>> bytes = encoded(key.image);
    if (bytes && bytes->empty()) bytes = fail(ErrorCode::bad_file, name + " is empty");
    if (!bytes) {
      pictures.emplace(key, fail(std::move(bytes)));
      continue;
    }
    encoded_pictures.push_back({*bytes, key.as});
    keys.push_back(key);
  }
  const auto remark = [&](std::size_t picture, const std::string& oddity) {
    file_.remarks.tellOnce(quoted("images", std::size_t(keys[picture].image)), oddity);
  };
  auto decoded = decodePictures(encoded_pictures, file_.files.budget(), progress, remark);
  std::set<int> converted;
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    auto read = withName(quoted("images", std::size_t(keys[i].image)), std::move(decoded[i]));
    if (read && read->is_converted) converted.insert(keys[i].image);
    if (read)
      pictures.emplace(keys[i], SharedPicture(std::move(read->picture)));
    else
      pictures.emplace(keys[i], fail(std::move(read)));
  }
  return converted;
}

/// The pictures that are planned, decoded. One that shows colours to one material and numbers to another is decoded
/// for each where its colours are converted; else both share it.
Result<Materials::Pictures> Materials::decodedImages() {
  std::map<int, std::set<ReadAs>> uses;
  for (const Planned& planned : planned_) uses[planned.image].insert(planned.as());
  std::vector<PictureKey> first, second;
  for (const auto& [image, read_as] : uses) first.push_back({image, *read_as.begin()});  // light, if it is that too
  Pictures pictures;
  const std::set<int> converted = decodeInto(pictures, first, file_.files.progressOfHalf(1));
  for (const int image : converted)
    if (uses[image].contains(ReadAs::numbers)) second.push_back({image, ReadAs::numbers});
  decodeInto(pictures, second, {});
  storage_.clear();
  for (auto& [key, picture] : pictures)
    if (!picture && !isDamage(picture.error())) return fail(std::move(picture));
  return pictures;
}

Result<void> Materials::decodeTextures() {
  MIRRORBALL_TRY(pictures, decodedImages());
  for (const auto& [key, picture] : pictures)
    if (!picture) file_.remarks.leaveOut(picture.error(), "picture");
  std::vector<bool> is_lost;
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const auto own = pictures.find({planned_[i].image, planned_[i].as()});
    const Result<SharedPicture>& picture =
        own != pictures.end() ? own->second : pictures.at({planned_[i].image, ReadAs::light});
    is_lost.push_back(!picture);
    if (!picture) continue;
    const std::string key = quoted("images", std::size_t(planned_[i].image));
    MIRRORBALL_TRY_VOID(withName(key, setPicture(i, *picture)));
  }
  leaveOutTextures(scene_, is_lost);
  return {};
}

}  // namespace mirrorball::gltf
