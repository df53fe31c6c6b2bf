#pragma once

#include <vector>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/mesh_refinement.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where a scene's meshes are to be cut so that what their vertices know of what hides the sky (findOcclusion) is,
/// interpolated, what places between them see: a floor of two triangles knows nothing of a ball that stands in its
/// middle. Large triangles are asked by rays from a few places; they are cut where one differs from what lies between
/// the corners by more than a twelfth of an even sky's light, or sees something nearer than the triangle is long: 0.14
/// times its distance over the root of the share that it hides. They are cut down to a twenty-fourth of the radius of
/// the middle one of the objects, by their size. Edges that several meshes have in common are cut in all of them. Glass
/// is cut at such edges only, and meshes with a relief nowhere.
///
/// returns  one for each mesh
/// errors   interrupted
/// cost     20 µs for each place that is asked, on one core; at most 150 000 of them, and 200 000 new vertices;
///          512 rays for each instance that has two sides, and a copy of all meshes for as long as it takes
Result<std::vector<MeshRefinement>> occlusionRefinements(const Scene& scene, const Geometry& geometry,
                                                         const ProgressFunction& progress = {});

}  // namespace mirrorball
