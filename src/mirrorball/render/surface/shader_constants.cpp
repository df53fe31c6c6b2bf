#include "mirrorball/render/surface/shader_constants.h"

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/render/surface/light_reads.h"

namespace mirrorball {

ShaderConstants shaderConstants(const Material& material, const FrameSettings& settings) {
  const int texture_filter = static_cast<int>(settings.texture_filter);
  if (material.unlit) return {.texture_filter = texture_filter};
  return {.texture_filter = texture_filter,
          .blur_kind = blurKindOfFormula(settings.blur),
          .lobe_taps = lobesOf(settings),
          .fresnel = material.fresnel,
          .has_conductor_index = formula::hasConductorIndex(material),
          .disperses = material.dispersion != 0.0f,
          .has_specular_color = material.specular_color != glm::vec3(1.0f) || material.specular_color_map.texture >= 0,
          .has_smooth_coat = hasSmoothCoat(material)};
}

ShaderConstants seenFromInside(const ShaderConstants& constants) {
  return {
      .texture_filter = constants.texture_filter, .blur_kind = constants.blur_kind, .lobe_taps = constants.lobe_taps};
}

bool hasWideLobes(const Material& material, const ShaderConstants& constants, const formula::Blur& blur) {
  if (constants.blur_kind != 0) return false;
  const float narrowest = constants.lobe_taps > 1 ? formula::kNarrowestInRow : 1.0f;
  const auto isWide = [&](float perceptual_roughness, const TextureSlot& map) {
    return map.texture < 0 && formula::lodOfRoughness(narrowest * perceptual_roughness, blur.last_level) >= 1.0f;
  };
  const bool has_coat = material.clearcoat > 0.0f;
  return isWide(material.perceptual_roughness, material.roughness_map) &&
         (!has_coat || isWide(material.clearcoat_roughness, material.clearcoat_roughness_map));
}

bool hasSmoothCoat(const Material& material) {
  return material.clearcoat > 0.0f && material.clearcoat_roughness == 0.0f && material.clearcoat_normal_map.texture < 0;
}

std::vector<std::string> definitionsOf(const ShaderConstants& constants) {
  const auto number = [](const char* name, int value) { return name + (' ' + std::to_string(value)); };
  const auto flag = [](const char* name, bool value) { return std::string(name) + (value ? " true" : " false"); };
  return {number("TEXTURE_FILTER", constants.texture_filter),
          number("BLUR_KIND", constants.blur_kind),
          number("LOBE_TAPS", constants.lobe_taps),
          number("FRESNEL", constants.fresnel),
          flag("HAS_CONDUCTOR_INDEX", constants.has_conductor_index),
          flag("DISPERSES", constants.disperses),
          flag("HAS_SPECULAR_COLOR", constants.has_specular_color),
          flag("HAS_SMOOTH_COAT", constants.has_smooth_coat),
          flag("HAS_WIDE_LOBES", constants.has_wide_lobes)};
}

}  // namespace mirrorball
