#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/transfer/texel_cover.h"

namespace mirrorball {

/// The frame in which a normal map is read, as `mappedNormal` of formula/surface/tangent.glsl makes it; world,
/// orthonormal.
struct MapFrame {
  glm::vec3 tangent{1.0f, 0.0f, 0.0f};
  glm::vec3 bitangent{0.0f, 1.0f, 0.0f};
  glm::vec3 normal{0.0f, 0.0f, 1.0f};

  glm::vec3 toLocal(glm::vec3 world) const {
    return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
  }
  glm::vec3 toWorld(glm::vec3 local) const { return local.x * tangent + local.y * bitangent + local.z * normal; }
};

/// A place of a surface on which a map lies.
struct MappedPlace {
  glm::vec3 position{0.0f};  ///< world
  glm::vec3 outwards{0.0f};  ///< world, unit: the way from which detail is looked for
  MapFrame frame;
  std::uint32_t instance = 0;  ///< index into Scene::instances
};

/// The triangles of a scene by their first texture coordinates.
class MappedSurface {
 public:
  /// How a place's `outwards` is found.
  enum class Outwards {
    vertex_normal,  ///< the interpolated normal: as edges are, sharp or smooth
    mean_normal,    ///< interpolated between means of all triangles at a place: goes on over sharp edges
  };

  /// scene    must outlive it
  /// errors   bad_shape: there are no triangles, or none with texture coordinates
  static Result<MappedSurface> make(const Scene& scene, Outwards outwards = Outwards::vertex_normal);

  /// All triangles, instance by instance.
  std::vector<UvTriangle> uvTriangles() const;

  /// sample   covered by one of uvTriangles()
  MappedPlace at(const CoverSample& sample) const;

  /// A unit normal of the world in the axes of an instance's mesh, and back.
  glm::vec3 objectNormal(std::uint32_t instance, glm::vec3 world) const;
  glm::vec3 worldNormal(std::uint32_t instance, glm::vec3 object) const;

 private:
  struct Triangle {
    std::uint32_t instance;
    std::uint32_t first_index;
  };

  explicit MappedSurface(const Scene& scene) : scene_(&scene) {}
  const Mesh& meshOf(std::uint32_t instance) const;

  const Scene* scene_;
  std::vector<Triangle> triangles_;
  std::vector<glm::mat3> world_from_normal_;          ///< of instances
  std::vector<std::vector<glm::vec3>> mean_normals_;  ///< of meshes, if they are asked for, object space
};

}  // namespace mirrorball
