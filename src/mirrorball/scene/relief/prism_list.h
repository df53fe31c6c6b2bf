#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Which sides of each triangle are also a side of another one: with the same normals, so that the prisms below them
/// (formula/relief/relief_prism.glsl) touch. A side that ends a mesh, or a sharp edge, is not.
///
/// returns  for each triangle 1 or 0 for the sides from corner 0 to 2, from 0 to 1 and from 1 to 2: ReliefPrism::joined
/// cost     0.3 µs a triangle
std::vector<glm::vec3> joinedSides(const Mesh& mesh);

/// The triangles of a mesh whose material has a height texture, for shaders that look for relief below them
/// (shaders/surface/prism.glsl).
///
/// mesh     index into Scene::meshes
/// returns  16 texels a triangle: for each corner position and u, normal and v, the second texture coordinates,
///          tangent, colour; then joinedSides and heightsBelow, which two halves of a word hold as shares of 65535
/// cost     256 bytes a triangle
std::vector<glm::uvec4> prismList(const Scene& scene, int mesh);

}  // namespace mirrorball
