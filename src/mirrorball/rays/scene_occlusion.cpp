#include "mirrorball/rays/scene_occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/hiding.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/rays/vertex_places.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRaysInAll = 1'600'000;
constexpr std::size_t kFewestRays = 8;
constexpr std::size_t kMostRays = 256;
constexpr std::uint32_t kOpen = ~std::uint32_t{0};

/// What hides the environment on one ray: the nearest vertex of the surface there; kOpen: nothing does.
struct Hider {
  std::uint32_t vertex = kOpen;
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

class Finder {
 public:
  Finder(const Scene& scene, const Geometry& geometry, const SceneOcclusionSettings& settings)
      : scene_(scene),
        geometry_(geometry),
        places_(scene),
        world_from_normal_(normalMatrices(scene)),
        rays_(occlusionRaysOfVertex(places_.size(), settings)) {
    first_triangle_.push_back(0);
    for (const Instance& instance : scene.instances)
      first_triangle_.push_back(
          first_triangle_.back() +
          static_cast<std::uint32_t>(scene.meshes[std::size_t(instance.mesh)].indices.size() / 3));
  }

  Result<void> trace(const ProgressFunction& progress);
  void findAlbedos();
  void findLooks();
  void followReflections();
  void smooth();
  void give(Scene& scene) const;

 private:
  void traceVertex(std::size_t vertex);
  Hider hiderOf(glm::vec3 origin, glm::vec3 direction, std::uint32_t random) const;
  formula::Material materialOfTriangle(std::uint32_t triangle) const;

  const Scene& scene_;
  const Geometry& geometry_;
  VertexPlaces places_;
  std::vector<glm::mat3> world_from_normal_;
  std::size_t rays_;
  std::vector<std::uint32_t> first_triangle_;  // of each instance, counted through all
  std::vector<Hider> hiders_;                  // of each vertex's rays
  std::vector<glm::vec3> albedos_;             // of the triangles that hide something
  std::vector<VertexOcclusion> found_;         // of each vertex
  std::vector<VertexLook> looks_;              // likewise, if they are asked for
};

Hider Finder::hiderOf(glm::vec3 origin, glm::vec3 direction, std::uint32_t random) const {
  const std::optional<Hit> hit = hidingHit(scene_, geometry_, origin, direction, random);
  if (!hit) return {};
  const Mesh& mesh = scene_.meshes[std::size_t(scene_.instances[hit->instance].mesh)];
  const glm::vec2 b = hit->barycentric;
  const float first = 1.0f - b.x - b.y;
  const std::size_t corner = first >= std::max(b.x, b.y) ? 0 : (b.x >= b.y ? 1 : 2);
  return {places_.vertexOf(hit->instance, mesh.indices[std::size_t{3} * hit->triangle + corner]),
          first_triangle_[hit->instance] + hit->triangle};
}

void Finder::traceVertex(std::size_t vertex) {
  const glm::vec3 normal = places_.normal(vertex);
  const std::size_t triangles = places_.triangles(vertex);
  VertexOcclusion& found = found_[vertex];
  if (triangles == 0 || normal == glm::vec3(0.0f)) return;
  const Frame frame(normal);
  const auto number = static_cast<std::uint32_t>(vertex);
  const glm::vec2 from = sharesOf(mixed(number, 0));
  std::size_t open = 0;
  for (std::size_t ray = 0; ray < rays_; ++ray) {
    const std::uint32_t random = mixed(number, static_cast<std::uint32_t>(ray) + 1);
    const PlaceByVertex place = places_.place(vertex, ray * triangles / rays_, sharesOf(random));
    const glm::vec2 even = formula::evenPoint(from, static_cast<float>(ray));
    const glm::vec3 direction =
        raisedAbove(place.geometric_normal, frame.toWorld(formula::sampleDiffuse({even.y, even.x})));
    const Hider hider =
        hiderOf(formula::besideSurface(place.position, 0.0f, place.geometric_normal), direction, random);
    hiders_[vertex * rays_ + ray] = hider;
    if (hider.vertex == kOpen)
      ++open;
    else
      found.hidden += direction;
  }
  found.hidden /= static_cast<float>(rays_);
  found.open = static_cast<float>(open) / static_cast<float>(rays_);
}

Result<void> Finder::trace(const ProgressFunction& progress) {
  // Beside the rays what is found of vertices, here and in the scene, and of triangles.
  const std::size_t of_vertex = rays_ * sizeof(Hider) + 4 * sizeof(VertexOcclusion) + 2 * sizeof(VertexLook);
  const std::size_t of_triangle = sizeof(VertexLook) + sizeof(glm::vec3);
  MIRRORBALL_TRY_VOID(withName("the rays of the model's vertices",
                               checkMemory(places_.size() * of_vertex + first_triangle_.back() * of_triangle)));
  hiders_.resize(places_.size() * rays_);
  found_.resize(places_.size());
  constexpr std::size_t kGrain = 256;
  ProgressCounter counter(progress, (places_.size() + kGrain - 1) / kGrain);
  parallelFor(places_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (std::size_t vertex = begin; vertex < end; ++vertex) traceVertex(vertex);
    counter.advance();
  });
  return counter.result();
}

