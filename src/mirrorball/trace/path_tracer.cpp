#include "mirrorball/trace/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>

#include "formula/tangent.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/trace/bsdf.h"
#include "mirrorball/trace/film.h"
#include "mirrorball/trace/geometry.h"
#include "mirrorball/trace/light_sampler.h"
#include "mirrorball/trace/sample_sequence.h"
#include "mirrorball/trace/surface_point.h"

namespace mirrorball {
namespace {

/// The next surface after so many cut-away or transparent ones is taken as solid.
constexpr int kMaxPassed = 512;
/// The most paths that a pass adds: what an interruption, or a limit of the time, may cost.
constexpr int kLargestPass = 128;
/// From this surface on, dark paths are ended at random (Russian roulette).
constexpr int kFirstRoulette = 4;

struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;
  /// The triangle that it leaves, which a plane cannot meet again.
  std::optional<Hit> from = {};
  /// Whether it passes the backs of surfaces that have only a front: as the renderer's eye does, and as light must that
  /// a smooth normal sends below its flat triangle.
  bool passes_backs = true;
};

/// The frame of a surface: +Z is its normal.
struct Frame {
  explicit Frame(glm::vec3 normal) : n(normal), t(formula::anyTangent(normal)), b(glm::cross(normal, t)) {}
  glm::vec3 toLocal(glm::vec3 w) const { return {glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)}; }
  glm::vec3 toWorld(glm::vec3 w) const { return w.x * t + w.y * b + w.z * n; }

  glm::vec3 n, t, b;
};

/// Whether a material fills what its triangles enclose; else they are all that there is.
bool isBody(const Material& material) { return material.transmission > 0.0f; }

/// The ray that leaves a surface where another one has met it, from a point so far beside the surface as rounding may
/// have put it on the wrong side.
Ray leaving(const Hit& hit, const Ray& arriving, glm::vec3 direction, bool is_outside, bool is_body) {
  const glm::vec3 place = arriving.origin + hit.distance * arriving.direction;
  const glm::vec3 magnitude = glm::abs(place);
  const float step = 4e-6f * std::max({magnitude.x, magnitude.y, magnitude.z, hit.distance});
  const float above = glm::dot(direction, hit.geometric_normal);
  const bool is_below = (above < 0.0f) == is_outside;
  return {place + hit.geometric_normal * (above >= 0.0f ? step : -step), direction, hit, is_below && !is_body};
}

/// The rays of a camera.
class RayMaker {
 public:
  RayMaker(const Camera& camera, glm::ivec2 size)
      : camera_(camera),
        size_(size),
        // Without the camera's place, directions are exact however far away from the origin it stands.
        directions_(glm::inverse(camera.clip_from_view * glm::mat4(glm::mat3(camera.view_from_world)))),
        places_(glm::inverse(camera.clip_from_view * camera.view_from_world)) {}

  /// pixel    from the top left corner
  Ray through(glm::vec2 pixel) const {
    const glm::vec2 ndc(2.0f * pixel.x / float(size_.x) - 1.0f, 1.0f - 2.0f * pixel.y / float(size_.y));
    if (camera_.orthographic) {
      const glm::vec4 origin = places_ * glm::vec4(ndc, -1.0f, 1.0f);
      return {glm::vec3(origin) / origin.w, camera_.forward};
    }
    const glm::vec4 from = directions_ * glm::vec4(ndc, -1.0f, 1.0f);
    const glm::vec4 to = directions_ * glm::vec4(ndc, 1.0f, 1.0f);
    return {camera_.position, glm::normalize(glm::vec3(to) / to.w - glm::vec3(from) / from.w)};
  }

 private:
  Camera camera_;
  glm::ivec2 size_;
  glm::mat4 directions_;
  glm::mat4 places_;
};

}  // namespace

struct PathTracer::State {
  Scene scene;
  Environment environment;
  LightSampler lights;
  Geometry geometry;

  std::optional<Hit> firstHit(const Ray& ray, SampleSequence& samples) const;
  glm::vec4 radiance(Ray ray, const TraceSettings& settings, SampleSequence& samples) const;
  bool passes(const Hit& hit, const Ray& ray, SampleSequence& samples) const;
  bool drawPass(const RayMaker& rays, const TraceSettings& settings, int first, int count, Film& pass,
                const ProgressFunction& progress) const;
};

