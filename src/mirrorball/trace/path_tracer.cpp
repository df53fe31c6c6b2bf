#include "mirrorball/trace/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/trace/camera_rays.h"
#include "mirrorball/trace/film.h"
#include "mirrorball/trace/light_path.h"

namespace mirrorball {
namespace {

/// The most paths that a pass adds: what an interruption, or a limit of the time, may cost.
constexpr int kLargestPass = 128;

void addPath(PixelSums& sums, const PathLight& path) {
  const glm::vec4& light = path.radiance;
  ++sums.paths;
  if (!std::isfinite(light.x + light.y + light.z)) {
    ++sums.lost;
    sums.light.w += 1.0;
    return;
  }
  sums.light += glm::dvec4(light);
  sums.squares += glm::dvec3(light) * glm::dvec3(light);
  sums.albedo += path.albedo;
  sums.normal += path.normal;
}

/// The paths of one pass.
struct PassRange {
  int first;     ///< index of the first one of a pixel
  int count;     ///< of a pixel
  int expected;  ///< how many paths of a pixel there will be in all passes, as far as is known
};

/// How many paths a pixel there will be, after so many with this noise in this time.
int expectedSamples(const TraceSettings& settings, int samples, float noise, float elapsed_s) {
  double expected = settings.samples;
  // Errors fall with the root of the number of paths.
  if (settings.noise > 0.0f) expected = std::min(expected, samples * std::pow(double(noise / settings.noise), 2.0));
  if (settings.time_s > 0.0f) expected = std::min(expected, samples * double(settings.time_s / elapsed_s));
  return static_cast<int>(std::ceil(expected));
}

/// The images of a map that lie one below the other. What is transparent is black.
ImageSet cutIntoFaces(const Image& all, Projection projection, glm::ivec2 size) {
  const int channels = hasDisc(projection) ? 4 : 3;
  ImageSet images(1, faceCount(projection));
  for (int face = 0; face < images.faces(); ++face) {
    Image& image = images.at(0, face) = Image(size.x, size.y, channels);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        float* const texel = image.texel(x, y);
        std::copy_n(all.texel(x, face * size.y + y), 3, texel);
        if (channels == 4) texel[3] = covers(projection, (glm::vec2(x, y) + 0.5f) / glm::vec2(size)) ? 1.0f : 0.0f;
      }
  }
  return images;
}

}  // namespace

struct PathTracer::State : World {
  Result<void> makeReliefs(const TraceSettings& settings) {
    return movesSurface(settings.relief) ? geometry.makeReliefs(scene) : Result<void>();
  }
  Result<Film> trace(const CameraRays& rays, const TraceSettings& settings, TracedPicture& picture,
                     const TraceObserver& observer) const;
  bool drawPass(const CameraRays& rays, const Surroundings& surroundings, const Emitters& emitters,
                const TraceSettings& settings, const PassRange& range, Film& pass,
                const ProgressFunction& progress) const;
};

PathTracer::PathTracer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

const Scene& PathTracer::scene() const { return state_->scene; }

Result<PathTracer> PathTracer::make(Scene scene, Environment environment, const ProgressFunction& progress,
                                    RayTracer tracer) {
  if (EnvironmentMap* map = environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(lights, LightSampler::make(environment, progress));
  MIRRORBALL_TRY(geometry, Geometry::make(scene, tracer));
  std::vector<glm::mat3> world_from_normal = normalMatrices(scene);
  return PathTracer(std::unique_ptr<State>(new State{{std::move(scene), std::move(environment), std::move(lights),
                                                      std::move(geometry), std::move(world_from_normal)}}));
}

Result<void> PathTracer::setScene(Scene scene) {
  MIRRORBALL_TRY(geometry, Geometry::make(scene, state_->geometry.tracer()));
  state_->geometry = std::move(geometry);
  state_->world_from_normal = normalMatrices(scene);
  state_->scene = std::move(scene);
  return {};
}

void PathTracer::setMaterials(std::vector<Material> materials) {
  assert(materials.size() == state_->scene.materials.size());
  state_->scene.materials = std::move(materials);
}

/// returns  whether the pass is whole
bool PathTracer::State::drawPass(const CameraRays& rays, const Surroundings& surroundings, const Emitters& emitters,
                                 const TraceSettings& settings, const PassRange& range, Film& pass,
                                 const ProgressFunction& progress) const {
  std::atomic<bool> is_stopped = false;
  const glm::ivec2 size = pass.size();
  const auto rows = static_cast<std::size_t>(size.y);
  const std::size_t pixels = rows * static_cast<std::size_t>(size.x);
  std::atomic<std::size_t> paths_done = pixels * std::size_t(range.first);
  const std::size_t paths_in_all = pixels * std::size_t(range.expected);
  parallelFor(rows, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !is_stopped; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x && !is_stopped; ++x) {
        PixelSums& sums = pass.at(x, y);
        sums = {};
        for (int index = range.first; index < range.first + range.count; ++index) {
          SampleSequence samples(static_cast<std::uint32_t>(y * size.x + x), static_cast<std::uint32_t>(index));
          if (const auto ray = rays(glm::vec2(x, y) + samples.next()))
            addPath(sums, lightAlong(*this, surroundings, emitters, settings, *ray, samples));
        }
        paths_done += std::size_t(range.count);
        if (progress && !progress(paths_done, paths_in_all)) is_stopped = true;
      }
    }
  });
  return !is_stopped;
}

