#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball {

enum class AlphaMode { opaque, mask, blend };

/// What the normals of a normal map are told in.
enum class NormalSpace {
  tangent,  ///< the directions of growing u and falling v, and the normal: glTF's
  object,   ///< the mesh's own axes
};

/// A texture slot of a material: which texture, which texture coordinates, and glTF's KHR_texture_transform.
struct TextureSlot {
  int texture = -1;  ///< index into Scene::textures; −1: none
  int uv_set = 0;    ///< 0 or 1
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation_rad = 0.0f;  ///< counter-clockwise, as KHR_texture_transform says

  bool operator==(const TextureSlot&) const = default;
};

/// KHR_texture_transform without its offset: texture coordinates are scaled, then turned.
glm::mat2 uvMatrix(const TextureSlot& slot);

/// How a surface reflects light: numbers (formula/material.glsl), the textures that multiply them as in glTF 2.0, and
/// settings that are not numbers.
struct Material : formula::Material {
  std::string name;
  HeightKind height = HeightKind::none;
  int height_texture = -1;  ///< index into Scene::height_textures, where relief.h needs one
  int slope_texture = -1;   ///< index into Scene::slope_textures; bends normals where no heights are shown
  NormalSpace normal_space = NormalSpace::tangent;  ///< of normal_map
  AlphaMode alpha_mode = AlphaMode::opaque;
  bool double_sided = false;
  bool unlit = false;        ///< shows its base colour as radiance, and answers to no light
  bool thin_walled = false;  ///< transmits like a sheet, without a body that refracts
  int priority = 0;          ///< of bodies that overlap, the one with the greatest fills the place; up to ±1000

  TextureSlot base_color_map;
  TextureSlot metallic_map;   ///< in B
  TextureSlot roughness_map;  ///< in G
  TextureSlot normal_map;
  TextureSlot occlusion_map;  ///< in R
  TextureSlot emission_map;
  TextureSlot specular_map;  ///< in A
  TextureSlot specular_color_map;
  TextureSlot transmission_map;         ///< in R
  TextureSlot clearcoat_map;            ///< in R
  TextureSlot clearcoat_roughness_map;  ///< in G
  TextureSlot clearcoat_normal_map;
  TextureSlot sheen_color_map;
  TextureSlot sheen_roughness_map;        ///< in A
  TextureSlot anisotropy_map;             ///< direction in RG, strength in B
  TextureSlot iridescence_map;            ///< in R
  TextureSlot iridescence_thickness_map;  ///< in G
};

/// Whether a material fills what its triangles enclose, as glass does; else the triangles are all that there is.
inline bool isBody(const Material& material) {
  return material.transmission > 0.0f && !material.thin_walled && !material.unlit;
}

/// A parameter of materials: one row of a table from which come --set, the documentation, the uniform block of the
/// shaders and the reading of glTF.
struct MaterialParameter : Option<Material> {
  std::string_view gltf = {};  ///< where glTF has it: "pbrMetallicRoughness.metallicFactor"; empty: nowhere
};

/// As far as the table goes.
inline constexpr float kBrightestEmission = 1e6f;

/// How many numbers glTF has for a parameter with a key there: for base_color a fourth, which is the opacity.
std::size_t gltfNumbers(const MaterialParameter& parameter);

/// Sets a parameter to as many of glTF's numbers, cut to its range. An opaque material stays so.
void setGltfNumbers(const MaterialParameter& parameter, std::span<const double> numbers, Material& material);

/// The table of every number and choice that --set takes.
std::span<const MaterialParameter> materialParameters();

/// A texture of materials: one row of a table, likewise.
struct MaterialMap {
  std::string_view name;  ///< "base_color_map"
  TextureSlot Material::*slot;
  bool srgb;              ///< its colour channels are sRGB-encoded
  std::string_view gltf;  ///< "pbrMetallicRoughness.baseColorTexture"
  std::string_view help;
  glm::vec4 absent{1.0f};                    ///< what a material without this texture has everywhere
  float formula::Material::*zero = nullptr;  ///< of a normal map: the code that stands for 0; of others none

  bool holdsNormals() const { return zero != nullptr; }
};

/// MaterialMap::absent of `anisotropy_map`: along the tangent, in full.
inline constexpr glm::vec4 kAbsentAnisotropyMap{1.0f, 0.5f, 1.0f, 1.0f};

/// The table of these textures, in the order in which the shaders number them.
std::span<const MaterialMap> materialMaps();

/// "mirror", "rough-metal", "brushed-metal", "plastic", "orange", "car-paint", "velvet", "soap-bubble", "chrome",
/// "glass", and the metals and glasses of optical_constants.h.
std::span<const std::string_view> materialNames();

/// A material of that list.
///
/// errors   usage: suggests the nearest name and lists all
Result<Material> materialNamed(std::string_view name);

/// Sets one parameter of materialParameters() from "key=value".
///
/// errors   usage: a wrong key lists the right ones, a wrong value its range
Result<void> setParameter(Material& material, std::string_view assignment);

}  // namespace mirrorball
