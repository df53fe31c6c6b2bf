#include "mirrorball/trace/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/path_vertex.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/trace/camera_rays.h"
#include "mirrorball/trace/film.h"
#include "mirrorball/trace/light_path.h"
#include "mirrorball/trace/path_schedule.h"

namespace mirrorball {
namespace {

void addPath(PixelSums& sums, const PathLight& path) {
  const glm::vec4& light = path.radiance;
  ++sums.paths;
  if (!std::isfinite(light.x + light.y + light.z)) {
    ++sums.lost;
    sums.light.w += 1.0;
    return;
  }
  sums.light += glm::dvec4(light);
  sums.squares += glm::dvec4(light) * glm::dvec4(light);
  sums.albedo += path.albedo;
  sums.normal += path.normal;
}

/// What one pass draws.
struct PassPlan {
  const Film& film;  ///< to whose paths it adds
  int half;          ///< of the film
  const PathCounts& counts;
  std::uint64_t expected;  ///< how many paths there will be in all passes, as far as is known
};

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
                const TraceSettings& settings, const PassPlan& plan, FilmPass& pass,
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
                                 const TraceSettings& settings, const PassPlan& plan, FilmPass& pass,
                                 const ProgressFunction& progress) const {
  std::atomic<bool> is_stopped = false;
  const auto width = static_cast<std::size_t>(pass.size().x);
  const std::size_t pixels = width * static_cast<std::size_t>(pass.size().y);
  std::atomic<std::size_t> paths_done = plan.film.paths();
  const auto drawPixel = [&](std::size_t pixel) {
    PixelSums& sums = pass.at(pixel) = {};
    const glm::vec2 corner(pixel % width, pixel / width);
    const auto sequence = static_cast<std::uint32_t>(pixel + std::size_t(plan.half) * pixels);
    const int first = plan.film.pathsOf(pixel, plan.half);
    const int end = plan.counts.at(pixel);
    for (int index = first; index < end; ++index) {
      SampleSequence samples(sequence, static_cast<std::uint32_t>(index));
      if (const auto ray = rays(corner + samples.next()))
        addPath(sums, lightAlong(*this, surroundings, emitters, settings, *ray, samples));
    }
    return static_cast<std::size_t>(std::max(end - first, 0));
  };
  // To report each pixel would take as long as a tenth of a short path.
  constexpr std::size_t kPixelsBetweenReports = 16;
  parallelFor(pixels, kPixelsBetweenReports, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end && !is_stopped;) {
      const std::size_t next = std::min(pixel + kPixelsBetweenReports, end);
      std::size_t paths = 0;
      for (; pixel < next; ++pixel) paths += drawPixel(pixel);
      paths_done += paths;
      if (progress && !progress(paths_done, std::max<std::size_t>(plan.expected, paths_done))) is_stopped = true;
    }
  });
  return !is_stopped;
}

/// Draws passes until the picture is good enough.
Result<Film> PathTracer::State::trace(const CameraRays& rays, const TraceSettings& settings, TracedPicture& picture,
                                      const TraceObserver& observer) const {
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t pixels = std::uint64_t(settings.size.x) * std::uint64_t(settings.size.y);
  const bool is_to_noise = settings.noise > 0.0f && settings.samples >= kMinPathsForNoise;
  const int halves = is_to_noise ? 2 : 1;
  // Of layers; of errors and shares of paths.
  const std::uint64_t channels = (settings.wants_layers ? 13 : 4) + (is_to_noise ? 5 : 0);
  MIRRORBALL_TRY_VOID(withName(
      "the picture", checkMemory(pixels * (std::uint64_t(halves + 1) * sizeof(PixelSums) + channels * sizeof(float)))));
  MIRRORBALL_TRY(proxy, placedProxy(settings.proxy, scene));
  const Surroundings surroundings(environment, lights, std::move(proxy), settings);
  const Emitters emitters(scene, world_from_normal, settings.environment_intensity * lights.meanLuminance(), settings);
  Film film(settings.size, halves, settings.shows_environment ? std::nullopt : settings.background);
  FilmPass pass(settings.size);
  const auto draw = [&](int half, const PathCounts& counts, std::uint64_t expected) {
    if (!drawPass(rays, surroundings, emitters, settings, {film, half, counts, expected}, pass, observer.progress))
      return false;
    film.addPass(pass, half, counts);
    return true;
  };
  const auto samplesOf = [&] { return static_cast<int>((film.paths() + pixels / 2) / pixels); };
  const auto goesOn = [&] {
    if (observer.pass) observer.pass(samplesOf(), film.noise(settings.display));
    if (observer.picture)
      observer.picture({.radiance = film.radiance(), .samples = samplesOf(), .noise = film.noise(settings.display)});
    const std::chrono::duration<float> elapsed = std::chrono::steady_clock::now() - start;
    return settings.time_s == 0.0f || elapsed.count() < settings.time_s;
  };
  const auto trace = is_to_noise ? traceToNoise : traceEvenly;
  picture.is_interrupted = !trace(film, settings, draw, goesOn);
  picture.samples = samplesOf();
  picture.noise = film.noise(settings.display);
  picture.lost_paths = film.lost();
  if (film.paths() == 0) return fail(ErrorCode::interrupted, "interrupted before the first pass; nothing was written");
  return film;
}

Result<TracedPicture> PathTracer::render(const Camera& camera, const TraceSettings& settings,
                                         const TraceObserver& observer) const {
  MIRRORBALL_TRY_VOID(state_->makeReliefs(settings));
  const formula::Media media = camera.orthographic
                                   ? formula::Media()
                                   : mediaAt(state_->scene, state_->geometry, camera.position, settings.relief);
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
                                    mediaAt(state_->scene, state_->geometry, capture.position, settings.relief));
  MIRRORBALL_TRY(film, state_->trace(rays, settings, traced.state, observer));
  traced.map = EnvironmentMap(capture.projection, cutIntoFaces(film.radiance(), capture.projection, size));
  return traced;
}

}  // namespace mirrorball
