#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "mirrorball/base/shared.h"
#include "mirrorball/scene/animation/animation.h"
#include "mirrorball/scene/mesh.h"

namespace mirrorball {

struct MeshDeformation;

/// Where a node lies in its parent: scaled, turned, moved, and then brought there by a matrix. Files have the former
/// three or the latter.
struct NodePlace {
  glm::dmat4 matrix{1.0};
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< unit
  glm::dvec3 scale{1.0};
};

glm::dmat4 parentFromNode(const NodePlace& place);

/// Whether a matrix has no number beyond those with which a renderer goes on, nor NaN.
bool isWithinFloats(const glm::dmat4& matrix);

/// The place and the axes of a node without its scale: a rotation, though the node may mirror.
///
/// returns  nothing where it has no axes, as scaled to nothing
std::optional<glm::mat4> rigidPart(const glm::dmat4& world_from_node);

/// A node of a model's tree.
struct RigNode {
  std::string name = {};  ///< as the file has it: several may have the same, or none
  int parent = -1;        ///< index of a node before it; −1: none
  NodePlace place = {};
  std::vector<float> weights = {};  ///< of the morph targets of its mesh
};

/// Where nodes are in the world, of which each follows its parent. Numbers that are too large become infinite or NaN.
std::vector<glm::dmat4> worldFromNodes(const glm::dmat4& world_from_roots, std::span<const RigNode> nodes);

/// Joints that carry a mesh.
struct Skin {
  std::vector<int> joints;                 ///< indices into Rig::nodes
  std::vector<glm::mat4> joint_from_mesh;  ///< of each, where the mesh is made for
};

/// A mesh that a node shows.
struct RigPart {
  int node = 0;
  int mesh = 0;   ///< index into Scene::meshes; of no other part if it is deformed
  int skin = -1;  ///< index into Rig::skins; −1: it moves with the node
  std::shared_ptr<const MeshDeformation> deformation = {};  ///< none: it stays as it is
  glm::dvec3 mesh_origin{0.0};  ///< where the mesh's own (0, 0, 0) is in the node; what joint_from_mesh takes it to be
  bool is_mirrored = false;     ///< a deformed mesh's triangles are turned round now
};

/// A mesh's mirror image among the scene's meshes.
struct MirrorImage {
  Shared<Mesh> of;  ///< as it was when the image was made
  int mesh;
};

/// A model's nodes as a tree, what they show, and what moves them. pose.h puts them elsewhere, and makes scenes of the
/// moments of its animations.
struct Rig {
  glm::dmat4 world_from_roots{1.0};
  std::vector<RigNode> nodes = {};
  std::vector<Skin> skins = {};
  std::vector<RigPart> parts = {};     ///< Scene::instances come from them, in this order
  std::vector<int> camera_nodes = {};  ///< of each of Scene::cameras
  std::vector<int> light_nodes = {};   ///< of each of Scene::lights
  std::map<int, MirrorImage> mirror_images =
      {};  ///< of meshes that are not deformed, where the scene has them: by their index
  std::vector<Animation> animations = {};
};

}  // namespace mirrorball
