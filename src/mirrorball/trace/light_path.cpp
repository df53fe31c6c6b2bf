#include "mirrorball/trace/light_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "formula/bodies.h"
#include "formula/color.h"
#include "formula/surface.h"
#include "formula/tangent.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/bodies/surrounding_media.h"
#include "mirrorball/trace/bsdf.h"
#include "mirrorball/trace/carried_light.h"
#include "mirrorball/trace/lamp_surface.h"
#include "mirrorball/trace/layered_bsdf.h"
#include "mirrorball/trace/path_on_ground.h"
#include "mirrorball/trace/surface_finder.h"

namespace mirrorball {
namespace {

/// From this surface on, dark paths are ended at random (Russian roulette).
constexpr int kFirstRoulette = 4;

/// The colour of a surface: its base colour, or a metal's reflectance at normal incidence.
glm::vec3 albedoOf(const formula::Material& material) {
  return glm::mix(material.base_color, formula::metalReflectance(material, 1.0f), material.metallic);
}

/// The point at which a ray leaves a surface, so far beside it as rounding may have put it on the wrong side.
glm::vec3 besideHit(const Ray& arriving, const Hit& hit, bool goes_out) {
  const glm::vec3 towards = goes_out ? hit.geometric_normal : -hit.geometric_normal;
  if (!hit.relief)
    return formula::besideSurface(arriving.origin + hit.distance * arriving.direction, hit.distance, towards);
  // Above and below are told apart by heights.
  constexpr float kHeights = 1e-3f;
  return formula::besideSurface(hit.relief->position, hit.distance, towards) +
         (goes_out ? kHeights : -kHeights) * hit.relief->up;
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
        finder_(world, settings.relief, samples),
        on_ground_(surroundings, settings.strategy, samples),
        wavelength_(settings.wavelength_nm / 1000.0f) {}

  PathLight follow(Ray ray);

 private:
  /// Where it has met a surface.
  struct Vertex {
    Hit hit;
    Ray arriving;
    const Material& surface;
    SurfacePoint point;
    bool is_body;
    bool is_outside;
    const Material* beyond;  ///< the body on its other side: outside of a body, and on both sides of other surfaces
  };

  std::optional<Hit> firstHit(Ray& ray, float farthest, glm::vec3& share);
  glm::vec3 shareThatArrives(Ray ray, float distance);
  bool hasBeenInside(const Ray& ray) const;
  bool meetsSurfaces(const Ray& ray) const;
  float iorOf(const formula::Material& material) const;
  bool needsWavelength(const Vertex& vertex) const;
  Refraction refractionAt(const Vertex& vertex, float new_wavelength) const;
  Vertex vertexAt(const Hit& hit, const Ray& ray) const;
  float iorBeyond(const Vertex& vertex) const;
  formula::Material materialAt(const Vertex& vertex) const;
  float shareOfEmitters(glm::vec3 place) const;
  Emitters::Choice sampleEmitter(glm::vec3 place, glm::vec2 u, float share);
  Emitters::Choice sampleLight(glm::vec3 place);
  glm::vec3 emittedAlong(Ray ray, const Emitters::Choice& chosen);
  float weightOfEmission(const Vertex& vertex) const;
  void addEmittedToGround(Ray ray);
  glm::vec3 seeEnvironment(const Ray& ray);
  std::optional<float> groundBefore(const Ray& ray, const std::optional<Hit>& hit) const;
  glm::vec3 lightOfLamps(const Vertex& vertex, const formula::Material& material, const Frame& frame);
  glm::vec3 coatNormal(const Vertex& vertex) const;
  Ray leaving(const Vertex& vertex, glm::vec3 direction) const;
  bool survivesRoulette();
  std::optional<Ray> scatter(const Vertex& vertex, glm::vec3 normal);

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

Path::Vertex Path::vertexAt(const Hit& hit, const Ray& ray) const {
  const Scene& scene = world_.scene;
  const Material& material = materialOf(scene, hit.instance);
  const bool is_outside = glm::dot(ray.direction, hit.geometric_normal) < 0.0f;
  const int other =
      formula::fillingBody(is_outside ? ray.media : formula::left(ray.media, static_cast<int>(hit.instance)));
  return {hit,
          ray,
          material,
          surfacePointAt(scene, world_.world_from_normal[hit.instance], hit, settings_.relief),
          isBody(material),
          is_outside,
          other >= 0 ? &materialOf(scene, std::size_t(other)) : nullptr};
}

float Path::iorBeyond(const Vertex& vertex) const { return vertex.beyond ? iorOf(*vertex.beyond) : 1.0f; }

/// Whether light of each wavelength goes its own way from here on, and none has been chosen. Where light comes out of
/// the air, the choice can wait until it is refracted, so that what is reflected has no noise of colours; else a
/// channel's own critical angle would be in the way.
bool Path::needsWavelength(const Vertex& vertex) const {
  if (wavelength_ > 0.0f || !vertex.is_body) return false;
  const formula::Material& material = vertex.point.material;
  const bool is_from_air = vertex.is_outside && !vertex.beyond && material.ior >= 1.0f;
  return (material.dispersion > 0.0f && !is_from_air) || (vertex.beyond && vertex.beyond->dispersion > 0.0f);
}

/// The material's numbers, its indices relative to what is on the other side.
formula::Material Path::materialAt(const Vertex& vertex) const {
  formula::Material material = formula::atWavelength(vertex.point.material, wavelength_);
  const float beyond = iorBeyond(vertex);
  material.ior /= beyond;
  material.conductor_n /= beyond;
  material.conductor_k /= beyond;
  if (vertex.beyond) material.dispersion = 0.0f;
  return material;
}

/// How light goes on that is refracted, and is of that wavelength from then on.
Refraction Path::refractionAt(const Vertex& vertex, float new_wavelength) const {
  const formula::Material& material = vertex.point.material;
  Refraction refraction{.ior = iorOf(material) / iorBeyond(vertex), .is_thin = vertex.surface.thin_walled};
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
float Path::weightOfEmission(const Vertex& vertex) const {
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
glm::vec3 Path::coatNormal(const Vertex& vertex) const {
  const glm::vec3 outwards = vertex.point.coat_normal;
  return formula::facingNormal(vertex.is_outside ? outwards : -outwards, vertex.arriving.direction);
}

/// Phong's point lights and the model's own, as far as nothing is in their way. They light the outside of bodies.
glm::vec3 Path::lightOfLamps(const Vertex& vertex, const formula::Material& material, const Frame& frame) {
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
    light += shown * shareThatArrives(leaving(vertex, formula::towardsLamp(lamp, place)), distance);
  };
  for (const PointLight& lamp : settings_.lights) add(lampOf(lamp), 1.0f);
  for (const ModelLight& lamp : of_model) add(lamp, settings_.light_intensity);
  return light;
}

/// The ray that leaves a surface.
Ray Path::leaving(const Vertex& vertex, glm::vec3 direction) const {
  const Ray& arriving = vertex.arriving;
  const Hit& hit = vertex.hit;
  const bool goes_out = glm::dot(direction, hit.geometric_normal) >= 0.0f;
  const bool crosses = goes_out != vertex.is_outside;
  Ray ray{.origin = besideHit(arriving, hit, goes_out),
          .direction = direction,
          .from = hit,
          .passes_backs = crosses && vertex.surface.transmission <= 0.0f,
          .media = arriving.media};
  const int body = static_cast<int>(hit.instance);
  if (crosses && vertex.is_body)
    ray.media = goes_out ? formula::left(ray.media, body) : formula::entered(ray.media, body, vertex.surface.priority);
  return ray;
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
std::optional<Ray> Path::scatter(const Vertex& vertex, glm::vec3 normal) {
  const bool disperses = vertex.is_body && vertex.point.material.dispersion > 0.0f && wavelength_ == 0.0f;
  float new_wavelength = disperses ? formula::sampleWavelength(samples_.next().x) : 0.0f;
  if (needsWavelength(vertex)) {
    wavelength_ = disperses ? new_wavelength : formula::sampleWavelength(samples_.next().x);
    light_.throughput *= formula::shareOfWavelength(wavelength_);
    new_wavelength = 0.0f;
  }
  const formula::Material material = materialAt(vertex);
  glm::vec2 stretched = vertex.point.stretched;
  if (!vertex.is_outside && !vertex.is_body) stretched.y = -stretched.y;  // from behind, the normal is turned round
  const Frame frame(normal, formula::turnedTangent(vertex.point.tangent, normal, stretched));
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
    const Ray towards = leaving(vertex, light.sample.direction);
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
  return leaving(vertex, glm::normalize(next->direction));
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

PathLight Path::follow(Ray ray) {
  PathLight result;
  const auto ended = [&] {
    result.radiance = glm::vec4(light_.sum, 1.0f);
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
      if (surfaces_ == 0 && !settings_.shows_environment) {
        if (settings_.background) result.radiance = glm::vec4(light_.throughput * *settings_.background, 1.0f);
        return result;
      }
      const glm::vec3 seen = seeEnvironment(ray);
      if (!ground || surfaces_ == settings_.bounces) return ended();
      ray = on_ground_.scatter(ray, *ground, seen, arrives, light_);
      addEmittedToGround(ray);
      continue;
    }
    if (surfaces_ == settings_.bounces && !settings_.is_unoccluded) return ended();
    const Vertex vertex = vertexAt(*hit, ray);
    // A thin surface is the same from both sides; a body has an inside.
    const float facing = vertex.is_outside || !vertex.is_body ? 1.0f : -1.0f;
    glm::vec3 normal = vertex.is_outside || vertex.is_body ? vertex.point.normal : -vertex.point.normal;
    normal = facing * formula::facingNormal(facing * normal, ray.direction);
    if (surfaces_ == 0) {
      result.albedo = albedoOf(vertex.point.material);
      result.normal = facing * normal;
    }
    if (vertex.surface.unlit) {
      light_.sum += light_.throughput * weightOfEmission(vertex) * vertex.point.material.emission;
      return ended();
    }
    const auto next = scatter(vertex, normal);
    if (!next || (surfaces_ >= kFirstRoulette && !survivesRoulette())) return ended();
    ray = *next;
  }
}

}  // namespace

PathLight lightAlong(const World& world, const Surroundings& surroundings, const Emitters& emitters,
                     const TraceSettings& settings, Ray ray, SampleSequence& samples) {
  return Path(world, surroundings, emitters, settings, samples).follow(ray);
}

formula::Media mediaAt(const World& world, glm::vec3 point, ReliefKind relief) {
  return surroundingMedia(
      world.scene, point, [&](glm::vec3 origin, glm::vec3 direction, float nearest) -> std::optional<Crossing> {
        const auto hit = world.geometry.hit(origin, direction, nearest, surfacesOf(relief));
        if (!hit) return std::nullopt;
        return Crossing{hit->distance, hit->instance, glm::dot(direction, hit->geometric_normal) < 0.0f};
      });
}

}  // namespace mirrorball
