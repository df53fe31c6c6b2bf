#include "mirrorball/scene/mesh_file/obj_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/channel_range.h"
#include "mirrorball/scene/mesh_file/named_pictures.h"

namespace mirrorball {
namespace {

constexpr float kDiffuseWithoutHighlight = 1.0f;  // an illumination model of the .mtl specification

float fraction(float number) { return std::clamp(number, 0.0f, 1.0f); }

std::string quotedName(const MtlMaterial& material) { return "the material '" + excerpt(material.name) + "'"; }

/// Turns materials one by one, and gathers what remarks say of all of them.
class MaterialConverter {
 public:
  /// hides_all   nothing of the model is seen by what its materials say by d
  MaterialConverter(NamedPictures& pictures, Scene& scene, bool hides_all)
      : pictures_(pictures), scene_(scene), hides_all_(hides_all) {}

  void add(const MtlMaterial& source) {
    Material& material = scene_.materials.emplace_back();
    material.name = source.name;
    setColors(source, material);
    setRoughness(source, material);
    setOpacity(source, material);
    setLayers(source, material);
    setDetail(source, material);
    for (const std::string& statement : source.left_out) ++left_out_[statement];
    if (source.map(MtlMapKind::normals) && source.map(MtlMapKind::heights)) ++left_out_["bump"];
    for (const MtlMap& map : source.maps)
      if (map.has_other_range) ++left_out_["-mm"];
  }

  void tell() const {
    if (hides_all_)
      scene_.warnings.push_back("all materials have a d of 0, by which nothing is seen: they are read as opaque");
    if (!hidden_.empty()) {
      const bool is_one = hidden_.size() == 1;
      scene_.warnings.push_back((is_one ? hidden_[0] + " has" : counted(hidden_.size(), "material") + " have") +
                                " a Tr of 1 and no d, by which nothing of " + (is_one ? "it" : "them") +
                                " is seen: " + (is_one ? "it is" : "they are") + " read as opaque");
    }
    for (const auto& [statement, count] : left_out_)
      scene_.warnings.push_back("what " + counted(count, "material") + (count == 1 ? " says" : " say") + " by '" +
                                statement + "' is left out");
  }

  /// Says of pictures how their opacities are shown.
  void chooseAlphaModes() {
    std::map<int, AlphaMode> modes;  // of textures, which thousands of materials may share
    for (const std::size_t index : with_opacity_picture_) {
      Material& material = scene_.materials[index];
      const int texture = material.base_color_map.texture;
      if (material.alpha_mode != AlphaMode::opaque || texture < 0) continue;
      const auto [mode, is_new] = modes.try_emplace(texture, AlphaMode::opaque);
      if (is_new) mode->second = chooseAlphaMode(scene_.textures[std::size_t(texture)].image);
      material.alpha_mode = mode->second;
    }
  }

 private:
  void setColors(const MtlMaterial& source, Material& material) {
    const MtlMap& colors = source.map(MtlMapKind::base_color) ? source.map(MtlMapKind::base_color) : source.ambient;
    const MtlMap& opacity = source.map(MtlMapKind::opacity);
    material.base_color_map =
        opacity ? pictures_.colorsWithOpacity(colors, opacity) : pictures_.colors(colors, TextureUse::factors);
    material.emission_map = pictures_.colors(source.map(MtlMapKind::emission), TextureUse::light);
    if (opacity && material.base_color_map.texture >= 0) with_opacity_picture_.push_back(scene_.materials.size() - 1);

    // Many programs write black beside a picture, or nothing, which would hide it.
    const glm::vec3 without = colors && material.base_color_map.texture >= 0 ? glm::vec3(1.0f) : material.base_color;
    glm::vec3 color = source.diffuse.value_or(without);
    if (colors && color == glm::vec3(0.0f)) color = without;
    material.base_color = readFractions(source, color);
    material.emission =
        glm::clamp(source.emission.value_or(glm::vec3(0.0f)), glm::vec3(0.0f), glm::vec3(kBrightestEmission));
    if (!source.map(MtlMapKind::emission)) return;
    // What would glow where a picture that is missing says glows nowhere (lost_textures.h).
    if (material.emission_map.texture < 0)
      material.emission = glm::vec3(0.0f);
    else if (material.emission == glm::vec3(0.0f))
      material.emission = glm::vec3(1.0f);
  }

