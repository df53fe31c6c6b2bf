#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The bodies of a scene that light passes through, for rays that are traced in shaders.
struct BodyTree {
  std::vector<glm::uvec4> words;  ///< texels, as formula/bodies/triangle_tree.glsl reads them
  /// Of each instance, the child that holds its triangles and no others, where no ray from their outside meets them; 0:
  /// there is none.
  std::vector<int> unseen_by_itself;
};

/// As formulas read it.
inline glm::uvec4 fetchWords(const BodyTree& tree, int texel) { return tree.words[static_cast<std::size_t>(texel)]; }

/// Sorts the triangles of all bodies (isBody), where their instances put them, into a tree. A body's number is that of
/// its instance. Triangles that are not finite or have no area are left out.
///
/// returns  nothing if the scene has no such triangle
/// errors   too_large
/// cost     O(n log n) time; 260 bytes a triangle while it is built, about 90 kept; the same for any number of threads
Result<std::optional<BodyTree>> bodyTree(const Scene& scene);

/// The same of the triangles of all instances, whatever they are made of.
Result<std::optional<BodyTree>> triangleTree(const Scene& scene);

/// The same of the instances that are not seen through and whose vertices are known (Instance::occlusion,
/// vertex_materials), with those and with their holes: as formula/bodies/scene_surface.glsl reads them too. Balls
/// (isBall) are kept apart.
///
/// cost     as bodyTree's; 16 bytes a triangle and 32 a vertex more are kept, and for a triangle with holes up to 144
Result<std::optional<BodyTree>> sceneTree(const Scene& scene);

}  // namespace mirrorball
