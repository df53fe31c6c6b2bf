#include "mirrorball/view/inspect/inspection_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace mirrorball {
namespace {

/// What is next to nothing beside the greatest is the rounding of a 0.
std::string rounded(std::span<const float> numbers) {
  constexpr float kRounding = 1e-6f;
  float greatest = 0.0f;
  for (const float number : numbers) greatest = std::max(greatest, std::abs(number));
  std::string text;
  for (const float number : numbers) {
    const bool is_rounding = std::abs(number) < kRounding * greatest;
    std::array<char, 32> written{};
    std::snprintf(written.data(), written.size(), "%.4g", is_rounding ? 0.0 : static_cast<double>(number));
    text += (text.empty() ? "" : ", ") + std::string(written.data());
  }
  return text;
}
std::string rounded(float number) { return rounded({&number, 1}); }
std::string rounded(glm::vec3 v) { return rounded({&v.x, 3}); }

std::string roundedValue(const MaterialParameter& parameter, const Material& material) {
  if (const auto* number = std::get_if<float Material::*>(&parameter.field)) return rounded(material.*(*number));
  if (const auto* vector = std::get_if<glm::vec3 Material::*>(&parameter.field)) return rounded(material.*(*vector));
  return written(parameter, material);
}

/// What is said of a material even where it is as in a new one.
bool isAlwaysTold(std::string_view parameter) {
  constexpr std::array<std::string_view, 4> kAlways{"base_color", "metallic", "perceptual_roughness", "ior"};
  return std::find(kAlways.begin(), kAlways.end(), parameter) != kAlways.end();
}

void addMaterial(std::vector<InspectionRow>& rows, const InspectedSurface& surface, const Scene& scene) {
  Material here = scene.materials[surface.picked.material];
  static_cast<formula::Material&>(here) = surface.material;
  const Material usual;
  rows.push_back({"material", here.name.empty() ? std::to_string(surface.picked.material) : here.name});
  for (const MaterialParameter& parameter : materialParameters())
    if (isAlwaysTold(parameter.text.name) || written(parameter, here) != written(parameter, usual))
      rows.push_back(
          {std::string(parameter.text.name), roundedValue(parameter, here), std::string(parameter.text.unit)});
}

void addPlace(std::vector<InspectionRow>& rows, const InspectedSurface& surface, const Scene& scene) {
  const Picked& picked = surface.picked;
  if (picked.node >= 0) rows.push_back({"object", scene.rig.nodes[std::size_t(picked.node)].name});
  rows.push_back({"instance", std::to_string(picked.instance)});
  if (picked.triangle) rows.push_back({"triangle", std::to_string(*picked.triangle)});
  rows.push_back({"place", rounded(picked.position), "world units"});
  rows.push_back({"geometric normal", rounded(surface.geometric_normal)});
  rows.push_back({"smooth normal", rounded(picked.smooth_normal)});
  rows.push_back({"normal", rounded(picked.normal)});
  rows.push_back({"texture coordinates", rounded({&picked.uv.x, 2})});
  rows.push_back({"seen from", surface.is_inside ? "within the body" : "outside"});
  rows.push_back({"angle", rounded(surface.fresnel.here.angle_deg), "degrees"});
  rows.push_back({"reflectance", rounded(surface.fresnel.here.reflectance)});
}

std::string_view wordsOf(PathEnd end) {
  switch (end) {
    case PathEnd::environment:
      return "the environment";
    case PathEnd::matt:
      return "a matt surface";
    case PathEnd::faint:
      return "too faint to follow";
    case PathEnd::limit:
      return "too many surfaces";
  }
  return "";
}

void addPath(std::vector<InspectionRow>& rows, std::string_view name, const std::optional<RayPath>& path) {
  if (!path) return;
  const std::string way(name);
  const std::size_t bounces = path->segments.size();
  rows.push_back({way + " from", std::string(wordsOf(path->end))});
  if (bounces > 0) rows.push_back({way + " by way of", std::to_string(bounces), bounces == 1 ? "surface" : "surfaces"});
  if (path->end != PathEnd::environment) return;
  rows.push_back({way + " direction", rounded(path->direction)});
  rows.push_back({way + " radiance", rounded(path->radiance)});
  if (bounces > 0) rows.push_back({way + " share", rounded(path->segments.back().share)});
}

}  // namespace

std::vector<InspectionRow> rowsOf(const Inspection& inspection, const Scene& scene) {
  std::vector<InspectionRow> rows;
  if (inspection.surface) {
    addPlace(rows, *inspection.surface, scene);
    addMaterial(rows, *inspection.surface, scene);
    addPath(rows, "reflected", inspection.surface->reflected);
    addPath(rows, "refracted", inspection.surface->refracted);
  }
  addPath(rows, "background", inspection.behind);
  return rows;
}

}  // namespace mirrorball
