#include "mirrorball/scene/model_origin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/animation/deformation.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/mesh_file/positions.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball {
namespace {

/// From how many radii away on a model is drawn about its own middle. A float of 24 bits is rounded by 1/300 of a pixel
/// there, if the model is a thousand pixels high.
constexpr double kRadiiAway = 100.0;

double boxRadius(const DoubleBox& box) { return box.isEmpty() ? 0.0 : 0.5 * glm::distance(box.low, box.high); }

double longestAxis(const glm::dmat4& matrix) {
  return std::max({glm::length(matrix[0]), glm::length(matrix[1]), glm::length(matrix[2])});
}

DoubleBox boxAround(const Mesh& mesh) {
  DoubleBox box;
  for (const Vertex& vertex : mesh.vertices) box.include(vertex.position);
  return box;
}

/// What 32-bit coordinates of a place are rounded to.
double stepOfFloats(glm::dvec3 place) {
  constexpr int kBits = 23;  // behind the first one
  const double size = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
  return size > 0.0 ? std::ldexp(1.0, std::ilogb(size) - kBits) : 0.0;
}

/// Which mesh of the rig's parts each of a scene's meshes is, or is the mirror image of.
std::vector<std::size_t> uprightMeshes(const Scene& scene) {
  std::vector<std::size_t> upright(scene.meshes.size());
  std::iota(upright.begin(), upright.end(), std::size_t{0});
  for (const auto& [mesh, image] : scene.rig.mirror_images)
    if (std::size_t(image.mesh) < upright.size()) upright[std::size_t(image.mesh)] = std::size_t(mesh);
  return upright;
}

/// The box around a mesh as its file has it: of what is bent, before it is.
DoubleBox boxInFile(const Scene& scene, std::size_t mesh, const RigPart* bent) {
  if (bent == nullptr) return boxAround(scene.meshes[mesh]);
  DoubleBox box;
  for (const MeshDeformation::Basis& vertex : bent->deformation->vertices) box.include(vertex.position);
  return box;
}

/// The part that bends each of a scene's meshes; nullptr: none does.
std::vector<const RigPart*> bendingParts(const Scene& scene) {
  std::vector<const RigPart*> parts(scene.meshes.size(), nullptr);
  for (const RigPart& part : scene.rig.parts)
    if (part.deformation) parts[std::size_t(part.mesh)] = &part;
  return parts;
}

/// What joints do to a mesh that hangs on them.
struct JointEffect {
  double scale = 0.0;  ///< how much longer they at most make it
  double step = 0.0;   ///< what their matrices are rounded to, in the world; 0: they are not far from it
};

/// Of each of a rig's skins, of each joint.
///
/// radius   of the box around the scene
std::vector<std::vector<JointEffect>> effectsOfJoints(const Rig& rig, double radius) {
  const std::vector<glm::dmat4> world_from_node = worldFromNodes(rig.world_from_roots, rig.nodes);
  std::vector<std::vector<JointEffect>> effects(rig.skins.size());
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Skin& skin = rig.skins[i];
    for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
      const glm::dmat4& world_from_joint = world_from_node[std::size_t(skin.joints[joint])];
      const glm::dmat4 joint_from_mesh(skin.joint_from_mesh[joint]);
      const double scale = longestAxis(world_from_joint);
      const glm::dvec3 moved(joint_from_mesh[3]);
      const bool is_far = scale * glm::length(moved) > kRadiiAway * radius;
      effects[i].push_back(
          {longestAxis(world_from_joint * joint_from_mesh), is_far ? scale * stepOfFloats(moved) : 0.0});
    }
  }
  return effects;
}

/// The greatest effect on each of a scene's meshes of the joints that it hangs on. A skin has others too, such as the
/// handles by which an animator moves those.
///
/// bending  of each mesh, the part that bends it
std::vector<JointEffect> effectsOnMeshes(const Scene& scene, const std::vector<const RigPart*>& bending,
                                         double radius) {
  const std::vector<std::vector<JointEffect>> of_joints = effectsOfJoints(scene.rig, radius);
  std::vector<JointEffect> effects(bending.size());
  for (std::size_t i = 0; i < bending.size(); ++i) {
    if (bending[i] == nullptr || bending[i]->skin < 0) continue;
    for (const MeshDeformation::Influence& influence : bending[i]->deformation->influences) {
      if (!(influence.weight > 0.0f)) continue;
      const JointEffect& one = of_joints[std::size_t(bending[i]->skin)][influence.joint];
      effects[i] = {std::max(effects[i].scale, one.scale), std::max(effects[i].step, one.step)};
    }
  }
  return effects;
}

