#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/deformation.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::gltf {

/// A mesh of the file on a node.
struct Placement {
  int mesh = 0;         ///< of the file
  int node = 0;         ///< of the rig
  int skin = -1;        ///< of the rig; −1: none
  bool morphs = false;  ///< has weights, or will have
};

/// A primitive as a mesh of the scene.
struct SceneMesh {
  int mesh = 0;
  std::shared_ptr<const MeshDeformation> deformation = {};  ///< none: nothing bends it
  std::string key = {};                                     ///< for messages
};

/// What vertices a model may have: a small file that names the same accessor again and again must not fill the memory.
class VertexBudget {
 public:
  explicit VertexBudget(MemoryBudget& memory) : memory_(memory) {}

  /// Takes memory for so many vertices or corners of a mesh, whichever are more.
  ///
  /// errors   too_large
  Result<void> take(std::size_t vertices, const std::string& key);
  MemoryBudget& memory() { return memory_; }

 private:
  MemoryBudget& memory_;
  std::size_t left_ = kMost;

  static constexpr std::size_t kMost = std::size_t{1} << 26;  // of 72 bytes each
};

/// Gives the rig of a scene what its nodes show. Parts that are bent have meshes of their own, of which the first takes
/// the one that was read, unless another part shows it as it is.
///
/// meshes   of each mesh of the file its primitives
/// remarks  gets meshes that hang on joints which their skins have not; those skins are left out
/// errors   too_large
Result<void> addParts(Scene& scene, const std::vector<Placement>& placements,
                      const std::map<int, std::vector<SceneMesh>>& meshes, VertexBudget& budget, Remarks& remarks);

}  // namespace mirrorball::gltf
