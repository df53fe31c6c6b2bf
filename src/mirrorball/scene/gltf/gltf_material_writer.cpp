#include "mirrorball/scene/gltf/gltf_material_writer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "formula/color.h"
#include "formula/surface.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/scene/gltf/gltf_document_material.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/material/texture_numbers.h"

namespace mirrorball::gltf {
namespace {

OutputJson numbersOf(std::span<const float> numbers) { return std::vector<float>(numbers.begin(), numbers.end()); }

/// A parameter's value as JSON; null for kinds of fields of which no row has a key in glTF, as choices.
OutputJson valueOf(const MaterialParameter& parameter, const Material& material) {
  if (const auto* number = std::get_if<float Material::*>(&parameter.field)) return material.**number;
  if (const auto* flag = std::get_if<bool Material::*>(&parameter.field)) return material.**flag;
  if (const auto* count = std::get_if<int Material::*>(&parameter.field)) return material.**count;
  if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field))
    return numbersOf({&(material.**color).x, 3});
  return nullptr;
}

bool isDefault(const MaterialParameter& parameter, const Material& material) {
  return written(parameter, material) == written(parameter, defaultMaterial());
}

/// Whether every pixel is opaque, so that alpha need not be kept.
bool isOpaque(const Image8& image) {
  for (std::size_t i = 3; i < image.samples().size(); i += 4)
    if (image.samples()[i] != 255) return false;
  return true;
}

Image8 withoutAlpha(const Image8& image) {
  Image8 rgb = Image8::withoutValues(image.width(), image.height(), 3);
  for (std::size_t i = 0; i < image.texelCount(); ++i)
    std::copy_n(image.samples().data() + 4 * i, 3, rgb.samples().data() + 3 * i);
  return rgb;
}

bool isSamePlace(const TextureSlot& a, const TextureSlot& b) {
  return a.uv_set == b.uv_set && a.offset == b.offset && a.scale == b.scale && a.rotation_rad == b.rotation_rad;
}

bool haveSameShape(const mirrorball::Texture& a, const mirrorball::Texture& b) {
  return a.image.width() == b.image.width() && a.image.height() == b.image.height() && a.wrap_s == b.wrap_s &&
         a.wrap_t == b.wrap_t && a.nearest == b.nearest;
}

/// Puts what glTF has in the place of what it has not; returns what is lost by it.
std::vector<std::string> approximate(Material& material) {
  std::vector<std::string> lost;
  if (material.conductor_k != glm::vec3(0.0f)) {
    material.base_color = formula::bareMetalReflectance(material, 1.0f);
    material.conductor_n = material.conductor_k = glm::vec3(0.0f);
    lost.emplace_back("the metal's complex index, but for its reflectance at normal incidence,");
  }
  if (material.ior < 1.0f) {  // which KHR_materials_ior does not allow
    material.ior = defaultMaterial().ior;
    lost.emplace_back("ior below 1");
  }
  if (material.normal_space == NormalSpace::object && material.normal_map.texture >= 0) {
    material.normal_map.texture = -1;
    material.normal_space = NormalSpace::tangent;
    lost.emplace_back("normal_map, which is in object space,");
  }
  if (material.alpha_mode == AlphaMode::opaque) material.opacity = 1.0f;
  if (material.unlit) material = unlitOf(material);
  return lost;
}

/// Whether glTF has a place for a row of the table in this material: a cutoff is for masks alone, and the strength of a
/// texture stands in the texture.
bool hasPlace(const MaterialParameter& parameter, const Material& material) {
  if (parameter.gltf == "alphaCutoff") return material.alpha_mode == AlphaMode::mask;
  for (const MaterialMap& map : materialMaps())
    if (parameter.gltf.starts_with(std::string(map.gltf) + ".")) return (material.*map.slot).texture >= 0;
  return true;
}

/// Floats as codes of 8 bits, as glTF has them in a texture: colours sRGB-encoded, normals about 127.5.
///
/// zero     that the normals are encoded with
/// divisor  of colours
Image8 codesOf(const mirrorball::Image& numbers, const MaterialMap& map, float zero, float divisor) {
  Image8 codes = Image8::withoutValues(numbers.width(), numbers.height(), 4);
  for (std::size_t i = 0; i < numbers.samples().size(); i += 4) {
    const float* const number = numbers.samples().data() + i;
    glm::vec3 color(number[0], number[1], number[2]);
    if (map.holdsNormals()) {
      const glm::vec3 normal = formula::decodedNormal(color, zero);
      color = 0.5f + 0.5f * normal / std::max(glm::length(normal), 1.0f);
    }
    if (map.srgb) color = formula::srgbFromLinear(color / divisor);
    const glm::vec4 rounded = glm::round(255.0f * glm::clamp(glm::vec4(color, number[3]), 0.0f, 1.0f));
    for (int channel = 0; channel < 4; ++channel)
      codes.samples()[i + std::size_t(channel)] = static_cast<std::uint8_t>(rounded[channel]);
  }
  return codes;
}

