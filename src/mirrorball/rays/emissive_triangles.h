#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The triangles of a scene that shine by themselves, to choose places of them as often as they are bright and large.
/// Both of their sides shine.
class EmissiveTriangles {
 public:
  /// Nothing shines where every material is unlit: there is nothing to light.
  ///
  /// counts              which instances; all, if it is empty
  /// scene               must outlive this
  /// world_from_normal   of its instances: normalMatrices; must outlive this, too
  /// cost                four places of each triangle whose material has emission, and 24 bytes for it: less than a
  ///                     fifth of what Geometry has for it
  EmissiveTriangles(const Scene& scene, const std::vector<glm::mat3>& world_from_normal,
                    const std::function<bool(std::uint32_t instance)>& counts = {});

  /// Whether there is none to choose.
  bool empty() const { return triangles_.empty(); }

  struct Place {
    Hit hit;             ///< without its distance
    glm::vec3 position;  ///< world
    float density;       ///< of its choice, by area
  };
  /// numbers   in [0, 1): which triangle, and where on it
  Place chosen(glm::vec3 numbers) const;

  /// Whether anything of that instance may shine.
  bool mayShine(std::uint32_t instance) const { return !kept_[instance].empty(); }

  /// The density of choosing a place of that triangle, by area; 0 if it looks dark, as one may whose texture shines in
  /// a small part of it.
  float density(const Hit& hit) const;

  /// The irradiance [luminance] that they would have together at a place, if all faced it and nothing were in the way:
  /// as of a small lamp whose distance is their mean one (root of the mean of squares).
  ///
  /// errors   none may be asked for if it is empty()
  float largestIrradiance(glm::vec3 place) const;

  /// The radiance that leaves a place.
  glm::vec3 emission(const Hit& hit) const;

 private:
  struct Triangle {
    std::uint32_t instance;
    std::uint32_t triangle;  ///< of its mesh
    float area;
  };
  void add(std::uint32_t instance, std::uint32_t triangle);

  const Scene& scene_;
  const std::vector<glm::mat3>& world_from_normal_;
  std::vector<Triangle> triangles_;
  std::vector<double> sums_;                      // of their power, up to and with each
  glm::dvec3 places_{0.0};                        // sum of their middles times their power
  double squares_ = 0.0;                          // likewise of those middles' squares
  std::vector<std::vector<std::uint32_t>> kept_;  // of each instance's triangles the number in triangles_ + 1; 0: dark
};

}  // namespace mirrorball
