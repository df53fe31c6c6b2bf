#pragma once

#include <span>

#include <glm/glm.hpp>

#include "formula/bodies.h"
#include "formula/material.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/ray.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where a path has met a surface.
struct PathVertex {
  Hit hit;
  Ray arriving;
  const Material* surface;
  SurfacePoint point;
  bool is_body;
  bool is_outside;         ///< the ray comes from the side that the triangle's corners go round counter-clockwise
  const Material* beyond;  ///< the body on its other side: outside of a body, and on both sides of other surfaces
};

/// world_from_normal   of each instance: normalMatrices
/// hit                 of the ray, with the media in which SurfaceFinder::first has found it
/// returns             what holds references to the scene, which must outlive it
/// cost                surfacePointAt
PathVertex pathVertexAt(const Scene& scene, std::span<const glm::mat3> world_from_normal, const Hit& hit,
                        const Ray& ray, ReliefKind relief);

/// The frame of the surface there, with its tangent turned as the roughness is stretched. Its normal does not turn away
/// from the ray that arrives; it points outwards of a body, and of other surfaces to the side of the ray.
Frame surfaceFrameOf(const PathVertex& vertex);

/// The material's numbers, its indices relative to what is on the other side.
///
/// wavelength   of the light [µm]; 0: of all, by the index at 588 nm
formula::Material materialAgainstBeyond(const PathVertex& vertex, float wavelength);

/// The index of refraction of what is on the other side.
float iorBeyond(const PathVertex& vertex, float wavelength);

/// The ray that leaves the surface, in the media of its side.
///
/// direction   unit
Ray leavingRay(const PathVertex& vertex, glm::vec3 direction);

/// The bodies that a point lies in: those that at least two of three rays from there leave and have not entered.
///
/// cost     three rays through all that they meet
formula::Media mediaAt(const Scene& scene, const Geometry& geometry, glm::vec3 point, ReliefKind relief);

}  // namespace mirrorball