/// In the middle of a triangle.
formula::Material Finder::materialOfTriangle(std::uint32_t triangle) const {
  const auto after = std::upper_bound(first_triangle_.begin(), first_triangle_.end(), triangle);
  const auto instance = static_cast<std::uint32_t>(after - first_triangle_.begin()) - 1;
  const Hit middle{
      .instance = instance, .triangle = triangle - first_triangle_[instance], .barycentric = glm::vec2(1.0f / 3.0f)};
  return surfacePointAt(scene_, world_from_normal_[instance], middle, ReliefKind::none).material;
}

void Finder::findAlbedos() {
  std::vector<std::uint8_t> hides(first_triangle_.back(), 0);
  for (const Hider& hider : hiders_)
    if (hider.vertex != kOpen) hides[hider.triangle] = 1;
  albedos_.resize(first_triangle_.back());
  parallelFor(albedos_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (hides[i] != 0) albedos_[i] = albedoOf(materialOfTriangle(static_cast<std::uint32_t>(i)));
  });
}

/// The mean of the triangles around each vertex.
void Finder::findLooks() {
  std::vector<VertexLook> of_triangles(first_triangle_.back());
  parallelFor(of_triangles.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const formula::Material material = materialOfTriangle(static_cast<std::uint32_t>(i));
      of_triangles[i] = {material.base_color, material.metallic, material.emission, material.perceptual_roughness};
    }
  });
  looks_.assign(places_.size(), {glm::vec3(0.0f), 0.0f, glm::vec3(0.0f), 0.0f});
  std::vector<float> counts(places_.size(), 0.0f);
  for (std::size_t instance = 0; instance < scene_.instances.size(); ++instance) {
    const std::vector<std::uint32_t>& indices = scene_.meshes[std::size_t(scene_.instances[instance].mesh)].indices;
    for (std::size_t i = 0; i / 3 < indices.size() / 3; ++i) {
      const VertexLook& look = of_triangles[first_triangle_[instance] + i / 3];
      const std::uint32_t vertex = places_.vertexOf(instance, indices[i]);
      VertexLook& sum = looks_[vertex];
      sum.base_color += look.base_color;
      sum.metallic += look.metallic;
      sum.emission += look.emission;
      sum.perceptual_roughness += look.perceptual_roughness;
      counts[vertex] += 1.0f;
    }
  }
  for (std::size_t v = 0; v < looks_.size(); ++v) {
    const float part = 1.0f / std::max(counts[v], 1.0f);
    const VertexLook& sum = looks_[v];
    looks_[v] = {part * sum.base_color, part * sum.metallic, part * sum.emission, part * sum.perceptual_roughness};
  }
}

