#include "mirrorball/trace/light_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "formula/bodies.h"
#include "formula/color.h"
#include "formula/surface.h"
#include "mirrorball/rays/path_vertex.h"
#include "mirrorball/rays/surface_finder.h"
#include "mirrorball/trace/bsdf.h"
#include "mirrorball/trace/carried_light.h"
#include "mirrorball/trace/lamp_surface.h"
#include "mirrorball/trace/layered_bsdf.h"
#include "mirrorball/trace/path_on_ground.h"

namespace mirrorball {
namespace {

/// From this surface on, dark paths are ended at random (Russian roulette).
constexpr int kFirstRoulette = 4;

/// The colour of a surface: its base colour, or a metal's reflectance at normal incidence.
glm::vec3 albedoOf(const formula::Material& material) {
  return glm::mix(material.base_color, formula::metalReflectance(material, 1.0f), material.metallic);
}

/// A path on its way from the eye.
class Path {
 public:
  Path(const World& world, const Surroundings& surroundings, const Emitters& emitters, const TraceSettings& settings,
       SampleSequence& samples)
      : world_(world),
        surroundings_(surroundings),
        emitters_(emitters),
        settings_(settings),
        samples_(samples),
        finder_(world.scene, world.geometry, settings.relief, [&samples] { return samples.nextIndependent(); }),
        on_ground_(surroundings, settings.strategy, samples),
        wavelength_(settings.wavelength_nm / 1000.0f) {}

  PathLight follow(Ray ray);

 private:
  std::optional<Hit> firstHit(Ray& ray, float farthest, glm::vec3& share);
  glm::vec3 shareThatArrives(Ray ray, float distance);
  bool hasBeenInside(const Ray& ray) const;
  bool meetsSurfaces(const Ray& ray) const;
  float iorOf(const formula::Material& material) const;
  bool needsWavelength(const PathVertex& vertex) const;
  Refraction refractionAt(const PathVertex& vertex, float new_wavelength) const;
  PathVertex vertexAt(const Hit& hit, const Ray& ray) const;
  float shareOfEmitters(glm::vec3 place) const;
  Emitters::Choice sampleEmitter(glm::vec3 place, glm::vec2 u, float share);
  Emitters::Choice sampleLight(glm::vec3 place);
  glm::vec3 emittedAlong(Ray ray, const Emitters::Choice& chosen);
  float weightOfEmission(const PathVertex& vertex) const;
  void addEmittedToGround(Ray ray);
  glm::vec3 seeEnvironment(const Ray& ray);
  std::optional<float> groundBefore(const Ray& ray, const std::optional<Hit>& hit) const;
  static glm::vec4 shadowAlone(glm::vec3 ground, glm::vec3 unshadowed);
  glm::vec3 lightOfLamps(const PathVertex& vertex, const formula::Material& material, const Frame& frame);
  glm::vec3 coatNormal(const PathVertex& vertex) const;
  bool survivesRoulette();
  std::optional<Ray> scatter(const PathVertex& vertex, const Frame& frame);

