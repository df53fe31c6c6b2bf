#include "mirrorball/rays/triangle_holes.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "formula/bodies.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/surface_point.h"

namespace mirrorball {
namespace {

/// Cells of a picture's texel or two, but not so many that a model takes long.
int rowsOf(const Scene& scene, const Material& material, const Mesh& mesh, std::size_t triangle) {
  constexpr int kMostRows = 32;
  const TextureSlot& slot = material.base_color_map;
  if (slot.texture < 0) return 1;
  const Image8& image = scene.textures[std::size_t(slot.texture)].image;
  float longest = 0.0f;
  for (std::size_t side = 0; side < 3; ++side) {
    const auto uv = [&](std::size_t corner) {
      return mesh.vertices[mesh.indices[3 * triangle + corner % 3]].uv[std::size_t(slot.uv_set)];
    };
    const glm::vec2 texels = uvMatrix(slot) * (uv(side + 1) - uv(side)) * glm::vec2(image.width(), image.height());
    longest = std::max(longest, glm::length(texels));
  }
  return static_cast<int>(std::clamp(std::ceil(longest / 1.5f), 1.0f, static_cast<float>(kMostRows)));
}

TriangleHoles holesOf(const Scene& scene, std::uint32_t instance, std::uint32_t triangle) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const int rows = rowsOf(scene, materialOf(scene, instance), mesh, triangle);
  TriangleHoles holes{.rows = rows, .bits = std::vector<std::uint32_t>(std::size_t(rows * rows + 31) / 32, 0u)};
  bool has_any = false;
  const auto look = [&](glm::vec2 cells) {
    const glm::vec2 place = cells / static_cast<float>(rows);
    const Hit hit{.instance = instance, .triangle = triangle, .barycentric = place};
    if (opacityAt(scene, hit) > 0.0f) return;
    const auto cell = static_cast<unsigned>(formula::cellOfTriangle(place, rows));
    holes.bits[cell / 32] |= 1u << cell % 32;
    has_any = true;
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; i + j < rows; ++j) {
      look(glm::vec2(i, j) + 1.0f / 3.0f);
      if (i + j + 1 < rows) look(glm::vec2(i, j) + 2.0f / 3.0f);
    }
  return has_any ? holes : TriangleHoles();
}

}  // namespace

void findHoles(Scene& scene) {
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    Instance& instance = scene.instances[i];
    instance.holes.clear();
    if (materialOf(scene, i).alpha_mode != AlphaMode::mask) continue;
    std::vector<TriangleHoles> holes(scene.meshes[std::size_t(instance.mesh)].indices.size() / 3);
    parallelFor(holes.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t triangle = begin; triangle < end; ++triangle)
        holes[triangle] = holesOf(scene, i, static_cast<std::uint32_t>(triangle));
    });
    if (std::any_of(holes.begin(), holes.end(), [](const TriangleHoles& each) { return each.rows > 0; }))
      instance.holes = std::move(holes);
  }
}

}  // namespace mirrorball
