#include "mirrorball/scene/gltf/gltf_parts.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "mirrorball/base/text.h"

namespace mirrorball::gltf {
namespace {

/// Each part that is bent is bent for each picture: MeshDeformation::work().
constexpr std::size_t kMostBending = std::size_t{1} << 28;

/// Whether a mesh does not stay as it is where it is placed.
bool isBent(const Placement& placement, const SceneMesh& mesh) {
  if (!mesh.deformation) return false;
  return placement.morphs || (placement.skin >= 0 && mesh.deformation->hasSkin());
}

class Parts {
 public:
  Parts(Scene& scene, VertexBudget& budget, Remarks& remarks) : scene_(scene), budget_(budget), remarks_(remarks) {}

  /// Notes that a part shows a mesh as it is.
  void keep(const SceneMesh& mesh) { taken_.insert(mesh.mesh); }

  Result<void> add(const Placement& placement, const SceneMesh& mesh) {
    MIRRORBALL_TRY_VOID(withName(mesh.key, budget_.memory().take(sizeof(RigPart) + sizeof(Instance))));
    RigPart part{.node = placement.node, .mesh = mesh.mesh};
    if (isBent(placement, mesh)) MIRRORBALL_TRY_VOID(bend(part, placement.skin, mesh));
    scene_.rig.parts.push_back(std::move(part));
    return {};
  }

 private:
  /// Gives a part its deformation, and a mesh of its own.
  Result<void> bend(RigPart& part, int skin, const SceneMesh& mesh) {
    if (mesh.deformation->work() > left_)
      return fail(ErrorCode::too_large, mesh.key + " brings the model above what can be bent for each picture");
    left_ -= mesh.deformation->work();
    part.deformation = mesh.deformation;
    if (skin >= 0 && mesh.deformation->hasSkin()) {
      const std::size_t joints = scene_.rig.skins[std::size_t(skin)].joints.size();
      if (mesh.deformation->joints <= joints)
        part.skin = skin;
      else
        remarks_.leaveOut({ErrorCode::bad_file, mesh.key + ".attributes.JOINTS_0 names the joint " +
                                                    std::to_string(mesh.deformation->joints - 1) +
                                                    ", but its skin has " + counted(joints, "joint")},
                          "skin");
    }
    if (taken_.insert(mesh.mesh).second) return {};
    Mesh copy = scene_.meshes[std::size_t(mesh.mesh)];
    MIRRORBALL_TRY_VOID(budget_.take(std::max(copy.vertices.size(), copy.indices.size()), mesh.key));
    part.mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(copy));
    return {};
  }

  Scene& scene_;
  VertexBudget& budget_;
  Remarks& remarks_;
  std::set<int> taken_;  // meshes of the scene that some part shows
  std::size_t left_ = kMostBending;
};

}  // namespace

Result<void> VertexBudget::take(std::size_t vertices, const std::string& key) {
  if (vertices > left_)
    return fail(ErrorCode::too_large, key + " brings the model above " + std::to_string(kMost) + " vertices");
  left_ -= vertices;
  return withName(key, memory_.take(vertices * (sizeof(Vertex) + sizeof(std::uint32_t))));
}

Result<void> addParts(Scene& scene, const std::vector<Placement>& placements,
                      const std::map<int, std::vector<SceneMesh>>& meshes, VertexBudget& budget, Remarks& remarks) {
  Parts parts(scene, budget, remarks);
  const auto primitivesOf = [&](const Placement& placement) {
    const auto found = meshes.find(placement.mesh);
    return found == meshes.end() ? std::span<const SceneMesh>() : std::span<const SceneMesh>(found->second);
  };
  for (const Placement& placement : placements)
    for (const SceneMesh& mesh : primitivesOf(placement))
      if (!isBent(placement, mesh)) parts.keep(mesh);
  for (const Placement& placement : placements)
    for (const SceneMesh& mesh : primitivesOf(placement)) MIRRORBALL_TRY_VOID(parts.add(placement, mesh));
  return {};
}

}  // namespace mirrorball::gltf
