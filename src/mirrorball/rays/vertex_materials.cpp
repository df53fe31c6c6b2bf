#include "mirrorball/rays/vertex_materials.h"

#include <algorithm>
#include <cstdint>

#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/surface_point.h"

namespace mirrorball {

formula::Material materialInMiddle(const Scene& scene, std::span<const glm::mat3> world_from_normal,
                                   std::size_t instance, std::size_t triangle) {
  const Hit middle{.instance = static_cast<std::uint32_t>(instance),
                   .triangle = static_cast<std::uint32_t>(triangle),
                   .barycentric = glm::vec2(1.0f / 3.0f)};
  return surfacePointAt(scene, world_from_normal[instance], middle, ReliefKind::none).material;
}

namespace {

void addTo(VertexMaterial& sum, const VertexMaterial& each) {
  sum.base_color += each.base_color;
  sum.metallic += each.metallic;
  sum.emission += each.emission;
  sum.perceptual_roughness += each.perceptual_roughness;
}

VertexMaterial scaled(const VertexMaterial& material, float by) {
  return {by * material.base_color, by * material.metallic, by * material.emission, by * material.perceptual_roughness};
}

/// Of each triangle of an instance.
std::vector<VertexMaterial> materialsOfTriangles(const Scene& scene, std::span<const glm::mat3> world_from_normal,
                                                 std::size_t instance) {
  std::vector<VertexMaterial> materials(scene.meshes[std::size_t(scene.instances[instance].mesh)]->indices.size() / 3);
  parallelFor(materials.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const formula::Material material = materialInMiddle(scene, world_from_normal, instance, i);
      materials[i] = {material.base_color, material.metallic, material.emission, material.perceptual_roughness};
    }
  });
  return materials;
}

}  // namespace

std::vector<VertexMaterial> materialsOfVertices(const Scene& scene, const VertexPlaces& places,
                                                std::span<const glm::mat3> world_from_normal) {
  std::vector<VertexMaterial> sums(places.size(), {glm::vec3(0.0f), 0.0f, glm::vec3(0.0f), 0.0f});
  std::vector<float> counts(places.size(), 0.0f);
  for (std::size_t instance = 0; instance < scene.instances.size(); ++instance) {
    const std::vector<std::uint32_t>& indices = scene.meshes[std::size_t(scene.instances[instance].mesh)]->indices;
    const std::vector<VertexMaterial> of_triangles = materialsOfTriangles(scene, world_from_normal, instance);
    for (std::size_t i = 0; i < 3 * of_triangles.size(); ++i) {
      const std::uint32_t vertex = places.vertexNumber(instance, indices[i]);
      addTo(sums[vertex], of_triangles[i / 3]);
      counts[vertex] += 1.0f;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = scaled(sums[v], 1.0f / std::max(counts[v], 1.0f));
  return sums;
}

}  // namespace mirrorball
