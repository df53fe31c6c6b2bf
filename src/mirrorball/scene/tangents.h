#pragma once

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// Sets the tangents of all vertices from positions, normals and `uv[set]`, by MikkTSpace's rule, which glTF names
/// (2.0, section 3.7.2.1): the programs that make normal maps use the same frames.
///
/// - Vertices with the same position, normal and texture coordinates count as one.
/// - Around such a vertex those triangles share a frame that are connected by edges and whose pictures are turned the
///   same way; mirrored ones do not. A triangle whose texture coordinates have no area follows its neighbours.
/// - The tangent is the mean direction of growing u across the normal, weighted by the corners' angles across it.
/// - The bitangent's sign is 1 where the picture reads rightly from outside, v growing downwards.
///
/// Vertices whose triangles disagree are split: copies with the other tangents are appended, and indices name them.
/// Where the rule gives no direction it is the x axis brought into the surface, else any, with the sign −1; of a mesh
/// without texture coordinates 1. Tangents are unit vectors orthogonal to their normals.
///
/// cost     1 µs a triangle; 200 bytes of memory
/// from     Mikkelsen 2008, "Simulation of wrinkled surfaces revisited", and mikktspace.com; compared with Blender's
///          calc_tangents in tests/peer/tangents_test.cpp
void computeTangents(Mesh& mesh, int set = 0);

}  // namespace mirrorball
