#include "mirrorball/scene/material/material.h"

#include <array>
#include <cmath>

#include "formula/bsdf.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

Material metal(glm::vec3 color, float perceptual_roughness) {
  Material material;
  material.base_color = color;
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

/// A metal by its complex index at 650, 550 and 450 nm; its base colour is for the other forms of Fresnel's law.
Material conductor(glm::vec3 n, glm::vec3 k) {
  Material material = metal(formula::fresnelConductor(1.0f, n, k), 0.0f);
  material.conductor_n = n;
  material.conductor_k = k;
  return material;
}

Material clear(float ior, float abbe_number) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.perceptual_roughness = 0.0f;
  material.ior = ior;
  material.dispersion = 20.0f / abbe_number;
  material.transmission = 1.0f;
  return material;
}

Material coloured(glm::vec3 color, float perceptual_roughness) {
  Material material;
  material.base_color = color;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

Material orange() {
  Material material = coloured({0.90f, 0.33f, 0.02f}, 0.32f);
  material.bump = BumpHeight::orange;
  material.bump_height = 0.008f;
  material.bump_frequency = 20.0f;
  return material;
}

/// A material of the list, made when it is asked for.
struct NamedMaterial {
  std::string_view name;
  Material (*make)();
};

// Gold and chromium: Johnson & Christy 1972 and 1974. Glass BK7, water and diamond: index at 588 nm and Abbe's number
// from the usual tables (Schott's catalogue; Hale & Querry 1973; Peter 1923).
constexpr std::array<NamedMaterial, 9> kMaterials{{
    {"mirror", [] { return metal(glm::vec3(1.0f), 0.0f); }},
    {"chrome",
     [] {
       return conductor({3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f});
     }},
    {"gold",
     [] {
       return conductor({0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.916f});
     }},
    {"glass", [] { return clear(1.517f, 64.2f); }},
    {"water", [] { return clear(1.333f, 55.8f); }},
    {"diamond", [] { return clear(2.417f, 55.3f); }},
    {"rough-metal",
     [] {
       return metal({0.56f, 0.57f, 0.58f}, 0.45f);
     }},
    {"plastic",
     [] {
       return coloured({0.70f, 0.03f, 0.03f}, 0.15f);
     }},
    {"orange", orange},
}};

constexpr auto kAliases = std::to_array<Alias>({{"chromium", "chrome"}, {"mirror-ball", "mirror"}});

constexpr auto kNames = [] {
  std::array<std::string_view, kMaterials.size()> names;
  for (std::size_t index = 0; index < names.size(); ++index) names[index] = kMaterials[index].name;
  return names;
}();

}  // namespace

glm::mat2 uvMatrix(const TextureSlot& slot) {
  const float sine = std::sin(slot.rotation_rad);
  const float cosine = std::cos(slot.rotation_rad);
  return {cosine * slot.scale.x, -sine * slot.scale.x, sine * slot.scale.y, cosine * slot.scale.y};
}

std::span<const std::string_view> materialNames() { return kNames; }

Result<Material> materialNamed(std::string_view name) {
  const auto index = indexOfName(name, kNames, kAliases);
  if (!index) return tl::unexpected<Error>(unknownName("material", name, kNames));
  Material material = kMaterials[*index].make();
  material.name = kNames[*index];
  return material;
}

}  // namespace mirrorball
