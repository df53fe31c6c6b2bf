#include "mirrorball/rays/scene_occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/constants.h"
#include "formula/surface.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/emissive_triangles.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/hiding.h"
#include "mirrorball/rays/occlusion_smoothing.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/rays/vertex_materials.h"
#include "mirrorball/rays/vertex_patches.h"
#include "mirrorball/rays/vertex_places.h"

namespace mirrorball {
namespace {

/// In all, and from each patch. Of the fewest, those of a patch and of its neighbours together leave little noise.
constexpr std::size_t kRaysInAll = 1'000'000;
constexpr std::size_t kFewestRays = 16;
constexpr std::size_t kMeanRays = 256;
constexpr std::size_t kMostRays = 1024;
constexpr std::size_t kMostPatches = kRaysInAll / kFewestRays;
constexpr std::uint32_t kOpen = ~std::uint32_t{0};

/// How many places that shine are chosen from each vertex, beside so many rays.
std::uint32_t placesOfEmission(std::size_t rays) {
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(rays / 2, 4, 32));
}

/// The most rays from so many patches.
std::size_t raysOfAll(std::size_t patches) { return std::min(kRaysInAll, patches * kMeanRays); }

/// How many rays each patch has, by its area: what is wrong with a vertex is seen as far as its triangles reach.
std::vector<std::size_t> raysByArea(const std::vector<double>& areas) {
  const std::size_t all = raysOfAll(areas.size());
  const double largest = areas.empty() ? 0.0 : *std::max_element(areas.begin(), areas.end());
  const auto rays = [&](double area, double of_largest) {
    const double share = largest > 0.0 ? area / largest : 1.0;
    return std::clamp(static_cast<std::size_t>(share * of_largest), kFewestRays, kMostRays);
  };
  // As many for each area as all together allow: the logarithm of what the largest would have without a limit.
  double enough = 0.0, too_many = 64.0;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (enough + too_many);
    const std::size_t needed =
        std::accumulate(areas.begin(), areas.end(), std::size_t{0},
                        [&](std::size_t sum, double area) { return sum + rays(area, std::exp2(middle)); });
    (needed <= all ? enough : too_many) = middle;
  }
  std::vector<std::size_t> found;
  for (const double area : areas) found.push_back(rays(area, std::exp2(enough)));
  return found;
}

/// A corner of a triangle by its vertex.
struct PatchCorner {
  std::uint32_t vertex = 0;
  std::size_t triangle = 0;  ///< of those around the vertex
};

/// What hides the environment on one ray: the patch of the nearest vertex there; kOpen: nothing does.
struct Hider {
  std::uint32_t patch = kOpen;
  std::uint32_t triangle = 0;  ///< counted through all instances
};

/// How much a surface reflects of even light, all together: of a dielectric, its colour below what Schlick's term
/// reflects on average, which is f0 + (1 − f0) / 21.
glm::vec3 albedoOf(const formula::Material& m) {
  const glm::vec3 f0 = formula::smoothDielectric(m, 1.0f);
  const glm::vec3 reflects = f0 + (m.specular - f0) / 21.0f;
  const glm::vec3 dielectric = reflects + (1.0f - reflects) * m.base_color * (1.0f - m.transmission);
  return glm::clamp(glm::mix(dielectric, formula::metalReflectance(m, 1.0f), m.metallic), 0.0f, 1.0f);
}

float greatest(glm::vec3 v) { return std::max({v.x, v.y, v.z}); }

float brightestOf(const std::vector<glm::vec3>& lights) {
  float brightest = 0.0f;
  for (const glm::vec3 light : lights) brightest = std::max(brightest, greatest(light));
  return brightest;
}

constexpr VertexOcclusion kNothing{.open = 0.0f};

class Finder {
 public:
  Finder(const Scene& scene, const Geometry& geometry, const SceneOcclusionSettings& settings)
      : scene_(scene),
        geometry_(geometry),
        has_back_(instancesWithBacks(scene, geometry)),
        places_(scene, has_back_),
        patches_(scene, places_, settings.rays > 0 ? places_.size() : kMostPatches),
        world_from_normal_(normalMatrices(scene)),
        emissive_(scene, world_from_normal_),
        first_ray_(firstRays(settings)) {
    first_triangle_.push_back(0);
    for (const Instance& instance : scene.instances)
      first_triangle_.push_back(
          first_triangle_.back() +
          static_cast<std::uint32_t>(scene.meshes[std::size_t(instance.mesh)]->indices.size() / 3));
  }

