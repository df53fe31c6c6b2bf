// Two meshes as their readers may hand them on, a dense and a light one, through all that `transfer` does.

#include <glm/glm.hpp>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/scene/tangents.h"
#include "mirrorball/transfer/detail_transfer.h"
#include "mirrorball/transfer/normal_space.h"
#include "mirrorball/transfer/simplify.h"
#include "mirrorball/transfer/unwrap/unwrap.h"

namespace mirrorball::fuzz {
namespace {

glm::vec3 madeVector(MadeInput& input) {
  const float x = input.finite();
  const float y = input.finite();
  return {x, y, input.finite()};
}

/// Readers refuse what is not finite, make normals unit, and find the tangents that a file does not have.
Mesh madeMesh(MadeInput& input) {
  constexpr int kMostVertices = 15, kMostTriangles = 20;
  Mesh mesh;
  const float unit = input.powerOfTwo();
  const bool has_normals = input.upTo(1) == 1;
  const int triangles = input.upTo(kMostTriangles);
  mesh.vertices.resize(std::size_t(1 + input.upTo(kMostVertices)));
  for (Vertex& vertex : mesh.vertices) {
    vertex.position = madeVector(input) * unit;
    if (!(glm::length(glm::dvec3(vertex.position)) < 3e38)) vertex.position = glm::vec3(0.0f);
    vertex.uv[0] = {input.finite(), input.finite()};
    const glm::dvec3 normal(has_normals ? madeVector(input) : glm::vec3(0.0f));
    if (glm::length(normal) > 0.0) vertex.normal = glm::vec3(glm::normalize(normal));
  }
  for (int i = 0; i < 3 * triangles; ++i)
    mesh.indices.push_back(std::uint32_t(input.upTo(int(mesh.vertices.size()) - 1)));
  if (!has_normals) computeNormals(mesh);
  computeTangents(mesh);
  return mesh;
}

/// A scene of it where it stands, or stretched.
Scene madeScene(MadeInput& input) {
  Scene scene = meshScene(madeMesh(input));
  if (input.upTo(1) == 0 || scene.instances.empty()) return scene;
  const glm::vec3 stretch = glm::abs(madeVector(input)) * input.powerOfTwo();
  if (!(stretch.x * stretch.y * stretch.z > 0.0f) || std::max({stretch.x, stretch.y, stretch.z}) > 1e30f) return scene;
  for (int axis = 0; axis < 3; ++axis) scene.instances[0].world_from_object[axis] *= stretch[axis];
  return scene;
}

/// What loadModel takes.
bool isInReach(const Scene& scene) {
  constexpr float kLargestRadius = 1e15f;
  const BoundingSphere bounds = boundingSphere(scene);
  return glm::length(bounds.center) + bounds.radius <= kLargestRadius;
}

void checkMesh(const Mesh& mesh) {
  for (const std::uint32_t index : mesh.indices) check(index < mesh.vertices.size(), "indices name vertices");
  for (const Vertex& vertex : mesh.vertices) {
    checkFinite({&vertex.position.x, 3}, "positions are finite");
    checkFinite({&vertex.normal.x, 3}, "normals are finite");
    checkFinite({&vertex.tangent.x, 4}, "tangents are finite");
    checkFinite({&vertex.uv[0].x, 2}, "texture coordinates are finite");
  }
}

void checkTransferredDirections(const Image& map) {
  for (std::size_t i = 0; i < map.texelCount(); ++i) {
    const float* n = map.samples().data() + 3 * i;
    check(std::abs(glm::length(glm::vec3(n[0], n[1], n[2])) - 1.0f) < 1e-3f, "normals are unit vectors");
  }
}

TransferSettings madeSettings(MadeInput& input) {
  TransferSettings settings;
  settings.size = glm::ivec2(1 + input.upTo(11));
  const int flags = input.byte();
  settings.samples_side = 1 + (flags & 1);
  settings.space = (flags & 2) != 0 ? NormalSpace::object : NormalSpace::tangent;
  settings.wants_heights = (flags & 4) != 0;
  settings.wants_occlusion = (flags & 8) != 0;
  settings.occlusion_rays = 4;
  settings.cage = (flags & 16) != 0 ? float(input.byte()) / 32.0f : 0.0f;
  settings.padding = input.upTo(8);
  return settings;
}

void transferBetween(const Scene& high, const Scene& low, const TransferSettings& settings) {
  const auto detail = transferDetail(high, low, settings);
  checkError(detail);
  if (!detail) return;
  checkTransferredDirections(detail->normals);
  if (settings.wants_heights) checkFinite(detail->heights.samples(), "heights are finite");
  if (!settings.wants_occlusion) return;
  checkTransferredDirections(detail->bent_normals);
  for (const float visible : detail->visible.samples())
    check(visible >= 0.0f && visible <= 1.0f, "what is seen of the sky is a share");
  const auto turned = normalsInSpace(
      detail->normals, low, settings.space == NormalSpace::object ? NormalSpace::tangent : NormalSpace::object);
  checkError(turned);
  if (turned) checkTransferredDirections(*turned);
}

}  // namespace
}  // namespace mirrorball::fuzz

MIRRORBALL_HARNESS(transfer) {
  using namespace mirrorball;
  using namespace mirrorball::fuzz;
  MadeInput input(data, size);
  const TransferSettings settings = madeSettings(input);
  const std::size_t triangles = std::size_t(1 + input.upTo(20));
  const Scene high = madeScene(input);
  const Scene low = madeScene(input);
  checkMesh(high.meshes[0]);
  if (!isInReach(high) || !isInReach(low)) return 0;
  transferBetween(high, low, settings);

  const auto fewer = simplified(high, triangles);
  checkError(fewer);
  if (!fewer) return 0;
  checkMesh(fewer->mesh);
  const auto flat = unwrapped(fewer->mesh, settings.size.x, settings.padding / 2);
  checkError(flat);
  if (!flat) return 0;
  checkMesh(flat->mesh);
  for (const Vertex& vertex : flat->mesh.vertices)
    check(glm::all(glm::lessThanEqual(glm::abs(vertex.uv[0] - 0.5f), glm::vec2(0.5f + 1e-5f))),
          "charts are in the map");
  transferBetween(high, meshScene(flat->mesh), settings);
  return 0;
}
