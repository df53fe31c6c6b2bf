#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/rays/vertex_places.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What a triangle is made of in its middle.
///
/// world_from_normal   normalMatrices
formula::Material materialInMiddle(const Scene& scene, std::span<const glm::mat3> world_from_normal,
                                   std::size_t instance, std::size_t triangle);

/// Of each vertex on the side of its normal the mean of the triangles around it.
///
/// world_from_normal   normalMatrices
std::vector<VertexMaterial> materialsOfVertices(const Scene& scene, const VertexPlaces& places,
                                                std::span<const glm::mat3> world_from_normal);

}  // namespace mirrorball