/// How much longer at most the instances of a mesh that lies far from its nodes make it: of each of the rig's parts'
/// meshes; 0 for those that need not be moved.
///
/// bending  of each mesh, the part that bends it
/// effects  on each mesh, of its joints
/// radius   of the box around the scene
std::vector<double> scalesOfFarMeshes(const Scene& scene, const std::vector<const RigPart*>& bending,
                                      const std::vector<JointEffect>& effects, double radius) {
  const std::vector<std::size_t> upright = uprightMeshes(scene);
  std::vector<double> scales(scene.meshes.size(), 0.0);
  for (const Instance& instance : scene.instances) {
    const std::size_t mesh = upright[std::size_t(instance.mesh)];
    const RigPart* const bent = bending[mesh];
    const std::vector<Vertex>& vertices = scene.meshes[mesh]->vertices;
    if (vertices.empty()) continue;
    const bool hangs = bent != nullptr && bent->skin >= 0;
    const double scale = hangs ? effects[mesh].scale : longestAxis(glm::dmat4(instance.world_from_object));
    const glm::vec3 first = bent != nullptr ? bent->deformation->vertices.front().position : vertices.front().position;
    // Its other vertices are within two radii of the first. A small part of a model is at many of its own radii, and
    // yet its numbers are fine enough for the model.
    if (scale * glm::length(glm::dvec3(first)) > kRadiiAway * radius) scales[mesh] = std::max(scales[mesh], scale);
  }
  return scales;
}

/// Moves what some parts are before they are bent, all of them the same, to about another origin.
///
/// errors   too_large: others have it too, and a copy is more than fits
Result<void> moveDeformation(std::span<RigPart* const> parts, glm::dvec3 origin) {
  const std::shared_ptr<const MeshDeformation> before = parts.front()->deformation;
  const bool is_shared = before.use_count() > static_cast<long>(parts.size()) + 1;
  if (is_shared) MIRRORBALL_TRY_VOID(checkMemory(before->size()));
  // Only pointers to them are const, never deformations themselves.
  const std::shared_ptr<MeshDeformation> moved =
      is_shared ? std::make_shared<MeshDeformation>(*before) : std::const_pointer_cast<MeshDeformation>(before);
  for (MeshDeformation::Basis& vertex : moved->vertices)
    vertex.position = glm::vec3(glm::dvec3(vertex.position) - origin);
  for (RigPart* const part : parts) part->deformation = moved;
  return {};
}

/// Says that parts' meshes have their own origins elsewhere, and moves there what they are before they are bent.
///
/// origins  of each of the scene's meshes
/// errors   too_large
Result<void> setMeshOrigins(std::vector<RigPart>& parts, const std::vector<glm::dvec3>& origins) {
  // Those that share a deformation share the box around it, and with it their origin.
  std::map<const MeshDeformation*, std::vector<RigPart*>> bent;
  for (RigPart& part : parts) {
    const glm::dvec3 origin = origins[std::size_t(part.mesh)];
    if (origin == glm::dvec3(0.0)) continue;
    part.mesh_origin += origin;
    if (part.deformation) bent[part.deformation.get()].push_back(&part);
  }
  for (const auto& [deformation, sharing] : bent)
    MIRRORBALL_TRY_VOID(moveDeformation(sharing, origins[std::size_t(sharing.front()->mesh)]));
  return {};
}