class MaterialWriter {
 public:
  MaterialWriter(const Scene& scene, GlbBuilder& file, std::vector<std::string>& left_out)
      : scene_(scene), file_(file), left_out_(left_out), textures_(scene.textures) {}

  Result<void> write() {
    roundNumbers();
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) writeMaterial(i);
    return writeTextures();
  }

 private:
  /// Of the textures that the materials have.
  void roundNumbers() {
    for (const Material& material : scene_.materials)
      for (const MaterialMap& map : materialMaps()) {
        const int index = (material.*map.slot).texture;
        if (index < 0 || !textures_[std::size_t(index)].image.hasNumbers()) continue;
        SharedPicture& picture = textures_[std::size_t(index)].image;
        const bool is_light = map.slot == &Material::emission_map;
        const float brightest = is_light ? std::max(largestSample(picture.numbers()), 1.0f) : 1.0f;
        if (is_light) brightest_[index] = brightest;
        picture = codesOf(picture.numbers(), map, map.holdsNormals() ? material.*map.zero : 0.0f, brightest);
        left_out_.push_back(std::string(map.name) + ": what is finer than 8 bits is left out");
      }
  }

  void writeMaterial(std::size_t index) {
    Material material = scene_.materials[index];
    forgetZeros(material);
    // Codes end at 1: what is brighter is in the factor.
    if (const auto found = brightest_.find(material.emission_map.texture); found != brightest_.end())
      material.emission *= found->second;
    std::vector<std::string> lost = approximate(material);
    joinMetallicAndRoughness(material, lost);
    OutputJson json = OutputJson::object();
    if (!material.name.empty()) json["name"] = printable(material.name);
    for (const MaterialParameter& parameter : materialParameters()) {
      // The base colour's alpha, a body without a thickness, an extension without members.
      const std::string_view name = parameter.text.name;
      const bool is_no_member = name == "opacity" || name == "thin_walled" || name == "unlit";
      if (is_no_member || isDefault(parameter, material)) continue;
      if (parameter.gltf.empty())
        lost.emplace_back(parameter.text.name);
      else if (hasPlace(parameter, material))
        placeAt(json, parameter.gltf) = valueOf(parameter, material);
    }
    for (const MaterialMap& map : materialMaps()) writeSlot(map, material.*map.slot, json);
    writeWhatIsNoRow(material, json);
    file_.append("materials", std::move(json));
    if (lost.empty()) return;
    left_out_.push_back(quoted("materials", index) +
                        (material.name.empty() ? "" : " (" + excerpt(material.name) + ")") + ": " +
                        join(lost, ", ", " and ") + (lost.size() == 1 ? " is" : " are") + " left out");
  }

  /// The member of a material that a key of the tables names. Who asks for one in an extension uses that.
  OutputJson& placeAt(OutputJson& material, std::string_view key) {
    const std::vector<std::string> names = split(key, '.');
    OutputJson* member = &material;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i > 0 && names[i - 1] == "extensions") file_.extensions.insert(names[i]);
      member = &(*member)[names[i]];
    }
    return *member;
  }

  /// What our tables have no row for, or another form.
  void writeWhatIsNoRow(const Material& material, OutputJson& json) {
    if (material.unlit) placeAt(json, "extensions.KHR_materials_unlit") = OutputJson::object();
    if (material.alpha_mode == AlphaMode::mask) json["alphaMode"] = "MASK";
    if (material.alpha_mode == AlphaMode::blend) json["alphaMode"] = "BLEND";
    if (material.opacity < 1.0f || material.base_color != defaultMaterial().base_color) {
      const glm::vec4 factor(material.base_color, material.opacity);
      placeAt(json, "pbrMetallicRoughness.baseColorFactor") = numbersOf({&factor.x, 4});
    }
    // A factor ends at 1; brighter ones are one of at most 1 times a strength.
    const float brightest = std::max({material.emission.x, material.emission.y, material.emission.z});
    if (brightest > 1.0f) {
      const glm::vec3 factor = material.emission / brightest;
      json["emissiveFactor"] = numbersOf({&factor.x, 3});
      placeAt(json, "extensions.KHR_materials_emissive_strength.emissiveStrength") = brightest;
    }
    // Without a thickness a surface is a thin wall, which does not bend light. How thick matters only to programs that
    // do not trace it.
    if (material.transmission > 0.0f && !material.thin_walled)
      placeAt(json, "extensions.KHR_materials_volume.thicknessFactor") = 1.0f;
  }

  void writeSlot(const MaterialMap& map, const TextureSlot& slot, OutputJson& json) {
    if (slot.texture < 0) return;
    OutputJson& info = placeAt(json, map.gltf);
    info["index"] = indexInFile(slot.texture);
    if (slot.uv_set != 0) info["texCoord"] = slot.uv_set;
    const bool is_moved = !isSamePlace(slot, {.uv_set = slot.uv_set});
    if (is_moved)
      placeAt(info, "extensions.KHR_texture_transform") = {{"offset", numbersOf({&slot.offset.x, 2})},
                                                           {"rotation", slot.rotation_rad},
                                                           {"scale", numbersOf({&slot.scale.x, 2})}};
  }

  /// glTF has both in one texture, roughness in G and metallic in B. Where they are two, or one of them is missing, one
  /// is made of them.
  void joinMetallicAndRoughness(Material& material, std::vector<std::string>& lost) {
    TextureSlot& metallic = material.metallic_map;
    TextureSlot& roughness = material.roughness_map;
    if (metallic.texture == roughness.texture && isSamePlace(metallic, roughness)) return;
    const bool are_two = metallic.texture >= 0 && roughness.texture >= 0;
    if (are_two && !(isSamePlace(metallic, roughness) &&
                     haveSameShape(textureOf(metallic.texture), textureOf(roughness.texture)))) {
      lost.emplace_back("metallic_map, which has another size or place than roughness_map,");
      metallic.texture = -1;
    }
    TextureSlot joined = roughness.texture >= 0 ? roughness : metallic;
    const auto [place, is_new] =
        joined_.try_emplace({metallic.texture, roughness.texture}, static_cast<int>(textures_.size() + made_.size()));
    if (is_new) made_.push_back(joinedTexture(metallic.texture, roughness.texture));
    joined.texture = place->second;
    metallic = roughness = joined;
  }

  /// A texture whose channels are those of two, or 1 where there is only one.
  mirrorball::Texture joinedTexture(int metallic, int roughness) const {
    constexpr std::size_t kGreen = 1, kBlue = 2;
    mirrorball::Texture joined = textureOf(roughness >= 0 ? roughness : metallic);
    const std::span<std::uint8_t> to = joined.image.edit().samples();
    std::fill(to.begin(), to.end(), std::uint8_t{255});
    const auto copyChannel = [&](int texture, std::size_t channel) {
      if (texture < 0) return;
      const std::span<const std::uint8_t> from = textureOf(texture).image.samples();
      for (std::size_t i = channel; i < from.size(); i += 4) to[i] = from[i];
    };
    copyChannel(roughness, kGreen);
    copyChannel(metallic, kBlue);
    return joined;
  }

  /// One of the scene's, or behind those one that was made here.
  const mirrorball::Texture& textureOf(int index) const {
    const auto place = std::size_t(index);
    return place < textures_.size() ? textures_[place] : made_[place - textures_.size()];
  }

  /// What readers find themselves in a normal map, or find gone from one that had floats, is not lost.
  void forgetZeros(Material& material) const {
    for (const MaterialMap& map : materialMaps()) {
      const int index = (material.*map.slot).texture;
      if (!map.holdsNormals() || index < 0) continue;
      const bool was_rounded = scene_.textures[std::size_t(index)].image.hasNumbers();
      if (was_rounded || findNormalZero(textures_[std::size_t(index)].image) == material.*map.zero)
        material.*map.zero = defaultMaterial().*map.zero;
    }
  }

  std::size_t indexInFile(int texture) {
    const auto [place, is_new] = index_in_file_.try_emplace(texture, used_.size());
    if (is_new) used_.push_back(texture);
    return place->second;
  }

  Result<void> writeTextures() {
    std::vector<Result<Bytes>> pictures(used_.size());
    parallelFor(used_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Image8& image = textureOf(used_[i]).image.codes();
        pictures[i] = encodePicture(ImageFormatId::png, isOpaque(image) ? withoutAlpha(image) : image, {});
      }
    });
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (!pictures[i]) return fail(std::move(pictures[i]));
      const std::size_t view = file_.appendView(*pictures[i]);
      const std::size_t image = file_.append("images", {{"mimeType", "image/png"}, {"bufferView", view}});
      file_.append("textures", {{"sampler", writeSampler(textureOf(used_[i]))}, {"source", image}});
    }
    return {};
  }

  /// Each texture has its own; they are a few bytes each.
  std::size_t writeSampler(const mirrorball::Texture& texture) {
    constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmapLinear = 9987;
    const auto wrapOf = [](Wrap wrap) {
      constexpr int kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;
      if (wrap == Wrap::clamp_to_edge) return kClampToEdge;
      return wrap == Wrap::mirrored_repeat ? kMirroredRepeat : kRepeat;
    };
    return file_.append("samplers", {{"magFilter", texture.nearest ? kNearest : kLinear},
                                     {"minFilter", kLinearMipmapLinear},
                                     {"wrapS", wrapOf(texture.wrap_s)},
                                     {"wrapT", wrapOf(texture.wrap_t)}});
  }

  const Scene& scene_;
  GlbBuilder& file_;
  std::vector<std::string>& left_out_;
  std::vector<mirrorball::Texture> textures_;  // the scene's, with codes
  std::map<int, float> brightest_;             // of emission maps that had floats, by which these were divided
  std::deque<mirrorball::Texture> made_;
  std::map<std::pair<int, int>, int> joined_;  // textures of metallic and roughness → the one made of them
  std::map<int, std::size_t> index_in_file_;   // texture → place in used_
  std::vector<int> used_;
};

}  // namespace

Result<void> writeMaterials(const Scene& scene, GlbBuilder& file, std::vector<std::string>& left_out) {
  return MaterialWriter(scene, file, left_out).write();
}

}  // namespace mirrorball::gltf