  /// A Kd in [0, 1].
  glm::vec3 readFractions(const MtlMaterial& source, glm::vec3 color) {
    ChannelRange range;
    for (const float number : {color.r, color.g, color.b}) range.add(number);
    const bool is_of_codes = range.isOfCodes();
    if (range.isBeyond()) {
      const bool is_above = range.greatest() > 1.0f;
      scene_.warnings.push_back(quotedName(source) + " has a Kd of " +
                                formatNumber(is_above ? range.greatest() : range.least()) +
                                (is_above ? ", beyond 1: it is " : ", below 0: it is ") +
                                (is_of_codes ? "read in parts of 255"
                                 : is_above  ? "cut to 1"
                                             : "cut to 0"));
    }
    return glm::clamp(is_of_codes ? color / ChannelRange::kGreatestCode : color, glm::vec3(0.0f), glm::vec3(1.0f));
  }

  void setRoughness(const MtlMaterial& source, Material& material) {
    // The width of the Beckmann lobe that a Phong highlight of this exponent has (Walter et al. 2007, section 5.2).
    const float exponent = std::max(source.exponent.value_or(1.0f), 0.0f);
    const float alpha = std::sqrt(2.0f / (exponent + 2.0f));
    material.perceptual_roughness = source.roughness ? fraction(*source.roughness) : std::sqrt(alpha);
    material.metallic = fraction(source.metallic.value_or(0.0f));
    material.roughness_map = pictures_.factors(source.map(MtlMapKind::roughness));
    material.metallic_map = pictures_.factors(source.map(MtlMapKind::metallic));
    // A picture that is multiplied by 0, or by what is only a guess, would not be seen.
    if (material.roughness_map.texture >= 0 && source.roughness.value_or(0.0f) == 0.0f)
      material.perceptual_roughness = 1.0f;
    if (material.metallic_map.texture >= 0 && material.metallic == 0.0f) material.metallic = 1.0f;
    const bool has_highlight = source.specular && *source.specular != glm::vec3(0.0f);
    if (source.illumination == kDiffuseWithoutHighlight && !has_highlight) material.specular = 0.0f;
    if (source.ior && *source.ior > 1.0f) material.ior = std::min(*source.ior, 10.0f);
  }

  void setOpacity(const MtlMaterial& source, Material& material) {
    material.opacity = fraction(source.dissolve.value_or(1.0f - source.transparency.value_or(0.0f)));
    const bool is_hidden_by_tr = !source.dissolve && material.opacity == 0.0f;
    if (is_hidden_by_tr) hidden_.push_back(quotedName(source));
    if (is_hidden_by_tr || hides_all_) material.opacity = 1.0f;
    if (material.opacity < 1.0f) material.alpha_mode = AlphaMode::blend;
  }

  static void setLayers(const MtlMaterial& source, Material& material) {
    material.sheen_color = glm::vec3(fraction(source.sheen.value_or(0.0f)));
    material.clearcoat = fraction(source.coat.value_or(0.0f));
    material.clearcoat_roughness = fraction(source.coat_roughness.value_or(0.0f));
    material.anisotropy = fraction(source.anisotropy.value_or(0.0f));
    material.anisotropy_rotation = 2.0f * std::numbers::pi_v<float> * fraction(source.anisotropy_turns.value_or(0.0f));
  }

  void setDetail(const MtlMaterial& source, Material& material) {
    const MtlMap& normals = source.map(MtlMapKind::normals);
    material.normal_map = normals ? pictures_.normals(normals) : pictures_.heights(source.map(MtlMapKind::heights));
    if (normals) material.normal_scale = std::clamp(normals.strength, -10.0f, 10.0f);
    material.occlusion_map = pictures_.factors(source.map(MtlMapKind::occlusion));
  }

  NamedPictures& pictures_;
  Scene& scene_;
  bool hides_all_;
  std::vector<std::string> hidden_;                // names of materials, by Tr
  std::map<std::string, std::size_t> left_out_;    // of how many materials which statement is
  std::vector<std::size_t> with_opacity_picture_;  // materials
};

bool isHidden(const MtlMaterial& material) { return material.dissolve && *material.dissolve <= 0.0f; }

}  // namespace

void addObjMaterials(std::span<const MtlMaterial> materials, NamedFiles& named, Scene& scene) {
  NamedPictures pictures(named, scene);
  const bool are_hidden = !materials.empty() && std::all_of(materials.begin(), materials.end(), isHidden);
  // What has no material is a part of the scene already.
  MaterialConverter converter(pictures, scene, are_hidden && scene.materials.empty());
  for (const MtlMaterial& material : materials) converter.add(material);
  pictures.decode();
  converter.chooseAlphaModes();
  converter.tell();
}

}  // namespace mirrorball
