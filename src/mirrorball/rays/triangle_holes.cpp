#include "mirrorball/rays/triangle_holes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "formula/bodies.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/surface_point.h"

namespace mirrorball {
namespace {

/// Cells of a picture's texel or two, or of more in large ones; 0: the triangle counts as whole, since cells would say
/// nothing of a picture that is repeated so often.
int rowsOf(const Scene& scene, const Material& material, const Mesh& mesh, std::size_t triangle) {
  constexpr int kMostRows = 32;
  constexpr float kMostRepeats = 4.0f;
  const auto alpha = [&](std::size_t corner) { return mesh.vertices[mesh.indices[3 * triangle + corner]].color.w; };
  const int of_vertices = alpha(0) == alpha(1) && alpha(0) == alpha(2) ? 1 : 8;
  const TextureSlot& slot = material.base_color_map;
  if (slot.texture < 0) return of_vertices;
  const SharedPicture& image = scene.textures[std::size_t(slot.texture)].image;
  float longest = static_cast<float>(of_vertices) * 1.5f;
  for (std::size_t side = 0; side < 3; ++side) {
    const auto uv = [&](std::size_t corner) {
      return mesh.vertices[mesh.indices[3 * triangle + corner % 3]].uv[std::size_t(slot.uv_set)];
    };
    const glm::vec2 repeats = uvMatrix(slot) * (uv(side + 1) - uv(side));
    if (glm::length(repeats) > kMostRepeats) return 0;
    longest = std::max(longest, glm::length(repeats * glm::vec2(image.width(), image.height())));
  }
  return static_cast<int>(std::clamp(std::ceil(longest / 1.5f), 1.0f, static_cast<float>(kMostRows)));
}

TriangleHoles holesOf(const Scene& scene, std::uint32_t instance, std::uint32_t triangle) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const int rows = rowsOf(scene, materialOf(scene, instance), mesh, triangle);
  if (rows == 0) return {};
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
  std::map<int, std::uint32_t> first_of_mesh;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    Instance& instance = scene.instances[i];
    instance.holes.clear();
    if (const auto [first, is_first] = first_of_mesh.emplace(instance.mesh, i); !is_first) {
      instance.holes = scene.instances[first->second].holes;
      continue;
    }
    if (materialOf(scene, i).alpha_mode != AlphaMode::mask) continue;
    std::vector<TriangleHoles> holes(scene.meshes[std::size_t(instance.mesh)]->indices.size() / 3);
    parallelFor(holes.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t triangle = begin; triangle < end; ++triangle)
        holes[triangle] = holesOf(scene, i, static_cast<std::uint32_t>(triangle));
    });
    if (std::any_of(holes.begin(), holes.end(), [](const TriangleHoles& each) { return each.rows > 0; }))
      instance.holes = std::move(holes);
  }
}

}  // namespace mirrorball
