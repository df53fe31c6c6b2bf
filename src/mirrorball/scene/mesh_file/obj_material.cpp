#include "mirrorball/scene/mesh_file/obj_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/texture_numbers.h"
#include "mirrorball/scene/picture_decoding.h"

namespace mirrorball {
namespace {

constexpr int kDiffuseWithoutHighlight = 1;  // an illumination model of the .mtl specification

float share(float number) { return std::isfinite(number) ? std::clamp(number, 0.0f, 1.0f) : 0.0f; }

std::string withSlashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

std::string inQuotes(const std::string& name) { return "'" + excerpt(name) + "'"; }

/// Pictures that materials share are read once for each use.
class Pictures {
 public:
  Pictures(ModelFiles& named, Scene& scene) : named_(named), scene_(scene) {}

  /// The texture's index in the scene, or −1 where there is none or it cannot be read.
  int texture(const std::string& name, TextureUse use) {
    if (name.empty()) return -1;
    const auto [found, is_new] = textures_.try_emplace({name, use}, -1);
    if (!is_new) return found->second;
    const auto bytes = readNamed(named_, name);
    if (!bytes) {
      scene_.warnings.push_back(bytes.error().message + "; the material goes without it");
      return -1;
    }
    // Under another name it may be known already; what is read of one file lies in one place.
    const auto [same, is_first] = of_bytes_.try_emplace({bytes->data(), use}, static_cast<int>(scene_.textures.size()));
    if (is_first) {
      pending_.push_back({name, *bytes, use});
      scene_.textures.emplace_back().srgb = use != TextureUse::normals;
    }
    return found->second = same->second;
  }

  void decode() {
    std::vector<EncodedPicture> encoded;
    for (const Pending& each : pending_) encoded.push_back({each.bytes, each.use != TextureUse::normals});
    std::vector<Result<Texels>> decoded = decodePictures(encoded, named_.budget());
    for (std::size_t i = 0; i < decoded.size(); ++i) {
      const std::string name = inQuotes(pending_[i].name);
      const auto changes = decoded[i] ? setTexels(std::move(*decoded[i]), pending_[i].use, scene_.textures[i])
                                      : Result<std::vector<std::string>>(fail(std::move(decoded[i])));
      if (changes) {
        for (const std::string& change : *changes) scene_.warnings.push_back(name + ": " + change);
      } else {
        scene_.warnings.push_back(name + ": " + changes.error().message + "; the material goes without it");
        scene_.textures[i].image = Image8(1, 1, 4, 255);
      }
    }
  }

 private:
  struct Pending {
    std::string name;
    std::span<const std::uint8_t> bytes;
    TextureUse use;
  };

  ModelFiles& named_;
  Scene& scene_;
  std::map<std::pair<std::string, TextureUse>, int> textures_;
  std::map<std::pair<const std::uint8_t*, TextureUse>, int> of_bytes_;
  std::vector<Pending> pending_;
};

Material convert(const tinyobj::material_t& source, Pictures& pictures, std::vector<std::string>& warnings) {
  Material material;
  material.name = source.name;
  material.base_color = glm::vec3(share(source.diffuse[0]), share(source.diffuse[1]), share(source.diffuse[2]));
  for (int channel = 0; channel < 3; ++channel)
    if (const float light = source.emission[channel]; std::isfinite(light))
      material.emission[channel] = std::max(light, 0.0f);
  if (source.ior > 1.0f && std::isfinite(source.ior)) material.ior = source.ior;
  material.opacity = share(source.dissolve);
  if (material.opacity < 1.0f) material.alpha_mode = AlphaMode::blend;

  // The width of the Beckmann lobe that a Phong highlight of this exponent has (Walter et al. 2007, section 5.2).
  const float exponent = std::isfinite(source.shininess) ? std::max(source.shininess, 0.0f) : 0.0f;
  const float alpha = std::sqrt(2.0f / (exponent + 2.0f));
  material.perceptual_roughness = source.roughness > 0.0f ? share(source.roughness) : std::sqrt(alpha);
  material.metallic = share(source.metallic);
  const bool has_highlight = source.specular[0] > 0.0f || source.specular[1] > 0.0f || source.specular[2] > 0.0f;
  if (source.illum == kDiffuseWithoutHighlight && !has_highlight) material.specular = 0.0f;

  material.base_color_map.texture = pictures.texture(source.diffuse_texname, TextureUse::factors);
  material.emission_map.texture = pictures.texture(source.emissive_texname, TextureUse::light);
  material.normal_map.texture = pictures.texture(source.normal_texname, TextureUse::normals);
  // Many programs write black beside a picture, which would hide it.
  if (material.base_color_map.texture >= 0 && material.base_color == glm::vec3(0.0f))
    material.base_color = glm::vec3(1.0f);
  if (material.emission_map.texture >= 0 && material.emission == glm::vec3(0.0f)) material.emission = glm::vec3(1.0f);
  for (const std::string& left_out : {source.bump_texname, source.alpha_texname})
    if (!left_out.empty())
      warnings.push_back("material " + inQuotes(source.name) + ": the picture " + inQuotes(left_out) + " is left out");
  return material;
}

}  // namespace

void addObjMaterials(std::span<const tinyobj::material_t> materials, ModelFiles& named, Scene& scene) {
  Pictures pictures(named, scene);
  for (const tinyobj::material_t& material : materials)
    scene.materials.push_back(convert(material, pictures, scene.warnings));
  pictures.decode();
}

Result<std::span<const std::uint8_t>> readNamed(ModelFiles& named, const std::string& name) {
  auto file = named.find(withSlashes(name));
  if (!file) file.error().message.insert(0, inQuotes(name) + " ");
  MIRRORBALL_TRY(path, std::move(file));
  return named.read(path);
}

}  // namespace mirrorball
