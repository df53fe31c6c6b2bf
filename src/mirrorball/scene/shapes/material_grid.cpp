#include "mirrorball/scene/shapes/material_grid.h"

#include <array>
#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/facing_viewer.h"

namespace mirrorball {
namespace {

constexpr auto kGrids = std::to_array<MaterialGrid>({
    {"roughness-grid", "plastic", "base_color=0.9,0.6,0.3", "perceptual_roughness", "0 0.25 0.5 0.75 1", "metallic",
     "0 0.5 1"},
    {"transmission-grid", "glass", "dispersion=0", "perceptual_roughness", "0 0.1 0.2 0.4 0.7", "thin_walled",
     "no yes"},
    {"index-grid", "glass", "ior=1.5", "ior", "1 1.15 1.33 1.6 2.4", "dispersion", "0 1"},
    {"attenuation-grid", "glass", "dispersion=0", "attenuation_distance", "8 4 2 1 0.5", "attenuation_color",
     "0.9,0.3,0.2 0.2,0.8,0.4 0.3,0.4,0.9"},
    {"clearcoat-grid", "orange", "base_color=0.1,0.2,0.6 perceptual_roughness=0.6 clearcoat=1", "clearcoat_roughness",
     "0 0.1 0.2 0.4 0.7", "clearcoat", "0 0.5 1"},
    {"sheen-grid", "velvet", "base_color=0.05", "sheen_roughness", "0.1 0.3 0.5 0.75 1", "sheen_color",
     "0.9,0.9,0.9 0.8,0.2,0.3 0.1,0.3,0.8"},
    {"anisotropy-grid", "brushed-metal", "perceptual_roughness=0.25", "anisotropy", "0 0.25 0.5 0.75 1",
     "anisotropy_rotation", "0 0.7854 1.5708"},
    {"iridescence-grid", "plastic", "base_color=0.6 perceptual_roughness=0.1 iridescence=1", "iridescence_thickness",
     "150 250 350 500 800", "metallic", "0 1"},
});

Material changed(Material material, std::string_view assignments) {
  for (const std::string& assignment : split(assignments, ' ')) {
    [[maybe_unused]] const auto done = setParameter(material, assignment);
    assert(done);
  }
  return material;
}

}  // namespace

std::span<const MaterialGrid> materialGrids() { return kGrids; }

Scene materialGridScene(const MaterialGrid& grid) {
  constexpr float kBallRadius = 0.9f;
  constexpr int kBallRings = 48;
  const std::vector<std::string> columns = split(grid.columns, ' ');
  const std::vector<std::string> rows = split(grid.rows, ' ');
  const Material base = changed(*materialNamed(grid.material), grid.set);
  const glm::vec2 middle = (glm::vec2(columns.size(), rows.size()) - 1.0f) / 2.0f;
  Scene scene;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const std::string both =
          std::string(grid.column) + "=" + columns[column] + " " + std::string(grid.row) + "=" + rows[row];
      Mesh mesh = sphereMesh(kBallRings, 2 * kBallRings);
      mesh.material = static_cast<int>(scene.materials.size());
      scene.materials.push_back(changed(base, both));
      const glm::vec3 place(2.0f * (static_cast<float>(column) - middle.x), 2.0f * (middle.y - static_cast<float>(row)),
                            0.0f);
      scene.instances.push_back({static_cast<int>(scene.meshes.size()),
                                 glm::scale(glm::translate(facingViewer(), place), glm::vec3(kBallRadius))});
      scene.meshes.push_back(std::move(mesh));
    }
  return scene;
}

}  // namespace mirrorball
