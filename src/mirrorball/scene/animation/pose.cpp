#include "mirrorball/scene/animation/pose.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/tangent.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/animation/deformation.h"
#include "mirrorball/scene/animation/target_values.h"

namespace mirrorball {
namespace {

/// Turns triangles round, but for their last corners, which ReflectAt::triangle shows.
void turnTriangles(Mesh& mesh) {
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3)
    std::swap(mesh.indices[first], mesh.indices[first + 1]);
}

void turnBitangents(Mesh& mesh) {
  for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
}

/// A rotation whose −Z is a direction, as lamps shine; of none, any.
glm::mat4 facing(glm::vec3 direction) {
  const float length = glm::length(direction);
  const glm::vec3 back = length > 0.0f ? -direction / length : glm::vec3(0.0f, 0.0f, 1.0f);
  const glm::vec3 right = formula::anyTangent(back);
  return glm::mat4(glm::vec4(right, 0.0f), glm::vec4(glm::cross(back, right), 0.0f), glm::vec4(back, 0.0f),
                   glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

double volumeOf(const glm::dmat4& matrix) { return glm::determinant(glm::dmat3(matrix)); }

/// Whether its bent meshes are those that it was loaded with.
bool fitsRig(const Scene& scene) {
  for (const RigPart& part : scene.rig.parts) {
    if (std::size_t(part.mesh) >= scene.meshes.size()) return false;
    const std::size_t vertices = scene.meshes[std::size_t(part.mesh)]->vertices.size();
    if (part.deformation && vertices != part.deformation->vertices.size()) return false;
  }
  return true;
}

/// errors   bad_shape: the rig is of another scene
Result<void> checkRig(const Scene& scene) {
  if (fitsRig(scene)) return {};
  return fail(ErrorCode::bad_shape, "its meshes are not those that its nodes show");
}

/// Shows a scene's parts where its rig has them at some time.
class Poser {
 public:
  explicit Poser(Scene& scene) : scene_(scene), rig_(scene.rig), nodes_(rig_.nodes) {}

  /// Moves the nodes, and with them cameras and lights, to a time of an animation.
  Result<void> moveTo(const Animation& animation, double seconds) {
    moved_ = rig_.nodes;
    nodes_ = moved_;
    TargetValues values(scene_, moved_);
    std::vector<double> value;
    for (const AnimationChannel& channel : animation.channels) {
      const auto* const node = std::get_if<NodeTarget>(&channel.target);
      sample(channel.sampler, seconds, node != nullptr && node->of == NodeTarget::Of::rotation, value);
      values.set(channel.target, value);
    }
    values.finish();
    return place();
  }

  /// Finds where the nodes are, and puts cameras and lights there.
  Result<void> place() {
    worlds_ = worldFromNodes(rig_.world_from_roots, nodes_);
    if (!std::all_of(worlds_.begin(), worlds_.end(), isWithinFloats)) return tooLarge();
    skins_.assign(rig_.skins.size(), {});
    for (std::size_t i = 0; i < skins_.size(); ++i) {
      const Skin& skin = rig_.skins[i];
      for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
        const glm::dmat4 moved = worldOf(skin.joints[joint]) * glm::dmat4(skin.joint_from_mesh[joint]);
        if (!isWithinFloats(moved)) return tooLarge();
        skins_[i].world_from_mesh.push_back(moved);
        skins_[i].rounded.emplace_back(moved);
      }
    }
    for (std::size_t i = 0; i < std::min(rig_.camera_nodes.size(), scene_.cameras.size()); ++i)
      if (const auto rigid = rigidPart(worldOf(rig_.camera_nodes[i]))) scene_.cameras[i].world_from_view = *rigid;
    for (std::size_t i = 0; i < std::min(rig_.light_nodes.size(), scene_.lights.size()); ++i) {
      const auto rigid = rigidPart(worldOf(rig_.light_nodes[i]));
      if (!rigid) continue;
      scene_.lights[i].position = glm::vec3((*rigid)[3]);
      scene_.lights[i].direction = -glm::vec3((*rigid)[2]);
    }
    return {};
  }

  /// Adds an instance for each part that is seen.
  ///
  /// keeps_bent   deformed meshes of earlier instances stay as they are, and new ones are made
  void addInstances(bool keeps_bent) {
    for (RigPart& part : rig_.parts) {
      const double volume = volumeOf(worldOf(part.node));
      // What is scaled to nothing is a file's way to hide it. Only joints move what has a skin.
      if (part.skin < 0 && volume == 0.0) continue;
      if (part.deformation && keeps_bent) part.mesh = addMesh(scene_.meshes[std::size_t(part.mesh)]);
      if (part.deformation) bend(part, volume < 0.0);
      const int mesh = !part.deformation && volume < 0.0 ? mirrorImageOf(part.mesh) : part.mesh;
      scene_.instances.push_back({.mesh = mesh,
                                  .world_from_object = part.skin < 0 ? worldFromMesh(part) : glm::mat4(1.0f),
                                  .node = part.node});
    }
  }

  /// Leaves the nodes where moveTo() has brought them.
  void keepNodes() {
    rig_.nodes = std::move(moved_);
    nodes_ = rig_.nodes;
  }

 private:
  /// A skin's joints.
  struct Joints {
    std::vector<glm::dmat4> world_from_mesh;
    std::vector<glm::mat4> rounded;  // the same
  };

  static tl::unexpected<Error> tooLarge() {
    return fail(ErrorCode::bad_file, "one of its nodes has a transform that is too large");
  }

  const glm::dmat4& worldOf(int node) const { return worlds_[std::size_t(node)]; }

  glm::mat4 worldFromMesh(const RigPart& part) const {
    return glm::mat4(glm::translate(worldOf(part.node), part.mesh_origin));
  }

  /// How the joints move what hangs on them of a bent part's mesh; empty: it has no skin.
  std::span<const glm::mat4> placedJoints(const RigPart& part) {
    if (part.skin < 0) return {};
    const Joints& skin = skins_[std::size_t(part.skin)];
    if (part.mesh_origin == glm::dvec3(0.0)) return skin.rounded;
    const std::size_t count = skin.world_from_mesh.size();
    own_joints_.resize(std::max(own_joints_.size(), count));
    const auto place = [&](std::size_t joint) {
      own_joints_[joint] = glm::mat4(glm::translate(skin.world_from_mesh[joint], part.mesh_origin));
    };
    // Many small parts may have one large skin: the time is not their number by that of its joints.
    if (part.deformation->influences.size() < count)
      for (const MeshDeformation::Influence& influence : part.deformation->influences) place(influence.joint);
    else
      for (std::size_t joint = 0; joint < count; ++joint) place(joint);
    return own_joints_;
  }

  void bend(RigPart& part, bool node_mirrors) {
    Mesh& mesh = scene_.meshes[std::size_t(part.mesh)].edit();
    const std::span<const float> weights = nodes_[std::size_t(part.node)].weights;
    const bool joints_mirror = deform(*part.deformation, weights, placedJoints(part), mesh);
    const bool mirrors = part.skin >= 0 ? joints_mirror : node_mirrors;
    if (mirrors) turnBitangents(mesh);
    if (mirrors != part.is_mirrored) turnTriangles(mesh);
    part.is_mirrored = mirrors;
  }

  int mirrorImageOf(int mesh) {
    const Shared<Mesh>& upright = scene_.meshes[std::size_t(mesh)];
    const auto known = rig_.mirror_images.find(mesh);
    const bool has_one = known != rig_.mirror_images.end() && std::size_t(known->second.mesh) < scene_.meshes.size();
    if (has_one && known->second.of.isSameAs(upright)) return known->second.mesh;
    Mesh image = *upright;
    turnTriangles(image);
    turnBitangents(image);
    MirrorImage made{upright, has_one ? known->second.mesh : -1};
    // The image of what the mesh was before is of no use any more.
    if (has_one)
      scene_.meshes[std::size_t(made.mesh)] = std::move(image);
    else
      made.mesh = addMesh(std::move(image));
    return rig_.mirror_images.insert_or_assign(mesh, made).first->second.mesh;
  }

  int addMesh(Mesh mesh) {
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }

  Scene& scene_;
  Rig& rig_;
  std::vector<RigNode> moved_;         // by an animation; none: the nodes are at rest
  std::span<const RigNode> nodes_;     // as they are at the time
  std::vector<glm::dmat4> worlds_;     // of each node
  std::vector<Joints> skins_;          // of each
  std::vector<glm::mat4> own_joints_;  // of a part with a mesh_origin; of joints that it does not hang on, anything
};

}  // namespace

Result<Scene> posed(Scene scene, std::size_t animation, double seconds) {
  MIRRORBALL_TRY_VOID(checkRig(scene));
  scene.instances.clear();
  Poser poser(scene);
  MIRRORBALL_TRY_VOID(poser.moveTo(scene.rig.animations[animation], seconds));
  poser.addInstances(false);
  poser.keepNodes();
  scene.rig.animations.clear();
  return scene;
}

Result<Scene> posesTogether(Scene scene, std::size_t animation, std::span<const double> seconds) {
  MIRRORBALL_TRY_VOID(checkRig(scene));
  scene.instances.clear();
  Poser poser(scene);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    MIRRORBALL_TRY_VOID(poser.moveTo(scene.rig.animations[animation], seconds[i]));
    poser.addInstances(i > 0);
  }
  scene.rig = {};
  for (Instance& instance : scene.instances) instance.node = -1;
  return scene;
}

