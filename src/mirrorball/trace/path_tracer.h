#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// What denoisers ask for beside the radiance: means over the paths, 3 channels each.
struct TraceLayers {
  Image albedo;    ///< base colour of the first surface, or a metal's reflectance at normal incidence; 0: none is there
  Image normal;    ///< its normal, world, on the eye's side
  Image variance;  ///< of the radiance of the picture, as of independent paths
};

/// A path-traced picture as far as it has come.
struct TracedPicture {
  Image radiance;  ///< linear: 4 channels, premultiplied alpha, row 0 at the top
  std::optional<TraceLayers> layers = {};
  int samples = 0;     ///< paths a pixel, in the mean
  float noise = 0.0f;  ///< mean standard error of the displayed picture, as of independent paths: rather too high
  std::uint64_t lost_paths = 0;  ///< whose light was no number, as by overflow; they count as black
  bool is_interrupted = false;   ///< before it was good enough
};

/// Who is told how far the tracing is.
struct TraceObserver {
  /// Of paths, of all that there will be, as far as that is known before: by their noise, or by the time that they
  /// took. Called from all threads. When it says so, the passes that are whole are the picture.
  ProgressFunction progress = {};
  /// Of each whole pass, with TracedPicture's `samples` and `noise` up to then, which takes the time to compute it.
  std::function<void(int samples, float noise)> pass = {};
  /// Of the picture after each whole pass, which takes the time to compute it; without layers.
  std::function<void(TracedPicture so_far)> picture = {};
};

/// A map of all directions as far as it has come.
struct TracedMap {
  EnvironmentMap map;
  TracedPicture state;  ///< without its pictures
};

/// Where light is captured.
struct TracedCapture {
  glm::vec3 position{0.0f};                      ///< world; finite
  Projection projection = Projection::equirect;  ///< of the map
  int size = 512;                                ///< a face's side, a disc's diameter, a panorama's height [texels]
  float nearest = 0.0f;                          ///< distance from which on surfaces are there [world units]
};

/// The truth that the techniques of the renderer are measured against: a path tracer over the same scenes, materials
/// and environments, which knows that objects block light and send it to each other (Kajiya 1986). The environment and
/// what shines in the scene are chosen by their light, surfaces by their BSDF, and both are weighed against each other
/// (Veach & Guibas 1995).
class PathTracer {
 public:
  /// errors   too_large; interrupted
  /// cost     the tree of triangles (geometry.h) and the environment's table (light_sampler.h)
  static Result<PathTracer> make(Scene scene, Environment environment, const ProgressFunction& progress = {},
                                 RayTracer tracer = fastestRayTracer());

  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;
  ~PathTracer();

  const Scene& scene() const;

  /// Replaces the scene; the environment's table stays.
  ///
  /// errors   as make's; the scene is then the one before
  /// cost     the tree of triangles
  Result<void> setScene(Scene scene);

  /// Replaces the scene's materials; the tree of triangles stays.
  ///
  /// materials   for each of those before one, with the same heights, as deep and as dense
  void setMaterials(std::vector<Material> materials);

  /// Draws passes over the whole picture, each with as many paths as all before it, up to 128. With `noise` as the
  /// limit, paths are drawn where the noise is (path_schedule.h).
  ///
  /// returns   with `samples` or `noise` as the limit, the same bits for any number of threads
  /// errors    too_large; interrupted, before the first pass (one path a pixel) was whole
  /// cost      docs/performance/paths.md has paths a second
  Result<TracedPicture> render(const Camera& camera, const TraceSettings& settings,
                               const TraceObserver& observer = {}) const;

  /// Traces the light that arrives at a point of the scene: an environment map.
  ///
  /// settings  their `size` and `wants_layers` are not used; if neither the environment nor a background is shown, what
  ///           is behind the scene is black
  /// returns   three channels, or four for discs, with alpha 0 outside of them. The world's axes are the map's. For
  ///           `samples` and `noise`, likewise the same bits
  /// errors    as render's
  Result<TracedMap> capture(const TracedCapture& capture, TraceSettings settings,
                            const TraceObserver& observer = {}) const;

 private:
  struct State;
  explicit PathTracer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