/// Moves the vertices of meshes that lie far from their nodes, as models do whose vertices have the coordinates of a
/// map, to about their own origin, and that into their nodes. Mirror images follow when the scene is posed again.
///
/// radius    of the box around the scene
/// returns   whether there are any
/// errors    too_large
Result<bool> moveMeshes(Scene& scene, double radius) {
  const std::vector<const RigPart*> bending = bendingParts(scene);
  const std::vector<JointEffect> effects = effectsOnMeshes(scene, bending, radius);
  const std::vector<double> scales = scalesOfFarMeshes(scene, bending, effects, radius);
  std::vector<glm::dvec3> origins(scene.meshes.size(), glm::dvec3(0.0));
  bool moves_any = false;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    scene.vertex_step = std::max(scene.vertex_step, effects[i].step);
    if (scales[i] == 0.0) continue;
    const DoubleBox box = boxInFile(scene, i, bending[i]);
    origins[i] = originFor(box);
    if (origins[i] == glm::dvec3(0.0)) continue;
    moves_any = true;
    scene.vertex_step = std::max(scene.vertex_step, scales[i] * stepOfFloats(box.center()));
    if (bending[i] != nullptr) continue;
    for (Vertex& vertex : scene.meshes[i].edit().vertices)
      vertex.position = glm::vec3(glm::dvec3(vertex.position) - origins[i]);
  }
  MIRRORBALL_TRY_VOID(setMeshOrigins(scene.rig.parts, origins));
  return moves_any;
}

}  // namespace

glm::dvec3 originFor(const DoubleBox& box) {
  const double radius = boxRadius(box);
  if (box.isEmpty() || !(glm::length(box.center()) > kRadiiAway * radius)) return glm::dvec3(0.0);
  if (radius == 0.0) return box.center();
  const double steps = std::pow(10.0, std::floor(std::log10(radius)));
  const double per_unit = std::pow(10.0, -std::floor(std::log10(radius)));
  // A quotient by a whole number is the double that is nearest to a short decimal fraction.
  return radius >= 1.0 ? glm::round(box.center() / steps) * steps : glm::round(box.center() * per_unit) / per_unit;
}

glm::dvec3 originFor(std::span<const glm::dvec3> vertices) {
  DoubleBox box;
  for (const glm::dvec3& vertex : vertices)
    if (std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z)) box.include(vertex);
  return originFor(box);
}

void setOrigin(Scene& scene, glm::dvec3 origin, bool are_floats) {
  scene.origin = origin;
  if (are_floats) scene.vertex_step = stepOfFloats(origin);
}

Result<void> moveOrigin(Scene& scene, glm::dvec3 origin) {
  const glm::dvec3 by = scene.origin - origin;
  if (by == glm::dvec3(0.0)) return {};
  scene.origin = origin;
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), by);
  if (!scene.rig.nodes.empty()) {
    scene.rig.world_from_roots = moved * scene.rig.world_from_roots;
    return poseAtRest(scene);
  }
  const auto move = [&](glm::mat4& place) { place = glm::mat4(moved * glm::dmat4(place)); };
  for (Instance& instance : scene.instances) move(instance.world_from_object);
  for (ModelCamera& camera : scene.cameras) move(camera.world_from_view);
  for (ModelLight& light : scene.lights) light.position = glm::vec3(glm::dvec3(light.position) + by);
  return {};
}

Result<void> drawAboutMiddle(Scene& scene) {
  // Floats at the model's distance tell its middle no better than they tell its details; about that middle, they do.
  constexpr int kPasses = 3;
  DoubleBox box = boxOfPositions(scene);
  for (int pass = 0; pass < kPasses; ++pass) {
    const glm::dvec3 middle = originFor(box);
    if (middle == glm::dvec3(0.0)) break;
    MIRRORBALL_TRY_VOID(moveOrigin(scene, scene.origin + middle));
    box = boxOfPositions(scene);
  }
  if (scene.rig.nodes.empty()) return {};
  MIRRORBALL_TRY(moves_any, moveMeshes(scene, boxRadius(box)));
  return moves_any ? poseAtRest(scene) : Result<void>();
}

std::optional<std::string> remarkOnOrigin(const Scene& scene) {
  const double radius = boundingSphere(scene).radius;
  const double away = glm::length(scene.origin);
  const bool is_coarse = scene.vertex_step > 0.0;
  if (away == 0.0 && !is_coarse) return {};
  const std::string rounding = "its 32-bit vertices are rounded to " + formatNumber(scene.vertex_step) + ", 1/" +
                               formatNumber(std::round(radius / std::max(scene.vertex_step, 1e-300))) +
                               " of its radius";
  if (away == 0.0) return "lies far from the origin of its nodes; " + rounding;
  return "lies " + formatNumber(std::round(away / radius)) + " radii from the origin of its coordinates: drawn about " +
         writtenPlace(scene.origin) + (is_coarse ? "; " + rounding : "");
}

}  // namespace mirrorball
