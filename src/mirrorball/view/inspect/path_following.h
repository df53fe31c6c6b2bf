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

/// How a ray meets a surface.
struct SurfaceView {
  bool is_inside = false;  ///< from within a body
  float cosine = 0.0f;     ///< of the angle between it and the normal on its side, 0 … 1
};
SurfaceView seenSide(const PathVertex& vertex);

/// Light of all directions at a surface, linear: how much of it goes on to where the ray comes from, by the mirror
/// direction and by the refracted one. The rest is scattered or absorbed. Without what a clear coat or cloth adds.
struct SurfaceShares {
  glm::vec3 reflected{0.0f};
  glm::vec3 refracted{0.0f};
  bool is_total = false;  ///< all is reflected, of a surface that lets light through
};
SurfaceShares sharesAt(const PathVertex& vertex);

/// A path that begins at a surface in one of the two ways, and goes on at each further one by the way of more light: in
/// the mirror direction, or refracted by the index at 588 nm, where reflection may be total. A thin wall lets it go
/// straight on. Bodies in bodies and what absorbs are as the path tracer has them.
///
/// is_refracted   begins so
/// returns        nothing: there is no light that way
/// cost           of each segment Geometry::hit and surfacePointAt: 1 µs for two mirrors; measured
std::optional<RayPath> followedPath(const PathWorld& world, const PathVertex& first, bool is_refracted);

}  // namespace mirrorball
