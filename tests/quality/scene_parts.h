#pragma once

#include <string>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball::quality {

/// A rectangle of divisions² pairs of triangles, facing across × up; (0, 0) of its texture is its upper left corner.
///
/// across, up   from its middle to its sides
Mesh rectangle(glm::vec3 middle, glm::vec3 across, glm::vec3 up, int divisions = 1);

/// A box whose six faces have the whole texture each.
///
/// half   from its middle to its faces
Mesh box(glm::vec3 middle, glm::vec3 half);

/// Adds a mesh that lies where it is, with a material of its own.
void add(Scene& scene, Mesh mesh, const Material& material);

/// A material that no light leaves but as its colour says.
Material matt(glm::vec3 base_color, float perceptual_roughness = 0.7f);

/// Lines of the word "MIRRORBALL", dark on light, many to a label.
Texture smallText();

/// A leaf with a serrated edge; transparent around it.
Texture leaf();

}  // namespace mirrorball::quality