  Result<void> trace(const ProgressFunction& progress);
  void findAlbedos();
  void findMaterials() { materials_ = materialsOfVertices(scene_, places_, world_from_normal_); }
  void followReflections();
  void spread();
  void give(Scene& scene) const;

 private:
  void giveSides(std::size_t number, Instance& instance) const;
  struct Lit;

  std::vector<double> areasOfPatches() const;
  std::vector<std::size_t> firstRays(const SceneOcclusionSettings& settings) const;
  std::size_t rayCount(std::size_t patch) const { return first_ray_[patch + 1] - first_ray_[patch]; }
  void tracePatch(std::size_t patch);
  std::vector<PatchCorner> patchCorners(std::size_t patch) const;
  VertexOcclusion between(std::span<const PatchWeight> weights) const;
  Hider hiderAt(const Hit& hit, glm::vec3 direction) const;
  glm::vec3 emittedTowards(glm::vec3 normal, glm::vec3 direction, const Hit& hit, std::size_t rays) const;
  glm::vec3 emittedTo(std::size_t patch, std::span<const PatchCorner> corners) const;
  Lit litOnceMore(std::size_t patch, const std::vector<Lit>& lit);

  const Scene& scene_;
  const Geometry& geometry_;
  std::vector<std::uint8_t> has_back_;  // of each instance
  VertexPlaces places_;
  VertexPatches patches_;
  std::vector<glm::mat3> world_from_normal_;
  EmissiveTriangles emissive_;
  std::vector<std::size_t> first_ray_;         // of each patch, and the end
  std::vector<std::uint32_t> first_triangle_;  // of each instance, counted through all
  std::vector<Hider> hiders_;                  // of each patch's rays
  std::vector<glm::vec3> albedos_;             // of the triangles that hide something
  std::vector<VertexOcclusion> found_;         // of each patch, and after spread of each vertex
  std::vector<float> nearness_;                // of each patch, as smoothOcclusion has it
  std::vector<glm::vec3> emitted_;             // of each patch, without reflections
  std::vector<VertexMaterial> materials_;      // of each vertex, if they are asked for
};

Hider Finder::hiderAt(const Hit& hit, glm::vec3 direction) const {
  const Mesh& mesh = scene_.meshes[std::size_t(scene_.instances[hit.instance].mesh)];
  const glm::vec2 b = hit.barycentric;
  const float first = 1.0f - b.x - b.y;
  const std::size_t corner = first >= std::max(b.x, b.y) ? 0 : (b.x >= b.y ? 1 : 2);
  const std::uint32_t front = places_.vertexNumber(hit.instance, mesh.indices[std::size_t{3} * hit.triangle + corner]);
  const glm::vec3 outwards = places_.outwardNormal(hit.instance, hit.triangle, hit.geometric_normal);
  return {patches_.patch(glm::dot(outwards, direction) > 0.0f ? places_.backNumber(front) : front),
          first_triangle_[hit.instance] + hit.triangle};
}

/// The share of an estimate of emitted light that one sample is, over its radiance, where rays by the cosine and chosen
/// places of the triangles that shine both find it: the balance heuristic (Veach & Guibas 1995).
///
/// cosine       to the vertex's normal
/// hit          its distance, and whose normal
/// of_triangle  its density by area
float shareOfSample(float cosine, glm::vec3 direction, const Hit& hit, float of_triangle, std::size_t rays) {
  const float cosine_there = std::abs(glm::dot(direction, hit.geometric_normal));
  const float by_cosine = cosine / formula::kPi;
  // Over cosine_there, as by_cosine is times it below, so that nothing is divided by 0.
  const float by_place = of_triangle * hit.distance * hit.distance;
  const float densities =
      static_cast<float>(rays) * by_cosine * cosine_there + static_cast<float>(placesOfEmission(rays)) * by_place;
  return densities > 0.0f ? by_cosine * cosine_there / densities : 0.0f;
}

/// Of a ray that has met something.
///
/// rays   from the patch
glm::vec3 Finder::emittedTowards(glm::vec3 normal, glm::vec3 direction, const Hit& hit, std::size_t rays) const {
  if (!emissive_.mayShine(hit.instance)) return glm::vec3(0.0f);
  const float cosine = std::max(glm::dot(normal, direction), 0.0f);
  return shareOfSample(cosine, direction, hit, emissive_.density(hit), rays) * emissive_.emission(hit);
}

