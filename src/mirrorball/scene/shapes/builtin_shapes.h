#pragma once

#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

// The built-in shapes. Each has its bounding sphere (scene.h) about the origin with radius 1, outward normals,
// counter-clockwise triangles, tangents along growing u, and texture coordinates in which a picture reads normally
// from outside.

/// The unit sphere as rings of latitude and segments of longitude. +Z lies in the middle of its texture,
/// +X right of it.
///
/// rings     from pole to pole, at least 2
/// segments  around the axis, at least 3
/// returns   analytic normals: equal to the positions
Mesh sphereMesh(int rings = 128, int segments = 256);

/// A torus about the Y axis: main radius 0.7, tube radius 0.3.
///
/// segments  around the axis, at least 3
/// sides     around the tube, at least 3
Mesh torusMesh(int segments = 192, int sides = 96);

/// A tube along the (2, 3) torus knot (the trefoil), whose axis is Z.
///
/// segments  along the knot, at least 12
/// sides     around the tube, at least 3
Mesh knotMesh(int segments = 480, int sides = 48);

/// A square in the XZ plane that faces +Y, of side √2 so that its corners lie at distance 1. It has no thickness: give
/// it a double-sided material to be seen from below.
Mesh planeMesh();

/// A cube of side 2/√3, so that its corners lie at distance 1, with flat faces.
/// On each face the texture stands upright.
Mesh cubeMesh();

/// Moves and scales a mesh so that its bounding sphere is the unit sphere. Directions stay.
void fitToUnitSphere(Mesh& mesh);
/// The same of a scene, by its instances' transforms.
void fitToUnitSphere(Scene& scene);

/// The triangles of a grid of (rows + 1) × (columns + 1) vertices stored row by row from vertex `first`, rows downwards
/// and columns to the right as seen from outside. A triangle whose corners coincide in space (at a pole) is left out.
void addGridTriangles(Mesh& mesh, std::uint32_t first, int rows, int columns);

}  // namespace mirrorball
