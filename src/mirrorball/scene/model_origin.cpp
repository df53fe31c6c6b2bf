#include "mirrorball/scene/model_origin.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

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

/// How much longer the joints of a skin at most make what hangs on them.
double scaleOfSkin(const Skin& skin, std::span<const glm::dmat4> world_from_node) {
  double scale = 0.0;
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    scale = std::max(scale,
                     longestAxis(world_from_node[std::size_t(skin.joints[i])] * glm::dmat4(skin.joint_from_mesh[i])));
  return scale;
}

/// How much longer at most the instances of a mesh that lies far from its nodes make it: of each of the rig's parts'
/// meshes; 0 for those that need not be moved.
///
/// radius   of the box around the scene
std::vector<double> scalesOfFarMeshes(const Scene& scene, double radius) {
  const std::vector<glm::dmat4> world_from_node = worldFromNodes(scene.rig.world_from_roots, scene.rig.nodes);
  const std::vector<const RigPart*> bending = bendingParts(scene);
  const std::vector<std::size_t> upright = uprightMeshes(scene);
  std::vector<double> scales(scene.meshes.size(), 0.0);
  for (const Instance& instance : scene.instances) {
    const std::size_t mesh = upright[std::size_t(instance.mesh)];
    const RigPart* const bent = bending[mesh];
    const std::vector<Vertex>& vertices = scene.meshes[mesh]->vertices;
    if (vertices.empty()) continue;
    const bool hangs = bent != nullptr && bent->skin >= 0;
    const double scale = hangs ? scaleOfSkin(scene.rig.skins[std::size_t(bent->skin)], world_from_node)
                               : longestAxis(glm::dmat4(instance.world_from_object));
    const glm::vec3 first = bent != nullptr ? bent->deformation->vertices.front().position : vertices.front().position;
    // Its other vertices are within two radii of the first. A small part of a model is at many of its own radii, and
    // yet its numbers are fine enough for the model.
    if (scale * glm::length(glm::dvec3(first)) > kRadiiAway * radius) scales[mesh] = std::max(scales[mesh], scale);
  }
  return scales;
}

/// What the matrices of joints that are far from their meshes are rounded to, in the world; 0 where none is far.
///
/// radius   of the box around the scene
double stepOfJoints(const Scene& scene, double radius) {
  const std::vector<glm::dmat4> world_from_node = worldFromNodes(scene.rig.world_from_roots, scene.rig.nodes);
  double step = 0.0;
  for (const RigPart& part : scene.rig.parts) {
    if (!part.deformation || part.skin < 0) continue;
    const Skin& skin = scene.rig.skins[std::size_t(part.skin)];
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const double scale = longestAxis(world_from_node[std::size_t(skin.joints[i])]);
      const glm::dvec3 moved(skin.joint_from_mesh[i][3]);
      if (scale * glm::length(moved) > kRadiiAway * radius) step = std::max(step, scale * stepOfFloats(moved));
    }
  }
  return step;
}

/// Says that a part's mesh has its own origin elsewhere, and moves there what it is before it is bent.
void setMeshOrigin(RigPart& part, glm::dvec3 origin) {
  if (origin == glm::dvec3(0.0)) return;
  part.mesh_origin += origin;
  if (!part.deformation) return;
  auto deformation = std::make_shared<MeshDeformation>(*part.deformation);
  for (MeshDeformation::Basis& vertex : deformation->vertices)
    vertex.position = glm::vec3(glm::dvec3(vertex.position) - origin);
  part.deformation = std::move(deformation);
}

/// Moves the vertices of meshes that lie far from their nodes, as models do whose vertices have the coordinates of a
/// map, to about their own origin, and that into their nodes. Mirror images follow when the scene is posed again.
///
/// radius    of the box around the scene
/// returns   whether there are any
bool moveMeshes(Scene& scene, double radius) {
  const std::vector<double> scales = scalesOfFarMeshes(scene, radius);
  const std::vector<const RigPart*> bending = bendingParts(scene);
  std::vector<glm::dvec3> origins(scene.meshes.size(), glm::dvec3(0.0));
  bool moves_any = false;
  for (std::size_t i = 0; i < origins.size(); ++i) {
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
  scene.vertex_step = std::max(scene.vertex_step, stepOfJoints(scene, radius));
  for (RigPart& part : scene.rig.parts) setMeshOrigin(part, origins[std::size_t(part.mesh)]);
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
  if (scene.rig.nodes.empty() || !moveMeshes(scene, boxRadius(box))) return {};
  return poseAtRest(scene);
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