/// World units².
std::vector<double> Finder::areasOfPatches() const {
  std::vector<double> areas(patches_.size(), 0.0);
  for (std::size_t instance = 0; instance < scene_.instances.size(); ++instance) {
    const std::vector<std::uint32_t>& indices = scene_.meshes[std::size_t(scene_.instances[instance].mesh)]->indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const auto corners = cornersFrom(scene_, instance, i);
      const glm::dvec3 first(corners[0]);
      const double area = glm::length(glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first));
      if (!std::isfinite(area)) continue;
      for (std::size_t corner = i; corner < i + 3; ++corner) {
        const std::uint32_t front = places_.vertexNumber(instance, indices[corner]);
        areas[patches_.patch(front)] += area / 6.0;
        if (has_back_[instance] != 0) areas[patches_.patch(places_.backNumber(front))] += area / 6.0;
      }
    }
  }
  return areas;
}

std::vector<std::size_t> Finder::firstRays(const SceneOcclusionSettings& settings) const {
  const std::vector<std::size_t> rays =
      settings.rays > 0 ? std::vector<std::size_t>(patches_.size(), static_cast<std::size_t>(settings.rays))
                        : raysByArea(areasOfPatches());
  std::vector<std::size_t> first{0};
  for (const std::size_t of_patch : rays) first.push_back(first.back() + of_patch);
  return first;
}

std::vector<PatchCorner> Finder::patchCorners(std::size_t patch) const {
  std::vector<PatchCorner> corners;
  for (const std::uint32_t vertex : patches_.vertices(patch))
    for (std::size_t triangle = 0; triangle < places_.triangles(vertex); ++triangle)
      if (places_.normal(vertex) != glm::vec3(0.0f)) corners.push_back({vertex, triangle});
  return corners;
}

/// By places of what shines that are chosen. As for rays, what has holes or transmits shines by what it hides.
glm::vec3 Finder::emittedTo(std::size_t patch, std::span<const PatchCorner> corners) const {
  glm::vec3 sum(0.0f);
  if (emissive_.empty()) return sum;
  const std::uint32_t places = placesOfEmission(rayCount(patch));
  const std::uint32_t number = mixed(~static_cast<std::uint32_t>(patch), 0);  // other numbers than the rays have
  const glm::vec2 from = sharesOf(number);
  for (std::uint32_t i = 0; i < places; ++i) {
    const std::uint32_t random = mixed(number, i + 1);
    const glm::vec2 which = sharesOf(mixed(random, 0));
    EmissiveTriangles::Place lamp = emissive_.chosen({(static_cast<float>(i) + which.x) / static_cast<float>(places),
                                                      formula::evenPoint(from, static_cast<float>(i))});
    const PatchCorner& corner = corners[static_cast<std::size_t>(which.y * static_cast<float>(corners.size()))];
    const PlaceByVertex place = places_.place(corner.vertex, corner.triangle, sharesOf(random));
    const glm::vec3 origin = formula::besideSurface(place.position, 0.0f, place.geometric_normal);
    lamp.hit.distance = glm::distance(lamp.position, origin);
    const glm::vec3 direction = (lamp.position - origin) / lamp.hit.distance;
    const float cosine = glm::dot(places_.normal(corner.vertex), direction);
    if (!(cosine > 0.0f) || glm::dot(place.geometric_normal, direction) <= 0.0f) continue;
    const std::optional<Hit> met = hidingHit(scene_, geometry_, origin, direction, mixed(~random, 0));
    if (!met || met->instance != lamp.hit.instance || met->triangle != lamp.hit.triangle) continue;
    sum += shareOfSample(cosine, direction, lamp.hit, lamp.density, rayCount(patch)) * emissive_.emission(lamp.hit);
  }
  return sum;
}

void Finder::tracePatch(std::size_t patch) {
  const std::vector<PatchCorner> corners = patchCorners(patch);
  if (corners.empty()) return;
  VertexOcclusion& found = found_[patch];
  const auto number = static_cast<std::uint32_t>(patch);
  const glm::vec2 from = sharesOf(mixed(number, 0));
  const std::size_t rays = rayCount(patch);
  std::size_t open = 0;
  for (std::size_t ray = 0; ray < rays; ++ray) {
    const std::uint32_t random = mixed(number, static_cast<std::uint32_t>(ray) + 1);
    const PatchCorner& corner = corners[ray * corners.size() / rays];
    const PlaceByVertex place = places_.place(corner.vertex, corner.triangle, sharesOf(random));
    const glm::vec2 even = formula::evenPoint(from, static_cast<float>(ray));
    const glm::vec3 normal = places_.normal(corner.vertex);
    const glm::vec3 direction =
        raisedAbove(place.geometric_normal, Frame(normal).toWorld(formula::sampleDiffuse({even.y, even.x})));
    const glm::vec3 origin = formula::besideSurface(place.position, 0.0f, place.geometric_normal);
    const std::optional<Hit> hit = hidingHit(scene_, geometry_, origin, direction, random);
    if (!hit) {
      ++open;
      continue;
    }
    hiders_[first_ray_[patch] + ray] = hiderAt(*hit, direction);
    found.occluded += direction;
    nearness_[patch] += 1.0f / (hit->distance * static_cast<float>(rays));
    found.emitted += emittedTowards(normal, direction, *hit, rays);
  }
  found.emitted += emittedTo(patch, corners);
  found.occluded /= static_cast<float>(rays);
  found.open = static_cast<float>(open) / static_cast<float>(rays);
}