PathTracer::PathTracer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

const Scene& PathTracer::scene() const { return state_->scene; }

Result<PathTracer> PathTracer::make(Scene scene, Environment environment, const ProgressFunction& progress) {
  if (EnvironmentMap* map = environment.map()) raiseNegativeLight(*map);
  MIRRORBALL_TRY(lights, LightSampler::make(environment, progress));
  MIRRORBALL_TRY(geometry, Geometry::make(scene));
  return PathTracer(std::unique_ptr<State>(
      new State{std::move(scene), std::move(environment), std::move(lights), std::move(geometry)}));
}

/// Whether a ray goes on as if a triangle were not there: it is the one that it leaves, it is cut away, it lets this
/// ray through, or it is the back of a surface that has only a front.
bool PathTracer::State::passes(const Hit& hit, const Ray& ray, SampleSequence& samples) const {
  if (ray.from && ray.from->instance == hit.instance && ray.from->triangle == hit.triangle) return true;
  const Material& material = materialAt(scene, hit);
  const bool has_back = material.double_sided || isBody(material) || !ray.passes_backs;
  if (!has_back && glm::dot(ray.direction, hit.geometric_normal) > 0.0f) return true;
  const float opacity = opacityAt(scene, hit);
  return opacity <= 0.0f || (opacity < 1.0f && samples.nextIndependent() >= opacity);
}

std::optional<Hit> PathTracer::State::firstHit(const Ray& ray, SampleSequence& samples) const {
  float nearest = 0.0f;
  for (int passed = 0;; ++passed) {
    const auto hit = geometry.hit(ray.origin, ray.direction, nearest);
    if (!hit || passed == kMaxPassed || !passes(*hit, ray, samples)) return hit;
    nearest = std::nextafter(hit->distance * (1.0f + 1e-6f), INFINITY);
  }
}

glm::vec4 PathTracer::State::radiance(Ray ray, const TraceSettings& settings, SampleSequence& samples) const {
  glm::vec3 sum(0.0f);
  glm::vec3 share(1.0f);
  float pdf = 0.0f;  // of the ray's direction; 0: nothing else could have chosen it
  for (int surfaces = 0;; ++surfaces) {
    const bool meets = surfaces == 0 || !settings.is_unoccluded;
    const auto hit = meets ? firstHit(ray, samples) : std::nullopt;
    if (!hit) {
      if (surfaces == 0 && !settings.shows_environment) return glm::vec4(0.0f);
      // What of this light was chosen directly counts there.
      const glm::vec3 seen = glm::normalize(settings.environment_from_world * ray.direction);
      const float weight = pdf > 0.0f ? balanced(pdf, lights.pdf(seen)) : 1.0f;
      return glm::vec4(sum + share * (weight * settings.environment_intensity) * environment.radiance(seen), 1.0f);
    }
    if (surfaces == settings.bounces) return glm::vec4(sum, 1.0f);
    const SurfacePoint point = surfacePointAt(scene, *hit);
    const bool is_body = isBody(materialAt(scene, *hit));
    const bool is_outside = glm::dot(ray.direction, hit->geometric_normal) < 0.0f;
    // A thin surface is the same from both sides; a body has an inside.
    glm::vec3 normal = is_outside || is_body ? point.normal : -point.normal;
    glm::vec3 v = -ray.direction;
    // A smooth normal may turn away from the eye that sees its triangle: it is bent back.
    const float facing = is_outside || !is_body ? 1.0f : -1.0f;
    if (const float cosine = facing * glm::dot(v, normal); cosine < 1e-3f)
      normal = glm::normalize(normal + facing * v * (1e-3f - cosine));
    const Frame frame(normal);
    v = frame.toLocal(v);
    const LightSample lamp = lights.sample(samples.next());
    const glm::vec3 towards = glm::transpose(settings.environment_from_world) * lamp.direction;
    const auto [offered, next] = Bsdf(point.material).scatter(v, {frame.toLocal(towards), lamp.pdf}, samples);
    sum += share * point.material.emission;
    const auto rayTo = [&](glm::vec3 direction) { return leaving(*hit, ray, direction, is_outside, is_body); };
    if (offered != glm::vec3(0.0f) && (settings.is_unoccluded || !firstHit(rayTo(towards), samples)))
      sum += share * offered * settings.environment_intensity * environment.radiance(lamp.direction);
    if (!next) return glm::vec4(sum, 1.0f);
    share *= next->weight;
    pdf = next->pdf;
    if (surfaces >= kFirstRoulette) {
      const float survives = std::min(std::max({share.x, share.y, share.z}), 1.0f);
      if (survives <= 0.0f || samples.nextIndependent() >= survives) return glm::vec4(sum, 1.0f);
      share /= survives;
    }
    ray = rayTo(glm::normalize(frame.toWorld(next->direction)));
  }
}

