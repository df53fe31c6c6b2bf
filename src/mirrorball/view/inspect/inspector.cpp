#include "mirrorball/view/inspect/inspector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mirrorball/rays/path_vertex.h"
#include "mirrorball/rays/surface_finder.h"
#include "mirrorball/rays/surface_shares.h"
#include "mirrorball/render/stage/scene_rays.h"
#include "mirrorball/scene/camera/eye_rays.h"
#include "mirrorball/view/inspect/inspection_rows.h"
#include "mirrorball/view/inspect/path_following.h"

namespace mirrorball {

struct Inspector::State {
  SceneRays rays;
  InspectorOptions options;
  std::vector<glm::mat3> world_from_normal;
  float reach;

  PathWorld world(const LightAround& around) const {
    return {.scene = *rays.scene,
            .geometry = rays.geometry,
            .world_from_normal = world_from_normal,
            .relief = options.relief,
            .around = around,
            .reach = reach,
            .most_segments = options.most_segments};
  }
};

namespace {

/// The ray of an eye, in the bodies that the eye is in.
Ray rayOfEye(const PathWorld& world, const Camera& camera, const EyeRay& eye) {
  Ray ray{.origin = eye.origin, .direction = eye.direction, .nearest = eye.nearest};
  if (!camera.orthographic) ray.media = mediaAt(world.scene, world.geometry, eye.origin, world.relief);
  return ray;
}

InspectedSurface surfaceOf(const PathWorld& world, const EyeRay& eye, const PathVertex& vertex) {
  const SurfaceView seen = seenSide(vertex);
  return {.picked = pickedAt(eye, vertex.hit, world.scene, world.relief),
          .geometric_normal = vertex.hit.geometric_normal,
          .material_name = vertex.surface->name,
          .material = vertex.point.material,
          .is_inside = seen.is_inside,
          .cosine = seen.cosine,
          .fresnel = fresnelCurve(materialAgainstBeyond(vertex, 0.0f), seen.cosine, seen.is_inside),
          .reflected = followedPath(world, vertex, false),
          .refracted = followedPath(world, vertex, true)};
}

/// What the eye sees that meets nothing.
RayPath pathBehind(const LightAround& around, const EyeRay& eye) {
  RayPath path;
  path.direction = environmentDirectionOfEye(around, eye.origin, eye.direction);
  path.radiance = radianceOf(around, path.direction);
  return path;
}

}  // namespace

Inspector::Inspector(std::unique_ptr<State> state) : state_(std::move(state)) {}
Inspector::Inspector(Inspector&&) noexcept = default;
Inspector& Inspector::operator=(Inspector&&) noexcept = default;
Inspector::~Inspector() = default;

Result<Inspector> Inspector::make(std::shared_ptr<const Scene> scene, const InspectorOptions& options,
                                  const ProgressFunction& progress) {
  ProgressCounter steps(progress, 1);
  steps.advance(0);
  MIRRORBALL_TRY_VOID(steps.result());
  constexpr float kRadii = 4.0f;
  constexpr int kMostSegments = 1024;
  const float reach = kRadii * boundingSphere(*scene).radius;
  auto world_from_normal = normalMatrices(*scene);
  MIRRORBALL_TRY(rays, SceneRays::make(std::move(scene)));
  steps.advance();
  MIRRORBALL_TRY_VOID(steps.result());
  const InspectorOptions bounded{options.relief, std::clamp(options.most_segments, 1, kMostSegments)};
  return Inspector(std::make_unique<State>(State{std::move(rays), bounded, std::move(world_from_normal), reach}));
}

const Scene& Inspector::scene() const { return *state_->rays.scene; }

std::optional<Inspection> Inspector::inspectedAt(const Camera& camera, glm::ivec2 size, glm::vec2 pixel,
                                                 const LightAround& around) const {
  const bool is_inside = pixel.x >= 0.0f && pixel.y >= 0.0f && pixel.x < float(size.x) && pixel.y < float(size.y);
  if (!is_inside) return std::nullopt;
  const EyeRay eye = EyeRays(camera, size).through(pixel);
  if (!std::isfinite(eye.direction.x + eye.direction.y + eye.direction.z)) return std::nullopt;
  const PathWorld world = state_->world(around);
  Ray ray = rayOfEye(world, camera, eye);
  SurfaceFinder finder(world.scene, world.geometry, world.relief, [] { return 0.0f; });
  glm::vec3 share(1.0f);
  Inspection inspection;
  if (const auto hit = finder.first(ray, INFINITY, false, share))
    inspection.surface =
        surfaceOf(world, eye, pathVertexAt(world.scene, world.world_from_normal, *hit, ray, world.relief));
  else
    inspection.behind = pathBehind(around, eye);
  inspection.rows = rowsOf(inspection, world.scene);
  return inspection;
}

}  // namespace mirrorball
