#include "mirrorball/scene/material/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "formula/bsdf.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/optical_constants.h"

namespace mirrorball {
namespace {

Material metal(glm::vec3 color, float perceptual_roughness) {
  Material material;
  material.base_color = color;
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

/// Its base colour is for the other forms of Fresnel's law.
Material conductor(const MeasuredMetal& measured) {
  Material material = metal(formula::fresnelConductor(1.0f, measured.n, measured.k), 0.0f);
  material.conductor_n = measured.n;
  material.conductor_k = measured.k;
  return material;
}

Material clear(const MeasuredGlass& glass) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.perceptual_roughness = 0.0f;
  material.ior = iorOf(glass);
  material.dispersion = 20.0f / abbeNumberOf(glass);
  material.sellmeier_b = glass.b;
  material.sellmeier_c = glass.c;
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
  material.height = HeightKind::orange;
  material.height_scale = 0.008f;
  material.height_frequency = 20.0f;
  return material;
}

Material brushedMetal() {
  Material material = metal({0.56f, 0.57f, 0.58f}, 0.2f);
  material.anisotropy = 0.7f;
  return material;
}

Material carPaint() {
  Material material = metal({0.45f, 0.02f, 0.02f}, 0.45f);
  material.metallic = 0.6f;
  material.clearcoat = 1.0f;
  return material;
}

Material velvet() {
  Material material = coloured({0.10f, 0.01f, 0.03f}, 1.0f);
  material.sheen_color = {0.80f, 0.15f, 0.30f};
  material.sheen_roughness = 0.4f;
  return material;
}

/// A film of water with air on both sides.
Material soapBubble() {
  Material material = coloured(glm::vec3(1.0f), 0.0f);
  material.ior = 1.0f;
  material.transmission = 1.0f;
  material.thin_walled = true;
  material.iridescence = 1.0f;
  material.iridescence_ior = 1.333f;
  return material;
}

/// A material of our own, made when it is asked for.
struct MadeMaterial {
  std::string_view name;
  Material (*make)();
};

constexpr std::array<MadeMaterial, 8> kMade{{
    {"mirror", [] { return metal(glm::vec3(1.0f), 0.0f); }},
    {"rough-metal",
     [] {
       return metal({0.56f, 0.57f, 0.58f}, 0.45f);
     }},
    {"brushed-metal", brushedMetal},
    {"plastic",
     [] {
       return coloured({0.70f, 0.03f, 0.03f}, 0.15f);
     }},
    {"orange", orange},
    {"car-paint", carPaint},
    {"velvet", velvet},
    {"soap-bubble", soapBubble},
}};

/// Names of the list that mean a measured substance of another name.
constexpr auto kTradeNames = std::to_array<Alias>({{"chrome", "chromium"}, {"glass", "bk7"}});

constexpr auto kAliases =
    std::to_array<Alias>({{"mirror-ball", "mirror"}, {"aluminum", "aluminium"}, {"n-bk7", "bk7"}});

/// The whole list: what is our own, what has another name, metals, glasses.
const std::vector<std::string_view>& names() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> list;
    for (const MadeMaterial& made : kMade) list.push_back(made.name);
    for (const Alias& trade : kTradeNames) list.push_back(trade.written);
    for (const MeasuredMetal& measured : measuredMetals()) list.push_back(measured.name);
    for (const MeasuredGlass& glass : measuredGlasses()) list.push_back(glass.name);
    return list;
  }();
  return all;
}

/// The row of a table, or the table's end.
auto rowNamed(const auto& table, std::string_view name) {
  return std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.name == name; });
}

/// A material by a name that is in the list.
Material made(std::string_view listed) {
  const auto* const trade = findBy(kTradeNames, listed, &Alias::written);
  const std::string_view name = trade != kTradeNames.end() ? trade->name : listed;
  if (const auto own = rowNamed(kMade, name); own != kMade.end()) return own->make();
  const auto metals = measuredMetals();
  if (const auto measured = rowNamed(metals, name); measured != metals.end()) return conductor(*measured);
  return clear(*rowNamed(measuredGlasses(), name));
}

}  // namespace

glm::mat2 uvMatrix(const TextureSlot& slot) {
  const float sine = std::sin(slot.rotation_rad);
  const float cosine = std::cos(slot.rotation_rad);
  return {cosine * slot.scale.x, -sine * slot.scale.x, sine * slot.scale.y, cosine * slot.scale.y};
}

std::span<const std::string_view> materialNames() { return names(); }

Result<Material> materialNamed(std::string_view name) {
  const auto index = indexOfName(name, names(), kAliases);
  if (!index) return tl::unexpected<Error>(unknownName("material", name, names()));
  Material material = made(names()[*index]);
  material.name = names()[*index];
  return material;
}

}  // namespace mirrorball
