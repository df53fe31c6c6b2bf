#include "mirrorball/trace/geometry.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include <embree3/rtcore.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/trace/relief_prisms.h"

namespace mirrorball {
namespace {

/// What Embree takes for a triangle while it builds its tree, with the vertices: 111 to 128 bytes, of which 78 to 85
/// are kept, measured on grids of 0.18 to 8 million triangles.
constexpr std::uint64_t kBytesPerTriangle = 130;

/// With the prism itself.
constexpr std::uint64_t kBytesPerPrism = 370;

bool isFinite(glm::vec3 p) { return !glm::any(glm::isnan(p)) && !glm::any(glm::isinf(p)); }

/// A mesh's triangles where an instance puts them.
RTCGeometry placedMesh(RTCDevice device, const Mesh& mesh, const glm::mat4& world_from_object) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
  for (std::size_t i = 0; positions && i < mesh.vertices.size(); ++i) {
    const glm::vec3 place(world_from_object * glm::vec4(mesh.vertices[i].position, 1.0f));
    // Embree leaves triangles out that are as large as this.
    positions[i] = isFinite(place) ? place : glm::vec3(std::numeric_limits<float>::max());
  }
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
  if (indices) std::copy_n(mesh.indices.begin(), mesh.indices.size() / 3 * 3, indices);
  rtcCommitGeometry(geometry);
  return geometry;
}

/// What a ray asks, with the place of the nearest relief so far.
struct Query : RTCIntersectContext {
  Hit::Relief relief;
};

void boundsOfPrism(const RTCBoundsFunctionArguments* arguments) {
  const auto& prisms = *static_cast<const ReliefPrisms*>(arguments->geometryUserPtr);
  const PrismBounds bounds = prisms.boundsOf(arguments->primID);
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = bounds.low.x;
  out.lower_y = bounds.low.y;
  out.lower_z = bounds.low.z;
  out.upper_x = bounds.high.x;
  out.upper_y = bounds.high.y;
  out.upper_z = bounds.high.z;
}

/// Of one ray, as rtcIntersect1 has it.
void meetPrism(const RTCIntersectFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  const auto& prisms = *static_cast<const ReliefPrisms*>(arguments->geometryUserPtr);
  auto& ray_hit = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  RTCRay& ray = ray_hit.ray;
  const auto place = prisms.hit(arguments->primID, {ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z},
                                ray.tnear, ray.tfar);
  if (!place || !(place->distance < ray.tfar)) return;
  ray.tfar = place->distance;
  RTCHit& hit = ray_hit.hit;
  hit.u = place->barycentric.x;
  hit.v = place->barycentric.y;
  hit.Ng_x = place->geometric_normal.x;
  hit.Ng_y = place->geometric_normal.y;
  hit.Ng_z = place->geometric_normal.z;
  hit.primID = arguments->primID;
  hit.geomID = arguments->geomID;
  hit.instID[0] = arguments->context->instID[0];
  static_cast<Query*>(arguments->context)->relief = {place->position, place->up};
}

RTCGeometry placedPrisms(RTCDevice device, ReliefPrisms& prisms) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(prisms.size()));
  rtcSetGeometryUserData(geometry, &prisms);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* arguments) { boundsOfPrism(arguments); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meetPrism);
  rtcCommitGeometry(geometry);
  return geometry;
}

RTCScene newScene(RTCDevice device) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  return scene;
}

bool hasHeights(const Scene& scene, std::size_t instance) {
  const Material& material = materialOf(scene, instance);
  return material.height != HeightKind::none && material.height_texture >= 0;
}

/// What may be in memory at a time.
std::uint64_t memoryFor(const Scene& scene) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint64_t triangles = scene.meshes[std::size_t(scene.instances[i].mesh)].indices.size() / 3;
    bytes += triangles * (hasHeights(scene, i) ? kBytesPerTriangle + kBytesPerPrism : kBytesPerTriangle);
  }
  return bytes;
}

}  // namespace

