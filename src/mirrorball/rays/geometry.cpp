#include "mirrorball/rays/geometry.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include <embree3/rtcore.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/rays/relief_prisms.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

/// What Embree takes for a triangle while it builds its tree, with the vertices: 111 to 128 bytes, of which 78 to 85
/// are kept, measured on grids of 0.18 to 8 million triangles.
constexpr std::uint64_t kBytesPerTriangle = 130;

/// Of a triangle with relief: its prism, and what Embree takes for that.
constexpr std::uint64_t kBytesPerPrism = 500;

bool isFinite(glm::vec3 p) { return !glm::any(glm::isnan(p)) && !glm::any(glm::isinf(p)); }

/// A mesh's triangles where an instance puts them.
RTCGeometry placedMesh(RTCDevice device, const Scene& scene, std::size_t instance) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const glm::mat4& world_from_object = scene.instances[instance].world_from_object;
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

/// Takes a geometry, as that of an instance.
void attach(RTCScene scene, std::size_t instance, RTCGeometry geometry) {
  rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(instance));
  rtcReleaseGeometry(geometry);
}

RTCScene newScene(RTCDevice device) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  return scene;
}

bool hasRelief(const Scene& scene, std::size_t instance) {
  return showsHeightTexture(materialOf(scene, instance), ReliefKind::exact);
}

/// What the triangles of all instances may take, or of those with relief, at so many bytes each.
std::uint64_t memoryFor(const Scene& scene, std::uint64_t bytes_each, bool is_of_reliefs) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (!is_of_reliefs || hasRelief(scene, i))
      bytes += scene.meshes[std::size_t(scene.instances[i].mesh)].indices.size() / 3 * bytes_each;
  return bytes;
}

Result<void> checkDevice(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return {};
  if (error == RTC_ERROR_OUT_OF_MEMORY) return fail(ErrorCode::too_large, "the scene's triangles: no memory for them");
  return fail(ErrorCode::unsupported,
              "Embree cannot sort the scene's triangles (its error " + std::to_string(error) + ")");
}

}  // namespace

struct Geometry::State {
  RTCDevice device = nullptr;
  RTCScene triangles = nullptr;
  std::mutex making_reliefs;
  RTCScene reliefs = nullptr;  // instances with relief by their prisms, all others by their triangles; null: not made
  // Both stay where they are in memory: Embree and the prisms refer to them.
  std::map<int, std::unique_ptr<TwoSidedHeights>> heights;      // of Scene::height_textures
  std::map<std::size_t, std::unique_ptr<ReliefPrisms>> prisms;  // of instances

  ~State() {
    if (reliefs) rtcReleaseScene(reliefs);
    if (triangles) rtcReleaseScene(triangles);
    if (device) rtcReleaseDevice(device);
  }

  Result<void> makePrisms(const Scene& scene);
};

/// The prisms of all instances with relief.
Result<void> Geometry::State::makePrisms(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!hasRelief(scene, i)) continue;
    const int texture = materialOf(scene, i).height_texture;
    const auto [found, is_new] = heights.try_emplace(texture);
    if (is_new) found->second = std::make_unique<TwoSidedHeights>(scene.height_textures[std::size_t(texture)]);
    if (hasBack(materialOf(scene, i))) MIRRORBALL_TRY_VOID(found->second->makeDepths());
    prisms[i] = std::make_unique<ReliefPrisms>(scene, i, *found->second);
  }
  return {};
}

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

Result<Geometry> Geometry::make(const Scene& scene) {
  MIRRORBALL_TRY_VOID(withName("the scene's triangles", checkMemory(memoryFor(scene, kBytesPerTriangle, false))));
  auto state = std::make_unique<State>();
  state->device = rtcNewDevice(nullptr);
  if (!state->device) return fail(ErrorCode::unsupported, "Embree cannot be started on this processor");
  state->triangles = newScene(state->device);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    attach(state->triangles, i, placedMesh(state->device, scene, i));
  rtcCommitScene(state->triangles);
  MIRRORBALL_TRY_VOID(checkDevice(state->device));
  return Geometry(std::move(state));
}

Result<void> Geometry::makeReliefs(const Scene& scene) {
  State& state = *state_;
  const std::lock_guard lock(state.making_reliefs);
  if (state.reliefs) return {};
  MIRRORBALL_TRY_VOID(withName("the scene's relief", checkMemory(memoryFor(scene, kBytesPerPrism, true))));
  MIRRORBALL_TRY_VOID(state.makePrisms(scene));
  if (state.prisms.empty()) return {};
  RTCScene reliefs = newScene(state.device);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    attach(
        reliefs, i,
        state.prisms.contains(i) ? placedPrisms(state.device, *state.prisms[i]) : placedMesh(state.device, scene, i));
  rtcCommitScene(reliefs);
  state.reliefs = reliefs;
  return checkDevice(state.device);
}

std::optional<Hit> Geometry::hit(glm::vec3 origin, glm::vec3 direction, float nearest, Surfaces surfaces) const {
  constexpr float kFarthest = 1e18f;  // Embree takes no ray from farther away: it may end the program
  const bool is_near = glm::all(glm::lessThanEqual(glm::abs(origin), glm::vec3(kFarthest)));
  if (!is_near || !isFinite(direction)) return std::nullopt;
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
