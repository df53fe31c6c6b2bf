#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

enum class FresnelModel { exact, schlick, empirical };
enum class BumpHeight { none, orange };
enum class AlphaMode { opaque, mask, blend };

/// A texture slot of a material: which texture, which texture coordinates, and glTF's KHR_texture_transform.
struct TextureSlot {
  int texture = -1;  ///< index into Scene::textures; −1: none
  int uv_set = 0;    ///< 0 or 1
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation_rad = 0.0f;  ///< counter-clockwise, as KHR_texture_transform says
};

/// How a surface answers to light. The numbers are the parameters of the command line's --set, in one table
/// (materialParameters); textures multiply them as glTF 2.0 says.
struct Material {
  std::string name;

  glm::vec3 base_color{0.8f};  ///< linear: diffuse albedo, or a metal's reflectance head-on
  float opacity = 1.0f;
  float metallic = 0.0f;
  float perceptual_roughness = 0.5f;
  float specular = 1.0f;        ///< strength of a dielectric's reflection; 0 leaves pure diffuse
  float ior = 1.5f;             ///< index of refraction at 588 nm, inside over outside
  float dispersion = 0.0f;      ///< 20 / Abbe number (KHR_materials_dispersion)
  float transmission = 0.0f;    ///< share of the light which is not reflected that is refracted through
  glm::vec3 conductor_n{0.0f};  ///< complex index n + ik of a metal, per channel; all 0: from base_color
  glm::vec3 conductor_k{0.0f};
  glm::vec3 emission{0.0f};  ///< radiance

  FresnelModel fresnel = FresnelModel::exact;
  float fresnel_offset = 0.0f;  ///< of the empirical form: offset + scale · (1 + V·N)^power
  float fresnel_scale = 1.0f;
  float fresnel_power = 5.0f;

  BumpHeight bump = BumpHeight::none;
  float bump_height = 0.01f;     ///< in model units
  float bump_frequency = 12.0f;  ///< dimples a model unit

  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;

  TextureSlot base_color_texture;
  TextureSlot metallic_roughness_texture;  ///< roughness in G, metallic in B
  TextureSlot normal_texture;
  TextureSlot occlusion_texture;  ///< in R
  TextureSlot emission_texture;
  float normal_scale = 1.0f;
  float occlusion_strength = 1.0f;
};

/// The table of every parameter that --set takes.
std::span<const Option<Material>> materialParameters();

/// "mirror", "chrome", "gold", "glass", "water", "diamond", "rough-metal", "plastic", "orange".
std::span<const std::string_view> materialNames();

/// A material of that list.
///
/// errors   usage: suggests the nearest name and lists all
Result<Material> materialNamed(std::string_view name);

/// Sets one parameter from "key=value".
///
/// errors   usage: a wrong key lists the right ones, a wrong value its range
Result<void> setParameter(Material& material, std::string_view assignment);

}  // namespace mirrorball