struct Geometry::State {
  RTCDevice device = nullptr;
  RTCScene triangles = nullptr;
  RTCScene reliefs =
      nullptr;  // instances with heights by their prisms, all others by their triangles; none has heights
  // Both stay where they are in memory: Embree and the prisms refer to them.
  std::map<int, std::unique_ptr<TwoSidedHeights>> heights;      // of Scene::height_textures
  std::map<std::size_t, std::unique_ptr<ReliefPrisms>> prisms;  // of instances

  ~State() {
    if (reliefs) rtcReleaseScene(reliefs);
    if (triangles) rtcReleaseScene(triangles);
    if (device) rtcReleaseDevice(device);
  }

  Result<void> addPrisms(const Scene& scene);
  void attach(const Scene& scene);
};

/// The prisms of all instances with heights.
Result<void> Geometry::State::addPrisms(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!hasHeights(scene, i)) continue;
    const int texture = materialOf(scene, i).height_texture;
    if (!heights.contains(texture)) {
      MIRRORBALL_TRY(both, twoSided(scene.height_textures[std::size_t(texture)]));
      heights[texture] = std::make_unique<TwoSidedHeights>(std::move(both));
    }
    prisms[i] = std::make_unique<ReliefPrisms>(scene, i, *heights[texture]);
  }
  return {};
}

void Geometry::State::attach(const Scene& scene) {
  triangles = newScene(device);
  if (!prisms.empty()) reliefs = newScene(device);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const auto number = static_cast<unsigned>(i);
    RTCGeometry mesh = placedMesh(device, scene.meshes[std::size_t(instance.mesh)], instance.world_from_object);
    rtcAttachGeometryByID(triangles, mesh, number);
    if (reliefs && !prisms.contains(i)) rtcAttachGeometryByID(reliefs, mesh, number);
    rtcReleaseGeometry(mesh);
    if (!prisms.contains(i)) continue;
    RTCGeometry below = placedPrisms(device, *prisms[i]);
    rtcAttachGeometryByID(reliefs, below, number);
    rtcReleaseGeometry(below);
  }
  rtcCommitScene(triangles);
  if (reliefs) rtcCommitScene(reliefs);
}

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

Result<Geometry> Geometry::make(const Scene& scene) {
  MIRRORBALL_TRY_VOID(withName("the scene's triangles", checkMemory(memoryFor(scene))));
  auto state = std::make_unique<State>();
  state->device = rtcNewDevice(nullptr);
  if (!state->device) return fail(ErrorCode::unsupported, "Embree cannot be started on this processor");
  MIRRORBALL_TRY_VOID(state->addPrisms(scene));
  state->attach(scene);
  if (const RTCError error = rtcGetDeviceError(state->device); error == RTC_ERROR_OUT_OF_MEMORY)
    return fail(ErrorCode::too_large, "the scene's triangles: no memory for them");
  else if (error != RTC_ERROR_NONE)
    return fail(ErrorCode::unsupported,
                "Embree cannot sort the scene's triangles (its error " + std::to_string(error) + ")");
  return Geometry(std::move(state));
}

std::optional<Hit> Geometry::hit(glm::vec3 origin, glm::vec3 direction, float nearest, Surfaces surfaces) const {
  if (!isFinite(origin) || !isFinite(direction)) return std::nullopt;
  const bool meets_reliefs = surfaces == Surfaces::reliefs && state_->reliefs;
  Query query;
  rtcInitIntersectContext(&query);
  RTCRayHit ray{};
  ray.ray.org_x = origin.x;
  ray.ray.org_y = origin.y;
  ray.ray.org_z = origin.z;
  ray.ray.dir_x = direction.x;
  ray.ray.dir_y = direction.y;
  ray.ray.dir_z = direction.z;
  ray.ray.tnear = nearest;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(meets_reliefs ? state_->reliefs : state_->triangles, &query, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const glm::vec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
  Hit hit{ray.ray.tfar, ray.hit.geomID, ray.hit.primID, {ray.hit.u, ray.hit.v}, glm::normalize(normal)};
  if (meets_reliefs && state_->prisms.contains(hit.instance)) hit.relief = query.relief;
  return hit;
}

}  // namespace mirrorball
