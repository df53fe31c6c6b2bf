#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The transmitting bodies that a ray is inside of. Bodies may overlap, such as water that reaches into the wall of its
/// glass, so that no gap is between them: the one of the greatest Material::priority fills the place, and the surfaces
/// of the others are not there for a ray (Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images").
/// Among equals the one that was entered last fills it, so a ball of air in glass needs no priority.
class Media {
 public:
  /// Beyond this many, bodies inside of bodies are not known.
  static constexpr std::size_t kMax = 8;

  /// instance  index into Scene::instances
  void enter(std::uint32_t instance);
  /// A body that was not entered, as through the hole of an open mesh, changes nothing.
  void leave(std::uint32_t instance);
  bool contains(std::uint32_t instance) const;

  /// The body that fills the place, if it is not empty.
  std::optional<std::uint32_t> filling(const Scene& scene) const;
  /// The same without one body: what is on the other side of its surface.
  std::optional<std::uint32_t> fillingWithout(const Scene& scene, std::uint32_t instance) const;

  /// Whether a body's surface is there for a ray that goes into it or out of it.
  bool hasSurface(const Scene& scene, std::uint32_t instance, bool is_entering) const;

 private:
  std::array<std::uint32_t, kMax> instances_{};  // in the order in which they were entered
  std::uint32_t count_ = 0;
};

}  // namespace mirrorball