Result<void> Finder::trace(const ProgressFunction& progress) {
  // Beside the rays what is found of patches and vertices, here and in the scene, and of triangles.
  constexpr std::size_t kOfPatch = 4 * sizeof(VertexOcclusion);
  const std::size_t of_vertex = 3 * sizeof(VertexOcclusion) + 2 * sizeof(VertexMaterial);
  const std::size_t of_triangle = sizeof(VertexMaterial) + sizeof(glm::vec3);
  MIRRORBALL_TRY_VOID(withName("the rays of the model's vertices",
                               checkMemory(first_ray_.back() * sizeof(Hider) + patches_.size() * kOfPatch +
                                           places_.size() * of_vertex + first_triangle_.back() * of_triangle)));
  hiders_.resize(first_ray_.back());
  found_.resize(patches_.size());
  nearness_.resize(patches_.size());
  constexpr std::size_t kGrain = 64;
  ProgressCounter counter(progress, (patches_.size() + kGrain - 1) / kGrain);
  parallelFor(patches_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (std::size_t patch = begin; patch < end; ++patch) tracePatch(patch);
    counter.advance();
  });
  return counter.result();
}

void Finder::findAlbedos() {
  std::vector<std::uint8_t> hides(first_triangle_.back(), 0);
  for (const Hider& hider : hiders_)
    if (hider.patch != kOpen) hides[hider.triangle] = 1;
  albedos_.resize(first_triangle_.back());
  for (std::size_t instance = 0; instance < scene_.instances.size(); ++instance) {
    const std::size_t first = first_triangle_[instance];
    parallelFor(first_triangle_[instance + 1] - first, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (hides[first + i] != 0)
          albedos_[first + i] = albedoOf(materialInMiddle(scene_, world_from_normal_, instance, i));
    });
  }
}

/// What a surface sends back of light, before its albedo.
struct Finder::Lit {
  glm::vec3 by_sky{1.0f};    ///< under a white sky
  glm::vec3 lit_from{0.0f};  ///< the direction that this comes from, weighted by it
  glm::vec3 by_emission{0.0f};
};

/// What a patch gets with one reflection more.
Finder::Lit Finder::litOnceMore(std::size_t patch, const std::vector<Lit>& lit) {
  VertexOcclusion& found = found_[patch];
  glm::vec3 interreflected(0.0f), lit_from(0.0f), emitted(0.0f);
  for (std::size_t ray = first_ray_[patch]; ray < first_ray_[patch + 1]; ++ray) {
    const Hider& hider = hiders_[ray];
    if (hider.patch == kOpen) continue;
    const glm::vec3 albedo = albedos_[hider.triangle];
    const Lit& there = lit[hider.patch];
    interreflected += albedo * there.by_sky;
    lit_from += formula::luminance(albedo * there.by_sky) / formula::luminance(there.by_sky + 1e-6f) * there.lit_from;
    emitted += albedo * there.by_emission;
  }
  const auto rays = static_cast<float>(rayCount(patch));
  found.interreflected = interreflected / rays;
  found.lit_from = lit_from / rays;
  found.emitted = emitted_[patch] + emitted / rays;
  const glm::vec3 axis = formula::openingOf(patches_.normal(patch), found.occluded, found.open).axis;
  return {found.open + found.interreflected, found.open * axis + found.lit_from, found.emitted};
}

