#pragma once

#include <filesystem>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::quality {

/// Normals of the sections of bodies that revolvedMesh makes.
namespace profile {
inline constexpr glm::dvec2 kUp(0, 1), kOut(1, 0), kDown(0, -1);
}

/// A rectangle of divisions² pairs of triangles, facing across × up; (0, 0) of its texture is its upper left corner.
///
/// across, up   from its middle to its sides
Mesh rectangle(glm::vec3 middle, glm::vec3 across, glm::vec3 up, int divisions = 1);

/// A box whose six faces have the whole texture each.
///
/// half   from its middle to its faces
Mesh box(glm::vec3 middle, glm::vec3 half);

/// A level square, facing +Y, of divisions² pairs of triangles.
///
/// half   from its middle to its sides
Mesh ground(float half, int divisions = 1);

/// A ball of `rings` rings of latitude, and twice as many segments of longitude.
Mesh ball(glm::vec3 middle, float radius, int rings = 24);

/// Adds a mesh that lies where it is, with a material of its own.
void add(Scene& scene, Mesh mesh, const Material& material);

/// A material that no light leaves but as its colour says.
Material matt(glm::vec3 base_color, float perceptual_roughness = 0.7f);

/// A metal of that reflectance.
Material roughMetal(glm::vec3 reflectance, float perceptual_roughness);

/// Lines of the word "MIRRORBALL", dark on light, many to a label.
Texture smallText();

/// A leaf with a serrated edge; transparent around it.
Texture leaf();

/// Writes a scene into a folder as NAME.glb.
///
/// returns  the file
/// errors   io
Result<std::filesystem::path> writeGlb(const Scene& scene, const std::string& name,
                                       const std::filesystem::path& folder);

}  // namespace mirrorball::quality
