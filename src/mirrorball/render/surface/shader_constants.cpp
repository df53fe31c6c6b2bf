#include "mirrorball/render/surface/shader_constants.h"

#include <algorithm>
#include <cstddef>

#include "mirrorball/render/surface/light_reads.h"

namespace mirrorball {
namespace {

bool hasTexture(TextureSlot Material::*slot, const std::vector<MapSource>& maps) {
  const auto rows = materialMaps();
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (rows[row].slot == slot && maps[row].unit >= 0) return true;
  return false;
}

}  // namespace

ShaderConstants shaderConstants(const Material& material, const std::vector<MapSource>& maps,
                                const FrameSettings& settings) {
  return {.texture_filter = static_cast<int>(settings.texture_filter),
          .blur_kind = blurKindOfFormula(settings.blur),
          .lobe_taps = lobesOf(settings),
          .fresnel = material.fresnel,
          .has_conductor_index = material.conductor_k != glm::vec3(0.0f),
          .disperses = material.dispersion != 0.0f,
          .has_specular_color =
              material.specular_color != glm::vec3(1.0f) || hasTexture(&Material::specular_color_map, maps)};
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
          flag("HAS_SPECULAR_COLOR", constants.has_specular_color)};
}

}  // namespace mirrorball