/// From light that is all there, each step counts one reflection more; so white light in a white scene stays.
void Finder::followReflections() {
  constexpr int kMostSteps = 64;
  constexpr float kEnough = 2e-3f;
  for (const VertexOcclusion& found : found_) emitted_.push_back(found.emitted);
  const float brightest = brightestOf(emitted_);
  std::vector<Lit> lit(found_.size());
  for (std::size_t patch = 0; patch < lit.size(); ++patch)
    lit[patch] = {glm::vec3(1.0f), patches_.normal(patch), emitted_[patch]};
  std::vector<Lit> next(lit.size());
  constexpr std::size_t kGrain = 1024;
  std::vector<float> changes((lit.size() + kGrain - 1) / kGrain);
  for (int step = 0; step < kMostSteps; ++step) {
    parallelFor(lit.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      float change = 0.0f;
      for (std::size_t patch = begin; patch < end; ++patch) {
        next[patch] = litOnceMore(patch, lit);
        change = std::max(change, greatest(glm::abs(next[patch].by_sky - lit[patch].by_sky)));
        if (brightest > 0.0f)
          change = std::max(change, greatest(glm::abs(next[patch].by_emission - lit[patch].by_emission)) /
                                        (greatest(next[patch].by_emission) + 1e-3f * brightest));
      }
      changes[begin / kGrain] = change;
    });
    lit.swap(next);
    if (lit.empty() || *std::max_element(changes.begin(), changes.end()) < kEnough) break;
  }
  hiders_ = std::vector<Hider>();  // the most of the memory
}

VertexOcclusion Finder::between(std::span<const PatchWeight> weights) const {
  VertexOcclusion sum = kNothing;
  for (const auto& [patch, weight] : weights) addTo(sum, found_[patch], weight);
  sum.open = std::clamp(sum.open, 0.0f, 1.0f);
  sum.interreflected = glm::max(sum.interreflected, glm::vec3(0.0f));
  sum.emitted = glm::max(sum.emitted, glm::vec3(0.0f));
  return sum;
}

/// From patches to vertices, without the noise of their rays.
void Finder::spread() {
  std::vector<std::size_t> rays;
  for (std::size_t patch = 0; patch < patches_.size(); ++patch) rays.push_back(rayCount(patch));
  smoothOcclusion(patches_, rays, nearness_, found_);
  std::vector<VertexOcclusion> of_vertices(places_.size());
  parallelFor(of_vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchWeight> weights;
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      if (patches_.isShared(vertex)) {
        patches_.findWeights(vertex, weights);
        of_vertices[vertex] = between(weights);
      } else {
        of_vertices[vertex] = found_[patches_.patch(vertex)];
      }
    }
  });
  found_ = std::move(of_vertices);
}

void Finder::give(Scene& scene) const {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    Instance& instance = scene.instances[i];
    const std::size_t vertices = scene.meshes[std::size_t(instance.mesh)]->vertices.size();
    instance.vertex_materials.resize(materials_.empty() ? 0 : vertices);
    for (std::size_t v = 0; v < instance.vertex_materials.size(); ++v)
      instance.vertex_materials[v] = materials_[places_.vertexNumber(i, static_cast<std::uint32_t>(v))];
    giveSides(i, instance);
  }
}

/// Both sides of an instance's vertices. Where triangles are turned against their normals, their clockwise side is that
/// of the normals.
void Finder::giveSides(std::size_t number, Instance& instance) const {
  const Mesh& mesh = scene_.meshes[std::size_t(instance.mesh)];
  const std::size_t vertices = mesh.vertices.size();
  const bool has_back = has_back_[number] != 0;
  instance.occlusion.resize(has_back ? 2 * vertices : vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const std::uint32_t front = places_.vertexNumber(number, v);
    instance.occlusion[v] = found_[front];
    if (has_back) instance.occlusion[vertices + v] = found_[places_.backNumber(front)];
  }
  if (!has_back) return;
  std::vector<std::uint8_t> is_turned(vertices, 0);
  for (std::size_t i = 0; i / 3 < mesh.indices.size() / 3; ++i) {
    const auto [a, b, c] = cornersFrom(scene_, number, i / 3 * 3);
    const glm::vec3 normal = unitOrNone(glm::cross(b - a, c - a));
    if (places_.outwardNormal(number, i / 3, normal) != normal) is_turned[mesh.indices[i]] = 1;
  }
  for (std::size_t v = 0; v < vertices; ++v)
    if (is_turned[v] != 0) std::swap(instance.occlusion[v], instance.occlusion[vertices + v]);
}

}  // namespace

std::size_t occlusionRays(std::size_t vertices, const SceneOcclusionSettings& settings) {
  return settings.rays > 0 ? vertices * static_cast<std::size_t>(settings.rays)
                           : raysOfAll(std::min(vertices, kMostPatches));
}

Result<void> findOcclusion(Scene& scene, const Geometry& geometry, const SceneOcclusionSettings& settings,
                           const ProgressFunction& progress) {
  Finder finder(scene, geometry, settings);
  MIRRORBALL_TRY_VOID(finder.trace(progress));
  finder.findAlbedos();
  finder.followReflections();
  finder.spread();
  if (settings.finds_materials) finder.findMaterials();
  finder.give(scene);
  return {};
}

}  // namespace mirrorball
