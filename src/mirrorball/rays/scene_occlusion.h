#pragma once

#include <cstddef>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

struct SceneOcclusionSettings {
  /// From each vertex, at most 4096; 0: some million in all, from 16 to 1024 for each vertex, or where there are more
  /// than 62 500 for each patch of neighbouring ones (VertexPatches), more where its triangles are large.
  int rays = 0;
  bool finds_materials = false;  ///< Instance::vertex_materials too
  /// Meshes are cut first where their triangles are too large to tell (occlusionRefinements). Only findOcclusionOnce
  /// does so.
  bool refines = false;

  bool operator==(const SceneOcclusionSettings&) const = default;
};

/// The rays from so many different vertices of a few objects, in all.
std::size_t occlusionRays(std::size_t vertices, const SceneOcclusionSettings& settings);

/// Finds what each vertex of a scene sees of the environment and what of the scene (Instance::occlusion), by rays from
/// the triangles around it. Surfaces hide by their opacity, and less by what they transmit; light that they reflect is
/// followed to its end as if they were matt, by their colour: under a white sky all of a white scene is white.
///
/// The directions of a patch are a sequence that covers the hemisphere by its cosine. What is found is smoothed over
/// the edges of triangles, or between patches of several vertices. The same for any number of threads.
///
/// errors   interrupted, too_large; then the scene is as before
/// cost     a ray takes 0.5 µs on one core; 8 bytes a ray for as long as it takes. Where something shines, half as many
///          rays more, from 4 to 32 a vertex
/// from     Landis 2002, "Production-ready global illumination", for bent normals; Goral et al. 1984, "Modeling the
///          interaction of light between diffuse surfaces", for reflections
Result<void> findOcclusion(Scene& scene, const Geometry& geometry, const SceneOcclusionSettings& settings = {},
                           const ProgressFunction& progress = {});

}  // namespace mirrorball