  const World& world_;
  const Surroundings& surroundings_;
  const Emitters& emitters_;
  const TraceSettings& settings_;
  SampleSequence& samples_;
  SurfaceFinder finder_;
  CarriedLight light_;
  PathOnGround on_ground_;
  float wavelength_;        // µm, that of the settings, or once light is dispersed; 0: all are there
  int surfaces_ = 0;        // that were met before this one
  int inner_surfaces_ = 0;  // that were met from within bodies, and after them
};

/// SurfaceFinder::first.
std::optional<Hit> Path::firstHit(Ray& ray, float farthest, glm::vec3& share) {
  return finder_.first(ray, farthest, settings_.is_unoccluded && hasBeenInside(ray), share);
}

/// Whether a ray is, or was, in a body.
bool Path::hasBeenInside(const Ray& ray) const { return inner_surfaces_ > 0 || formula::fillingBody(ray.media) >= 0; }

/// Whether something may be in the way of a ray that leaves a surface.
bool Path::meetsSurfaces(const Ray& ray) const {
  return !settings_.is_unoccluded || (hasBeenInside(ray) && inner_surfaces_ < settings_.inner_bounces);
}

/// The share of light that gets from a distance along a ray to its origin.
glm::vec3 Path::shareThatArrives(Ray ray, float distance) {
  glm::vec3 share(1.0f);
  if (meetsSurfaces(ray) && firstHit(ray, distance, share)) return glm::vec3(0.0f);
  return share;
}

float Path::iorOf(const formula::Material& material) const { return formula::atWavelength(material, wavelength_).ior; }

PathVertex Path::vertexAt(const Hit& hit, const Ray& ray) const {
  return pathVertexAt(world_.scene, world_.world_from_normal, hit, ray, settings_.relief);
}

/// Whether light of each wavelength goes its own way from here on, and none has been chosen. Where light comes out of
/// the air, the choice can wait until it is refracted, so that what is reflected has no noise of colours; else a
/// channel's own critical angle would be in the way.
bool Path::needsWavelength(const PathVertex& vertex) const {
  if (wavelength_ > 0.0f || !vertex.is_body) return false;
  const formula::Material& material = vertex.point.material;
  const bool is_from_air = vertex.is_outside && !vertex.beyond && material.ior >= 1.0f;
  return (material.dispersion > 0.0f && !is_from_air) || (vertex.beyond && vertex.beyond->dispersion > 0.0f);
}

/// How light goes on that is refracted, and is of that wavelength from then on.
Refraction Path::refractionAt(const PathVertex& vertex, float new_wavelength) const {
  const formula::Material& material = vertex.point.material;
  Refraction refraction{.ior = iorOf(material) / iorBeyond(vertex, wavelength_),
                        .is_thin = vertex.surface->thin_walled};
  if (new_wavelength > 0.0f) {  // which waits for light out of the air alone
    refraction.ior = formula::atWavelength(material, new_wavelength).ior;
    refraction.weight = formula::shareOfWavelength(new_wavelength);
  }
  return refraction;
}

/// How many light samples look for emitters: none where the next surface's light is not asked for any more.
float Path::shareOfEmitters(glm::vec3 place) const {
  return surfaces_ + 1 < settings_.bounces ? emitters_.share(place) : 0.0f;
}

/// A place that shines, chosen by that share of the light samples.
Emitters::Choice Path::sampleEmitter(glm::vec3 place, glm::vec2 u, float share) {
  Emitters::Choice choice = emitters_.chosen(place, {samples_.nextIndependent(), u});
  choice.sample.pdf *= share;
  choice.sample.is_weighed = settings_.strategy == LightStrategy::both;
  return choice;
}

/// A direction that the environment chooses, seen from a place, or to an emitter.
Emitters::Choice Path::sampleLight(glm::vec3 place) {
  glm::vec2 u = samples_.next();
  if (settings_.strategy == LightStrategy::surface) return {};
  const float share = light_.emitter_share = shareOfEmitters(place);
  if (u.x < share) return sampleEmitter(place, {u.x / share, u.y}, share);
  if (share > 0.0f) u.x = std::min((u.x - share) / (1.0f - share), 0x1.fffffep-1f);
  Emitters::Choice choice{surroundings_.sample(place, u)};
  choice.sample.pdf *= 1.0f - share;
  choice.sample.is_weighed = settings_.strategy == LightStrategy::both;
  return choice;
}

/// The light of a chosen emitter that gets to a ray's origin.
glm::vec3 Path::emittedAlong(Ray ray, const Emitters::Choice& chosen) {
  // Not the sample's direction: the ray begins beside the place, and would pass a small triangle.
  const glm::vec3 towards = chosen.position - ray.origin;
  const float distance = glm::length(towards);
  if (!(distance > 0.0f)) return glm::vec3(0.0f);
  ray.direction = towards / distance;
  constexpr float kRounding = 1.001f;  // of the distance
  glm::vec3 share(1.0f);
  const auto hit = firstHit(ray, kRounding * distance, share);
  const bool is_met = hit && hit->instance == chosen.instance && hit->triangle == chosen.triangle;
  return is_met && !groundBefore(ray, hit) ? share * vertexAt(*hit, ray).point.material.emission : glm::vec3(0.0f);
}

/// How much the light of a surface counts that the path has met.
float Path::weightOfEmission(const PathVertex& vertex) const {
  if (light_.emitter_share <= 0.0f || light_.pdf <= 0.0f) return 1.0f;
  const float pdf = light_.emitter_share * emitters_.pdf(vertex.hit, vertex.arriving.direction);
  return pdf > 0.0f ? light_.weightBeside(pdf, settings_.strategy) : 1.0f;
}

/// Adds the light of an emitter to that of matt ground.
///
/// ray    along which the path goes on from there
void Path::addEmittedToGround(Ray ray) {
  const bool is_matt = light_.pdf > 0.0f;
  if (!is_matt || shareOfEmitters(ray.origin) <= 0.0f) return;
  light_.emitter_share = 1.0f;
  const Emitters::Choice emitter = sampleEmitter(ray.origin, samples_.next(), 1.0f);
  ray.direction = emitter.sample.direction;
  if (emitter.sample.pdf <= 0.0f || ray.direction.y <= 0.0f) return;
  const float cosine = ray.direction.y / formula::kPi;
  light_.sum += light_.throughput * emittedAlong(ray, emitter) *
                (lightWeight(emitter.sample, cosine) * cosine / emitter.sample.pdf);
}

/// The normal of a clear coat, on the side that the ray comes from.
glm::vec3 Path::coatNormal(const PathVertex& vertex) const {
  const glm::vec3 outwards = vertex.point.coat_normal;
  return formula::facingNormal(vertex.is_outside ? outwards : -outwards, vertex.arriving.direction);
}

/// Phong's point lights and the model's own, as far as nothing is in their way. They light the outside of bodies.
glm::vec3 Path::lightOfLamps(const PathVertex& vertex, const formula::Material& material, const Frame& frame) {
  const std::vector<ModelLight>& of_model = world_.scene.lights;
  const bool is_inside = vertex.is_body && !vertex.is_outside;
  if ((settings_.lights.empty() && of_model.empty()) || is_inside) return glm::vec3(0.0f);
  const glm::vec3 ray = vertex.arriving.direction;
  const LampSurface surface(material, frame, material.clearcoat > 0.0f ? coatNormal(vertex) : frame.n, ray);
  const glm::vec3 place = vertex.arriving.origin + vertex.hit.distance * ray;
  glm::vec3 light(0.0f);
  const auto add = [&](const formula::Lamp& lamp, float factor) {
    const glm::vec3 shown = surface.shownOf(lamp, place, factor);
    if (shown == glm::vec3(0.0f)) return;
    const bool is_far = lamp.kind == formula::kLampDirectional;
    const float distance = is_far ? INFINITY : glm::distance(lamp.position, place);
    light += shown * shareThatArrives(leavingRay(vertex, formula::towardsLamp(lamp, place)), distance);
  };
  for (const PointLight& lamp : settings_.lights) add(lampOf(lamp, world_.scene.origin), 1.0f);
  for (const ModelLight& lamp : of_model) add(lamp, settings_.light_intensity);
  return light;
}

/// Ends dark paths at random; the others count for those that are ended.
bool Path::survivesRoulette() {
  const glm::vec3 carried = glm::abs(light_.throughput);  // of a wavelength, some may be negative
  const float survives = std::min(std::max({carried.x, carried.y, carried.z}), 1.0f);
  if (survives <= 0.0f || samples_.nextIndependent() >= survives) return false;
  light_.throughput /= survives;
  return true;
}

/// Adds the light that reaches the surface directly.
///
/// returns  how the path goes on, if it does
std::optional<Ray> Path::scatter(const PathVertex& vertex, const Frame& frame) {
  const bool disperses = vertex.is_body && vertex.point.material.dispersion > 0.0f && wavelength_ == 0.0f;
  float new_wavelength = disperses ? formula::sampleWavelength(samples_.next().x) : 0.0f;
  if (needsWavelength(vertex)) {
    wavelength_ = disperses ? new_wavelength : formula::sampleWavelength(samples_.next().x);
    light_.throughput *= formula::shareOfWavelength(wavelength_);
    new_wavelength = 0.0f;
  }
  const formula::Material material = materialAgainstBeyond(vertex, wavelength_);
  LayeredBsdf bsdf(material, refractionAt(vertex, new_wavelength), frame);
  if (vertex.is_outside || !vertex.is_body) {
    bsdf.addSheen(material);
    if (material.clearcoat > 0.0f) bsdf.addCoat(material, Frame(coatNormal(vertex)));
  }
  const glm::vec3 place = vertex.arriving.origin + vertex.hit.distance * vertex.arriving.direction;
  const glm::vec3 emission = weightOfEmission(vertex) * material.emission;
  light_.emitter_share = 0.0f;
  const Emitters::Choice light = bsdf.takesLightSamples() ? sampleLight(place) : Emitters::Choice();
  const LayeredScattering scattered = bsdf.scatter(-vertex.arriving.direction, light.sample, samples_);
  const auto& [direct, next, enters] = scattered.scattering;
  if (direct != glm::vec3(0.0f)) {
    const Ray towards = leavingRay(vertex, light.sample.direction);
    light_.sum +=
        light_.throughput * direct *
        (light.is_emitter ? emittedAlong(towards, light)
                          : shareThatArrives(towards, INFINITY) * surroundings_.radiance(place, towards.direction));
  }
  light_.sum += light_.throughput * (lightOfLamps(vertex, material, frame) + scattered.share_below * emission);
  if (!next) return std::nullopt;
  if (next->is_refracted && new_wavelength > 0.0f) wavelength_ = new_wavelength;
  light_.throughput *= next->weight;
  light_.pdf = next->pdf;
  return leavingRay(vertex, glm::normalize(next->direction));
}

/// Adds the light of the environment along a ray.
///
/// returns  that light
glm::vec3 Path::seeEnvironment(const Ray& ray) {
  const glm::vec3 origin = ray.from ? ray.origin : surroundings_.originOfEye(ray.origin, ray.direction);
  const SeenLight seen = light_.pdf > 0.0f ? surroundings_.seen(origin, ray.direction)
                                           : SeenLight{surroundings_.radiance(origin, ray.direction)};
  const float weight = light_.weightBeside((1.0f - light_.emitter_share) * seen.pdf, settings_.strategy);
  light_.sum += light_.throughput * weight * seen.radiance;
  return seen.radiance;
}

/// Where a ray meets the ground of the environment before anything else.
std::optional<float> Path::groundBefore(const Ray& ray, const std::optional<Hit>& hit) const {
  if (settings_.is_unoccluded) return std::nullopt;
  const auto distance = surroundings_.distanceToGround(ray.origin, ray.direction);
  return distance && !(hit && hit->distance <= *distance) ? distance : std::nullopt;
}

/// What is laid over a page in the place of the ground: it takes as much of it as of the ground's light.
glm::vec4 Path::shadowAlone(glm::vec3 ground, glm::vec3 unshadowed) {
  const float lit = formula::luminance(unshadowed);
  return {0.0f, 0.0f, 0.0f, lit > 0.0f ? 1.0f - formula::luminance(ground) / lit : 0.0f};
}

PathLight Path::follow(Ray ray) {
  PathLight result;
  std::optional<glm::vec3> unshadowed;  // the light of the ground that is left out, without the scene
  const auto ended = [&] {
    result.radiance = unshadowed ? shadowAlone(light_.sum, *unshadowed) : glm::vec4(light_.sum, 1.0f);
    return result;
  };
  const auto arrives = [this](const Ray& towards) { return shareThatArrives(towards, INFINITY); };
  for (;; ++surfaces_) {
    const bool meets = surfaces_ == 0 || meetsSurfaces(ray);
    if (hasBeenInside(ray)) ++inner_surfaces_;
    const auto hit = meets ? firstHit(ray, INFINITY, light_.throughput) : std::nullopt;
    if (!on_ground_.goesOn(ray, hit.has_value(), arrives, light_)) return ended();
    const auto ground = groundBefore(ray, hit);
    if (!hit || ground) {
      const bool is_left_out = surfaces_ == 0 && !settings_.shows_environment;
      if (is_left_out && !ground) {
        if (settings_.background) result.radiance = glm::vec4(light_.throughput * *settings_.background, 1.0f);
        return result;
      }
      const glm::vec3 seen = seeEnvironment(ray);
      if (is_left_out) unshadowed = seen;
      if (!ground || surfaces_ == settings_.bounces) return ended();
      ray = on_ground_.scatter(ray, *ground, seen, arrives, light_);
      addEmittedToGround(ray);
      continue;
    }
    if (surfaces_ == settings_.bounces && !settings_.is_unoccluded) return ended();
    const PathVertex vertex = vertexAt(*hit, ray);
    const Frame frame = surfaceFrameOf(vertex);
    if (surfaces_ == 0) {
      result.albedo = albedoOf(vertex.point.material);
      result.normal = vertex.is_outside || !vertex.is_body ? frame.n : -frame.n;
    }
    if (vertex.surface->unlit) {
      light_.sum += light_.throughput * weightOfEmission(vertex) * vertex.point.material.emission;
      return ended();
    }
    const auto next = scatter(vertex, frame);
    if (!next || (surfaces_ >= kFirstRoulette && !survivesRoulette())) return ended();
    ray = *next;
  }
}

}  // namespace

PathLight lightAlong(const World& world, const Surroundings& surroundings, const Emitters& emitters,
                     const TraceSettings& settings, Ray ray, SampleSequence& samples) {
  return Path(world, surroundings, emitters, settings, samples).follow(ray);
}

}  // namespace mirrorball