/// returns  whether the pass is whole
bool PathTracer::State::drawPass(const RayMaker& rays, const TraceSettings& settings, int first, int count, Film& pass,
                                 const ProgressFunction& progress) const {
  std::atomic<bool> is_stopped = false;
  const auto rows = static_cast<std::size_t>(settings.size.y);
  const std::size_t pixels = rows * static_cast<std::size_t>(settings.size.x);
  std::atomic<std::size_t> paths_done = pixels * std::size_t(first);
  const bool stops_itself = settings.noise > 0.0f || settings.time_s > 0.0f;
  const std::size_t paths_in_all = pixels * std::size_t(stops_itself ? first + count : settings.samples);
  parallelFor(rows, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !is_stopped; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < settings.size.x && !is_stopped; ++x) {
        PixelSums& sums = pass.at(x, y);
        sums = {};
        for (int index = first; index < first + count; ++index) {
          SampleSequence samples(static_cast<std::uint32_t>(y * settings.size.x + x),
                                 static_cast<std::uint32_t>(index));
          const glm::vec4 light = radiance(rays.through(glm::vec2(x, y) + samples.next()), settings, samples);
          if (!std::isfinite(light.x + light.y + light.z)) {
            ++sums.lost;
            continue;
          }
          sums.light += glm::dvec4(light);
          sums.squares += glm::dvec3(light) * glm::dvec3(light);
        }
        paths_done += std::size_t(count);
        if (progress && !progress(paths_done, paths_in_all)) is_stopped = true;
      }
    }
  });
  return !is_stopped;
}

Result<TracedPicture> PathTracer::render(const Camera& camera, const TraceSettings& settings,
                                         const ProgressFunction& progress) const {
  const auto start = std::chrono::steady_clock::now();
  const glm::ivec2 size = settings.size;
  const std::uint64_t pixels = std::uint64_t(size.x) * std::uint64_t(size.y);
  MIRRORBALL_TRY_VOID(withName("the picture", checkMemory(pixels * (2 * sizeof(PixelSums) + 4 * sizeof(float)))));
  const RayMaker rays(camera, size);
  Film film(size), pass(size);
  TracedPicture picture;
  const int max_samples = std::max(settings.samples, 1);
  while (film.samples() < max_samples) {
    const int done = film.samples();
    const int count = std::min({std::max(done, 1), kLargestPass, max_samples - done});
    if (!state_->drawPass(rays, settings, done, count, pass, progress)) {
      picture.is_interrupted = true;
      break;
    }
    film.addPass(pass, count);
    const std::chrono::duration<float> elapsed = std::chrono::steady_clock::now() - start;
    if (settings.time_s > 0.0f && elapsed.count() >= settings.time_s) break;
    // The error of few paths is not known well enough to stop by it.
    constexpr int kMinSamples = 16;
    if (settings.noise > 0.0f && film.samples() >= kMinSamples && film.noise(settings.display) <= settings.noise) break;
  }
  if (film.samples() == 0)
    return fail(ErrorCode::interrupted, "interrupted before the first pass; nothing was written");
  picture.radiance = film.radiance();
  picture.samples = film.samples();
  picture.noise = film.noise(settings.display);
  picture.lost_paths = film.lost();
  return picture;
}

}  // namespace mirrorball
