#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/path_vertex.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/inspect/light_around.h"
#include "mirrorball/view/inspect/ray_path.h"

namespace mirrorball {

/// What paths are followed in. All that it refers to must outlive it.
struct PathWorld {
  const Scene& scene;
  const Geometry& geometry;
  std::span<const glm::mat3> world_from_normal;  ///< normalMatrices
  ReliefKind relief = ReliefKind::bump;          ///< for which scene and geometry were prepared
  const LightAround& around;
  float reach = 1.0f;     ///< length of a last segment [world units]
  int most_segments = 1;  ///< at least 1
};

/// A path that begins at a surface in one of the two ways, and goes on at each further one by the way of more light: in
/// the mirror direction, or refracted by the index at 588 nm, where reflection may be total. A thin wall lets it go
/// straight on. Bodies in bodies and what absorbs are as the path tracer has them.
///
/// is_refracted   begins so
/// returns        nothing: there is no light that way
/// cost           of each segment Geometry::hit and surfacePointAt: 1 µs for two mirrors; measured
std::optional<RayPath> followedPath(const PathWorld& world, const PathVertex& first, bool is_refracted);

}  // namespace mirrorball