/// Draws passes until the picture is good enough.
Result<Film> PathTracer::State::trace(const CameraRays& rays, const TraceSettings& settings, TracedPicture& picture,
                                      const TraceObserver& observer) const {
  const auto start = std::chrono::steady_clock::now();
  const glm::ivec2 size = settings.size;
  const std::uint64_t pixels = std::uint64_t(size.x) * std::uint64_t(size.y);
  const std::uint64_t channels = settings.wants_layers ? 13 : 4;
  MIRRORBALL_TRY_VOID(
      withName("the picture", checkMemory(pixels * (2 * sizeof(PixelSums) + channels * sizeof(float)))));
  MIRRORBALL_TRY(proxy, placedProxy(settings.proxy, scene));
  const Surroundings surroundings(environment, lights, std::move(proxy), settings);
  const Emitters emitters(scene, world_from_normal, settings.environment_intensity * lights.meanLuminance(), settings);
  Film film(size), pass(size);
  const int max_samples = std::max(settings.samples, 1);
  int expected = max_samples;
  while (film.samples() < max_samples) {
    const int done = film.samples();
    const int count = std::min({std::max(done, 1), kLargestPass, max_samples - done});
    if (!drawPass(rays, surroundings, emitters, settings, {done, count, std::max(expected, done + count)}, pass,
                  observer.progress)) {
      picture.is_interrupted = true;
      break;
    }
    film.addPass(pass, count);
    const std::chrono::duration<float> elapsed = std::chrono::steady_clock::now() - start;
    if (settings.time_s > 0.0f && elapsed.count() >= settings.time_s) break;
    // The noise takes about as long as one path a pixel: only where someone asks for it.
    const float noise = settings.noise > 0.0f || observer.pass ? film.noise(settings.display) : 0.0f;
    if (observer.pass) observer.pass(film.samples(), noise);
    // The error of few paths is not known well enough to stop by it.
    constexpr int kMinSamples = 16;
    if (settings.noise > 0.0f && film.samples() >= kMinSamples && noise <= settings.noise) break;
    expected = expectedSamples(settings, film.samples(), noise, elapsed.count());
  }
  if (film.samples() == 0)
    return fail(ErrorCode::interrupted, "interrupted before the first pass; nothing was written");
  picture.samples = film.samples();
  picture.noise = film.noise(settings.display);
  picture.lost_paths = film.lost();
  return film;
}

Result<TracedPicture> PathTracer::render(const Camera& camera, const TraceSettings& settings,
                                         const TraceObserver& observer) const {
  MIRRORBALL_TRY_VOID(state_->makeReliefs(settings));
  const formula::Media media =
      camera.orthographic ? formula::Media() : mediaAt(*state_, camera.position, settings.relief);
  TracedPicture picture;
  MIRRORBALL_TRY(film, state_->trace(raysOf(camera, settings.size, media), settings, picture, observer));
  picture.radiance = film.radiance();
  if (settings.wants_layers) picture.layers = TraceLayers{film.albedo(), film.normal(), film.variance()};
  return picture;
}

Result<TracedMap> PathTracer::capture(const TracedCapture& capture, TraceSettings settings,
                                      const TraceObserver& observer) const {
  MIRRORBALL_TRY_VOID(state_->makeReliefs(settings));
  const glm::ivec2 size = imageSize(capture.projection, capture.size);
  const int faces = faceCount(capture.projection);
  settings.size = {size.x, size.y * faces};
  settings.wants_layers = false;
  TracedMap traced;
  const CameraRays rays = raysOfMap(capture.projection, size, capture.position, capture.nearest,
                                    mediaAt(*state_, capture.position, settings.relief));
  MIRRORBALL_TRY(film, state_->trace(rays, settings, traced.state, observer));
  traced.map = EnvironmentMap(capture.projection, cutIntoFaces(film.radiance(), capture.projection, size));
  return traced;
}

}  // namespace mirrorball
