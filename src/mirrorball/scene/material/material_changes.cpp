#include "mirrorball/scene/material/material_changes.h"

#include <algorithm>
#include <array>
#include <variant>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/material/set_parameter.h"

namespace mirrorball {
namespace {

const std::string kMaterialHelp = "use this material for every surface: " + join(materialNames(), " ");

const auto kMaterialOptions = std::to_array<Option<MaterialChanges>>({
    {{.name = "variant",
      .value = "NAME",
      .help = "show this one of the model's own variants (KHR_materials_variants); a wrong name lists them, and so "
              "does `mirrorball info`",
      .group = "Material"},
     &MaterialChanges::variant},
    {{.name = "material",
      .value = "NAME",
      .help = kMaterialHelp,
      .group = "Material",
      .is_daily = true,
      .names = materialNames},
     &MaterialChanges::material},
    {{.name = "set",
      .value = "KEY=VALUE",
      .help = "set one parameter of every material; may be repeated. `mirrorball help materials` lists the parameters",
      .group = "Material",
      .is_daily = true},
     &MaterialChanges::set},
    {{.name = "fresnel",
      .choices = "material|exact|schlick|empirical|f82",
      .help = "Fresnel formula of every material; material keeps each one's own, empirical is offset + scale (1 + "
              "V·N)^power, f82 is schlick with a dip at 82° for metals",
      .group = "Material"},
     choiceField<&MaterialChanges::fresnel>},
});

bool movesMaterial(const AnimationTarget& target) {
  const auto* light = std::get_if<LightTarget>(&target);
  return std::holds_alternative<ParameterTarget>(target) || std::holds_alternative<TextureTarget>(target) ||
         (light != nullptr && light->of == LightTarget::Of::emission);
}

/// One material for every surface, which no animation moves.
void replaceMaterials(Scene& scene, const Material& material) {
  scene.materials = {material};
  for (Animation& animation : scene.rig.animations)
    std::erase_if(animation.channels, [](const AnimationChannel& each) { return movesMaterial(each.target); });
  scene.variants.clear();
  for (Shared<Mesh>& shared : scene.meshes) {
    const auto is_white = [](const Vertex& vertex) { return vertex.color == glm::vec4(1.0f); };
    const bool is_so = shared->material == 0 && shared->material_of_variant.empty() &&
                       std::all_of(shared->vertices.begin(), shared->vertices.end(), is_white);
    if (is_so) continue;
    Mesh& mesh = shared.edit();
    mesh.material = 0;
    mesh.material_of_variant.clear();
    for (Vertex& vertex : mesh.vertices) vertex.color = glm::vec4(1.0f);
  }
}

}  // namespace

std::span<const Option<MaterialChanges>> materialOptions() { return kMaterialOptions; }

Result<void> changeMaterials(Scene& scene, const MaterialChanges& changes) {
  if (!changes.variant.empty()) MIRRORBALL_TRY_VOID(chooseVariant(scene, changes.variant));
  if (!changes.material.empty()) {
    MIRRORBALL_TRY(material, materialNamed(changes.material));
    replaceMaterials(scene, material);
  }
  if (scene.materials.empty()) scene.materials.emplace_back();
  if (changes.fresnel != FresnelOverride::material)
    for (Material& material : scene.materials) material.fresnel = static_cast<int>(changes.fresnel) - 1;
  for (const std::string& assignment : changes.set) MIRRORBALL_TRY_VOID(setParameter(scene, assignment));
  return {};
}

Result<void> checkChanges(const MaterialChanges& changes) {
  if (!changes.material.empty()) MIRRORBALL_TRY_VOID(materialNamed(changes.material));
  for (const std::string& assignment : changes.set) MIRRORBALL_TRY_VOID(checkParameter(assignment));
  return {};
}

}  // namespace mirrorball