/// From light that is all there, each step counts one reflection more; so white light in a white scene stays.
void Finder::followReflections() {
  constexpr int kMostSteps = 64;
  constexpr float kEnough = 2e-3f;
  std::vector<glm::vec3> light(found_.size(), glm::vec3(1.0f));
  std::vector<glm::vec3> next(light.size());
  constexpr std::size_t kGrain = 1024;
  std::vector<float> changes((light.size() + kGrain - 1) / kGrain);
  for (int step = 0; step < kMostSteps; ++step) {
    parallelFor(light.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      float change = 0.0f;
      for (std::size_t vertex = begin; vertex < end; ++vertex) {
        glm::vec3 shown(0.0f);
        for (std::size_t ray = vertex * rays_; ray < (vertex + 1) * rays_; ++ray)
          if (const Hider& hider = hiders_[ray]; hider.vertex != kOpen)
            shown += albedos_[hider.triangle] * light[hider.vertex];
        found_[vertex].shown = shown / static_cast<float>(rays_);
        next[vertex] = found_[vertex].open + found_[vertex].shown;
        const glm::vec3 changed = glm::abs(next[vertex] - light[vertex]);
        change = std::max(change, std::max({changed.x, changed.y, changed.z}));
      }
      changes[begin / kGrain] = change;
    });
    light.swap(next);
    if (light.empty() || *std::max_element(changes.begin(), changes.end()) < kEnough) break;
  }
  hiders_ = std::vector<Hider>();  // the most of the memory
}

/// Of a vertex and its neighbours over the edges of triangles, where the surface goes on smoothly.
void Finder::smooth() {
  constexpr float kSmooth = 0.8f;  // the cosine between their normals, at least
  // So much the vertex itself counts: neighbours are worth less the less noise there is.
  const float own = static_cast<float>(rays_) * static_cast<float>(rays_) / 512.0f;
  std::vector<VertexOcclusion> sums = found_;
  std::vector<float> weights(found_.size(), own);
  for (VertexOcclusion& sum : sums) sum = {own * sum.hidden, own * sum.open, own * sum.shown};
  const auto add = [&](std::uint32_t to, std::uint32_t from) {
    if (glm::dot(places_.normal(to), places_.normal(from)) < kSmooth) return;
    sums[to].hidden += found_[from].hidden;
    sums[to].open += found_[from].open;
    sums[to].shown += found_[from].shown;
    weights[to] += 1.0f;
  };
  for (std::size_t instance = 0; instance < scene_.instances.size(); ++instance) {
    const std::vector<std::uint32_t>& indices = scene_.meshes[std::size_t(scene_.instances[instance].mesh)].indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::uint32_t a = places_.vertexOf(instance, indices[i + edge]);
        const std::uint32_t b = places_.vertexOf(instance, indices[i + (edge + 1) % 3]);
        add(a, b);
        add(b, a);
      }
  }
  for (std::size_t v = 0; v < found_.size(); ++v)
    found_[v] = {sums[v].hidden / weights[v], sums[v].open / weights[v], sums[v].shown / weights[v]};
}

void Finder::give(Scene& scene) const {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    Instance& instance = scene.instances[i];
    const std::size_t vertices = scene.meshes[std::size_t(instance.mesh)].vertices.size();
    instance.occlusion.resize(vertices);
    instance.looks.resize(looks_.empty() ? 0 : vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      const std::uint32_t number = places_.vertexOf(i, static_cast<std::uint32_t>(v));
      instance.occlusion[v] = found_[number];
      if (!looks_.empty()) instance.looks[v] = looks_[number];
    }
  }
}

}  // namespace

std::size_t occlusionRaysOfVertex(std::size_t vertices, const SceneOcclusionSettings& settings) {
  const std::size_t share = kRaysInAll / std::max<std::size_t>(vertices, 1);
  return settings.rays > 0 ? std::size_t(settings.rays) : std::clamp(share, kFewestRays, kMostRays);
}

Result<void> findOcclusion(Scene& scene, const Geometry& geometry, const SceneOcclusionSettings& settings,
                           const ProgressFunction& progress) {
  Finder finder(scene, geometry, settings);
  MIRRORBALL_TRY_VOID(finder.trace(progress));
  finder.findAlbedos();
  finder.followReflections();
  finder.smooth();
  if (settings.finds_looks) finder.findLooks();
  finder.give(scene);
  return {};
}

}  // namespace mirrorball