Result<void> poseAtRest(Scene& scene) {
  scene.instances.clear();
  Poser poser(scene);
  MIRRORBALL_TRY_VOID(poser.place());
  poser.addInstances(false);
  return {};
}

Result<void> placeNode(Scene& scene, std::size_t node, const NodePlace& place) {
  if (node >= scene.rig.nodes.size())
    return fail(ErrorCode::usage,
                "node " + std::to_string(node) + " of a scene of " + counted(scene.rig.nodes.size(), "node"));
  MIRRORBALL_TRY_VOID(checkRig(scene));
  Scene placed = scene;
  placed.rig.nodes[node].place = place;
  MIRRORBALL_TRY_VOID(poseAtRest(placed));
  scene = std::move(placed);
  return {};
}

void addNodes(Scene& scene) {
  Rig& rig = scene.rig;
  if (!rig.nodes.empty()) return;
  rig.world_from_roots = glm::dmat4(1.0);
  const auto add = [&rig](const std::string& name, const glm::mat4& world_from_node) {
    rig.nodes.push_back({.name = name, .place = {.matrix = glm::dmat4(world_from_node)}});
    return static_cast<int>(rig.nodes.size()) - 1;
  };
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    Instance& instance = scene.instances[i];
    instance.node = add(materialOf(scene, i).name, instance.world_from_object);
    rig.parts.push_back({.node = instance.node, .mesh = instance.mesh});
  }
  for (const ModelCamera& camera : scene.cameras) rig.camera_nodes.push_back(add(camera.name, camera.world_from_view));
  for (const ModelLight& light : scene.lights) {
    glm::mat4 world_from_light = facing(light.direction);
    world_from_light[3] = glm::vec4(light.position, 1.0f);
    rig.light_nodes.push_back(add(light.name, world_from_light));
  }
}

}  // namespace mirrorball
