#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <glm/glm.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What a path-traced picture shows, and when it is good enough.
struct TraceSettings {
  glm::ivec2 size{1280, 720};  ///< pixels
  int samples = 256;           ///< paths a pixel, at most; at least 1
  float noise = 0.0f;          ///< mean standard error of the displayed picture, in [0, 1], that is enough; 0: none is
  float time_s = 0.0f;         ///< after which no further pass over the picture is begun; 0: no limit
  Display display = {};        ///< that `noise` is about
  /// Surfaces that light may meet on its way to the eye. 1: the environment lights each surface, and what blocks it is
  /// dark; with `is_unoccluded`, nothing blocks it, which is all that an environment map can know.
  int bounces = 16;
  bool is_unoccluded = false;              ///< light reaches each surface as if there were nothing else
  glm::mat3 environment_from_world{1.0f};  ///< turns the environment
  float environment_intensity = 1.0f;      ///< scales its light
  bool shows_environment = true;           ///< behind the scene; else what is behind it is transparent
};

/// The table of those settings that only a path tracer has.
std::span<const Option<TraceSettings>> traceOptions();

/// A path-traced picture as far as it has come.
struct TracedPicture {
  Image radiance;      ///< linear: 4 channels, premultiplied alpha, row 0 at the top
  int samples = 0;     ///< paths a pixel
  float noise = 0.0f;  ///< mean standard error of the displayed picture, as of independent paths: rather too high
  std::uint64_t lost_paths = 0;  ///< whose light was no number, as by overflow; they count as black
  bool is_interrupted = false;   ///< before it was good enough
};

/// The truth that the techniques of the renderer are measured against: a path tracer over the same scenes, materials
/// and environments, which knows that objects block light and send it to each other (Kajiya 1986). The environment is
/// chosen by its light and surfaces by their BSDF, and both are weighed against each other (Veach & Guibas 1995).
class PathTracer {
 public:
  /// errors   too_large; unsupported (Embree does not run here); interrupted
  /// cost     the tree of triangles (geometry.h) and the environment's table (light_sampler.h)
  static Result<PathTracer> make(Scene scene, Environment environment, const ProgressFunction& progress = {});

  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;
  ~PathTracer();

  const Scene& scene() const;

  /// Draws passes over the whole picture, each with as many paths as all before it, up to a hundred.
  ///
  /// progress  told of paths, of all or, with `noise` or `time_s`, of those up to the pass's end; called from all
  ///           threads. When it says so, the passes that are whole are the picture
  /// returns   with `samples` or `noise` as the limit, the same bits for any number of threads
  /// errors    too_large; interrupted, before the first pass (one path a pixel) was whole
  /// cost      docs/truth.md has paths a second
  Result<TracedPicture> render(const Camera& camera, const TraceSettings& settings,
                               const ProgressFunction& progress = {}) const;

 private:
  struct State;
  explicit PathTracer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
