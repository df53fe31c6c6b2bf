#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <utility>

#include <embree3/rtcore.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/rays/ray_tree.h"
#include "mirrorball/scene/box.h"

namespace mirrorball {
namespace {

/// What makes a scene about as large as 1, in which Embree keeps it: it gives no barycentric coordinates of triangles
/// whose area is below 1e-18 (min_rcp_input, common/math/constants.h), such as those of a model in micrometres whose
/// unit is the metre. A power of two rounds nothing.
float embreeFromWorld(const Scene& scene) {
  constexpr int kMost = 100;
  const Box box = boundingBox(scene);
  const glm::vec3 half = 0.5f * box.high - 0.5f * box.low;  // of numbers whose difference is beyond floats, too
  const float largest = std::max({half.x, half.y, half.z});
  return largest > 0.0f ? std::ldexp(1.0f, -std::clamp(std::ilogb(largest), -kMost, kMost)) : 1.0f;
}

/// A mesh's triangles where an instance puts them.
///
/// scale   embreeFromWorld()
RTCGeometry placedMesh(RTCDevice device, const Scene& scene, std::size_t instance, float scale) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const glm::mat4& world_from_object = scene.instances[instance].world_from_object;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
  for (std::size_t i = 0; positions && i < mesh.vertices.size(); ++i) {
    const glm::vec3 place(world_from_object * glm::vec4(mesh.vertices[i].position, 1.0f));
    // Embree leaves triangles out that are as large as this.
    positions[i] = isFinite(scale * place) ? scale * place : glm::vec3(std::numeric_limits<float>::max());
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

/// Prisms, which stay in the world's units.
struct PlacedPrisms {
  const ReliefPrisms& prisms;
  float scale;  ///< embreeFromWorld()
};

void boundsOfPrism(const RTCBoundsFunctionArguments* arguments) {
  const auto& placed = *static_cast<const PlacedPrisms*>(arguments->geometryUserPtr);
  const PrismBounds in_world = placed.prisms.boundsOf(arguments->primID);
  const PrismBounds bounds{placed.scale * in_world.low, placed.scale * in_world.high};
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
  const auto& [prisms, scale] = *static_cast<const PlacedPrisms*>(arguments->geometryUserPtr);
  auto& ray_hit = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  RTCRay& ray = ray_hit.ray;
  const auto place = prisms.hit(arguments->primID, glm::vec3(ray.org_x, ray.org_y, ray.org_z) / scale,
                                {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear / scale, ray.tfar / scale);
  if (!place || !(place->distance < ray.tfar / scale)) return;
  ray.tfar = scale * place->distance;
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

/// placed   must outlive it
RTCGeometry placedPrisms(RTCDevice device, PlacedPrisms& placed) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(placed.prisms.size()));
  rtcSetGeometryUserData(geometry, &placed);
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

Result<void> checkDevice(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return {};
  if (error == RTC_ERROR_OUT_OF_MEMORY) return fail(ErrorCode::too_large, "the scene's triangles: no memory for them");
  return fail(ErrorCode::unsupported,
              "Embree cannot sort the scene's triangles (its error " + std::to_string(error) + ")");
}

class EmbreeTree : public RayTree {
 public:
  EmbreeTree(RTCDevice device, const Scene& scene, const PrismsOfInstances& prisms)
      : device_(device), tree_(newScene(device)), prisms_(prisms), scale_(embreeFromWorld(scene)) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const auto found = prisms.find(i);
      attach(tree_, i,
             found == prisms.end() ? placedMesh(device, scene, i, scale_)
                                   : placedPrisms(device, placed_.emplace_back(PlacedPrisms{*found->second, scale_})));
    }
    rtcCommitScene(tree_);
  }
  ~EmbreeTree() override {
    rtcReleaseScene(tree_);
    rtcReleaseDevice(device_);
  }

  std::optional<Hit> hit(glm::vec3 origin, glm::vec3 direction, float nearest) const override;

 private:
  RTCDevice device_;
  RTCScene tree_;
  const PrismsOfInstances& prisms_;
  float scale_;                      // embreeFromWorld()
  std::deque<PlacedPrisms> placed_;  // where Embree finds them
};

std::optional<Hit> EmbreeTree::hit(glm::vec3 origin, glm::vec3 direction, float nearest) const {
  Query query;
  rtcInitIntersectContext(&query);
  RTCRayHit ray{};
  ray.ray.org_x = scale_ * origin.x;
  ray.ray.org_y = scale_ * origin.y;
  ray.ray.org_z = scale_ * origin.z;
  ray.ray.dir_x = direction.x;
  ray.ray.dir_y = direction.y;
  ray.ray.dir_z = direction.z;
  ray.ray.tnear = scale_ * nearest;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tree_, &query, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const glm::vec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
  Hit hit{
      ray.ray.tfar / scale_, ray.hit.geomID, ray.hit.primID, {ray.hit.u, ray.hit.v}, normalOfMet(normal, direction)};
  if (prisms_.contains(hit.instance)) hit.relief = query.relief;
  return hit;
}

}  // namespace

RayTracer fastestRayTracer() { return RayTracer::embree; }

namespace {

/// Whether there are enough addresses for Embree. Where they end while its threads or TBB's pools begin, it crashes or
/// hangs instead of failing.
bool hasRoom(const Scene& scene) {
  constexpr std::uint64_t kOfThreadsAndPools = std::uint64_t{1} << 30, kOfTriangle = 400;
  std::uint64_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
  return addressSpaceLeft() >= kOfThreadsAndPools + kOfTriangle * triangles;
}

}  // namespace

Result<std::unique_ptr<RayTree>> embreeTree(const Scene& scene, const PrismsOfInstances& prisms) {
  if (!hasRoom(scene)) return fail(ErrorCode::unsupported, "Embree has too little address space");
  RTCDevice device = rtcNewDevice(nullptr);
  if (!device) return fail(ErrorCode::unsupported, "Embree cannot be started on this processor");
  auto tree = std::make_unique<EmbreeTree>(device, scene, prisms);
  MIRRORBALL_TRY_VOID(checkDevice(device));
  return Result<std::unique_ptr<RayTree>>(std::move(tree));
}

}  // namespace mirrorball
