#include "mirrorball/rays/occlusion_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/cut_edges.h"
#include "mirrorball/rays/seen_from.h"

namespace mirrorball {
namespace {

/// From what lies between the corners, of an even sky's irradiance: twice the noise of the rays.
constexpr float kTolerance = 1.0f / 12.0f;
/// The longest edge of a triangle over the distance of what it sees, times the root of the share of the sky that it
/// hides: that of a line whose middle is wrong by 0.25 % of the sky.
constexpr float kMostOfDistance = 0.14f;
/// Of the radius of an object: triangles are not cut below that, and places are so far apart at most.
constexpr float kFinest = 1.0f / 24.0f;
constexpr float kBetweenPlaces = 1.0f / 4.0f;
constexpr float kMostPlacesAlong = 48.0f;
constexpr int kMostRounds = 10;
/// For all of a scene: places that are asked, some 3 s of one core, and new vertices, each in all of its instances.
constexpr std::size_t kMostPlaces = 150'000;
constexpr std::size_t kMostVertices = 200'000;
/// How far places lie from the edges, where folds are seen from neither side.
constexpr float kFromEdges = 0.06f;

/// The lower middle one of the radii of all objects.
float typicalRadius(const Scene& scene) {
  std::vector<float> radii;
  for (const Instance& instance : scene.instances) {
    const Box box = boundingBox(scene, instance);
    if (!box.isEmpty()) radii.push_back(0.5f * glm::distance(box.low, box.high));
  }
  if (radii.empty()) return 0.0f;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>((radii.size() - 1) / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return std::isfinite(*middle) ? *middle : 0.0f;
}

/// What is left of what may be spent on a scene.
struct Budget {
  std::size_t places = kMostPlaces;
  std::size_t vertices = kMostVertices;
};

class Refiner {
 public:
  Refiner(const Scene& scene, const Geometry& geometry, std::size_t mesh, float radius, Budget& budget)
      : scene_(scene), geometry_(geometry), radius_(radius), budget_(budget), refiner_(scene.meshes[mesh]) {
    for (const Instance& instance : scene.instances)
      if (std::size_t(instance.mesh) == mesh) {
        places_.push_back(&instance);
        has_backs_ = has_backs_ || showsBacks(scene, geometry, instance);
      }
  }

  Result<void> refine(const ProgressFunction& progress);
  void addTo(CutEdges& cut) const;
  bool cutWith(const CutEdges& cut);
  MeshRefinement refinement() const { return refiner_.refinement(); }

 private:
  bool differs(const PlacedTriangle& placed) const;
  int placesAlong(float longest_edge) const;
  std::vector<float> longestEdges(const std::vector<std::uint8_t>& is_asked) const;
  bool takePlaces(const std::vector<std::uint8_t>& is_asked);
  bool isLarge(const PlacedTriangle& placed) const { return placed.longest_edge > 2.0f * kFinest * radius_; }

  const Scene& scene_;
  const Geometry& geometry_;
  float radius_;
  float between_places_ = kBetweenPlaces;  // in radii
  Budget& budget_;
  MeshRefiner refiner_;
  std::vector<const Instance*> places_;
  bool has_backs_ = false;
};

/// How many parts an edge of a triangle has between the places that are asked.
int Refiner::placesAlong(float longest_edge) const {
  const float along = std::ceil(longest_edge / (between_places_ * radius_));
  return static_cast<int>(std::clamp(along, 2.0f, kMostPlacesAlong));
}

/// Of those triangles that are large, in all instances.
std::vector<float> Refiner::longestEdges(const std::vector<std::uint8_t>& is_asked) const {
  std::vector<float> longest;
  for (const Instance* instance : places_)
    for (std::size_t triangle = 0; triangle < is_asked.size(); ++triangle) {
      if (is_asked[triangle] == 0) continue;
      const PlacedTriangle placed = placedTriangle(refiner_.mesh(), *instance, triangle);
      if (isLarge(placed)) longest.push_back(placed.longest_edge);
    }
  return longest;
}

/// Takes what those triangles need from the budget, with places farther apart where that is too much.
///
/// returns  whether it is enough
bool Refiner::takePlaces(const std::vector<std::uint8_t>& is_asked) {
  const std::vector<float> longest = longestEdges(is_asked);
  const auto placesOfAll = [&] {
    return std::accumulate(longest.begin(), longest.end(), std::size_t{0}, [&](std::size_t sum, float edge) {
      const auto along = static_cast<std::size_t>(placesAlong(edge));
      return sum + (has_backs_ ? 2 : 1) * (along + 1) * (along + 2) / 2;
    });
  };
  std::size_t needed = placesOfAll();
  for (; needed > budget_.places && between_places_ < 64.0f; needed = placesOfAll()) between_places_ *= 2.0f;
  if (needed > budget_.places) return false;
  budget_.places -= needed;
  return true;
}

/// Whether some place of it sees something else than what lies between its corners.
bool Refiner::differs(const PlacedTriangle& placed) const {
  const float inner = 1.0f - 3.0f * kFromEdges;
  const auto weightsOf = [&](glm::vec3 even) { return inner * even + kFromEdges; };
  // What hides the share s of the sky at the distance d changes over that distance, and faster the more it hides.
  const auto isNear = [&](const SeenScene& seen) {
    const float hidden = 1.0f - seen.open;
    return seen.nearness * placed.longest_edge > kMostOfDistance * std::sqrt(hidden);
  };
  std::array<SeenScene, 3> seen;
  for (int i = 0; i < 3; ++i) {
    glm::vec3 corner(0.0f);
    corner[i] = 1.0f;
    seen[std::size_t(i)] = seenFrom(scene_, geometry_, placed, weightsOf(corner));
    if (isNear(seen[std::size_t(i)])) return true;
  }
  const int along = placesAlong(placed.longest_edge);
  for (int i = 0; i <= along; ++i)
    for (int k = 0; i + k <= along; ++k) {
      const glm::vec3 even = glm::vec3(i, k, along - i - k) / static_cast<float>(along);
      if (std::max({even.x, even.y, even.z}) == 1.0f) continue;
      const SeenScene there = seenFrom(scene_, geometry_, placed, weightsOf(even));
      glm::vec3 occluded(0.0f);
      float open = 0.0f;
      for (int corner = 0; corner < 3; ++corner) {
        occluded += even[corner] * seen[std::size_t(corner)].occluded;
        open += even[corner] * seen[std::size_t(corner)].open;
      }
      if (isNear(there) || glm::distance(there.occluded, occluded) > kTolerance ||
          std::abs(there.open - open) > kTolerance)
        return true;
    }
  return false;
}

Result<void> Refiner::refine(const ProgressFunction& progress) {
  std::vector<std::uint8_t> is_asked(refiner_.mesh().indices.size() / 3, 1);
  std::vector<std::uint8_t> is_cut;
  for (int step = 0; step < kMostRounds; ++step) {
    if (!takePlaces(is_asked)) return {};
    is_cut.assign(is_asked.size(), 0);
    constexpr std::size_t kGrain = 8;
    ProgressCounter counter(progress, (is_asked.size() + kGrain - 1) / kGrain);
    parallelFor(is_asked.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      if (counter.stopped()) return;
      for (std::size_t triangle = begin; triangle < end; ++triangle)
        is_cut[triangle] =
            is_asked[triangle] != 0 && std::any_of(places_.begin(), places_.end(), [&](const Instance* instance) {
              const PlacedTriangle at = placedTriangle(refiner_.mesh(), *instance, triangle);
              return isLarge(at) && (differs(at) || (has_backs_ && differs(at.turnedOver())));
            });
      counter.advance();
    });
    MIRRORBALL_TRY_VOID(counter.result());
    const auto cut = static_cast<std::size_t>(std::count(is_cut.begin(), is_cut.end(), std::uint8_t{1}));
    // Three middles for each; those of neighbours are shared.
    if (cut == 0 || 3 * cut * places_.size() > budget_.vertices) return {};
    const std::size_t before = refiner_.mesh().vertices.size();
    const std::vector<std::uint32_t> lies_in = refiner_.cut(is_cut);
    budget_.vertices -= std::min(budget_.vertices, (refiner_.mesh().vertices.size() - before) * places_.size());
    is_asked.resize(lies_in.size());
    std::transform(lies_in.begin(), lies_in.end(), is_asked.begin(), [&](std::uint32_t old) { return is_cut[old]; });
  }
  return {};
}

glm::vec3 inWorld(const Instance& instance, glm::vec3 position) {
  return glm::vec3(instance.world_from_object * glm::vec4(position, 1.0f));
}

/// Adds all edges that are cut, wherever the mesh stands.
void Refiner::addTo(CutEdges& cut) const {
  const std::vector<Vertex>& vertices = refiner_.mesh().vertices;
  for (const Instance* instance : places_)
    for (const glm::uvec2 ends : refiner_.parents())
      cut.insert(inWorld(*instance, vertices[ends.x].position), inWorld(*instance, vertices[ends.y].position));
}

/// Cuts those edges too, wherever the mesh stands.
///
/// returns  whether there were any
bool Refiner::cutWith(const CutEdges& cut) {
  // A mesh that stands beside itself in another size would else cut its own halves again and again.
  const float shortest = kFinest * radius_;
  return refiner_.cutEdges([&](glm::vec3 a, glm::vec3 b) {
    return std::any_of(places_.begin(), places_.end(), [&](const Instance* instance) {
      const glm::vec3 from = inWorld(*instance, a), to = inWorld(*instance, b);
      return glm::distance(from, to) > shortest && cut.contains(from, to);
    });
  });
}

/// Cuts edges that meshes have in common in all of them, until none of any length is cut on one side only.
void joinEdges(std::vector<std::optional<Refiner>>& refiners) {
  CutEdges cut;
  bool is_new = true;
  // As often as an edge can have been cut; far from the origin, where middles are rounded to ends, no end would come.
  for (int round = 0; round < kMostRounds && is_new; ++round) {
    is_new = false;
    for (const auto& refiner : refiners)
      if (refiner) refiner->addTo(cut);
    if (cut.empty()) return;
    for (auto& refiner : refiners)
      if (refiner) is_new |= refiner->cutWith(cut);
  }
}

bool mayBeCut(const Scene& scene, const Mesh& mesh) {
  return mesh.first_of_relief == 0 && scene.materials[std::size_t(mesh.material)].height == HeightKind::none;
}

bool isTransmitting(const Scene& scene, const Mesh& mesh) {
  return scene.materials[std::size_t(mesh.material)].transmission != 0.0f;
}

}  // namespace

Result<std::vector<MeshRefinement>> occlusionRefinements(const Scene& scene, const Geometry& geometry,
                                                         const ProgressFunction& progress) {
  std::vector<MeshRefinement> refinements(scene.meshes.size());
  const float radius = typicalRadius(scene);
  if (!(radius > 0.0f)) return refinements;
  Budget budget;
  std::vector<std::optional<Refiner>> refiners(scene.meshes.size());
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (!mayBeCut(scene, scene.meshes[mesh])) continue;
    refiners[mesh].emplace(scene, geometry, mesh, radius, budget);
    if (isTransmitting(scene, scene.meshes[mesh])) continue;
    // Nobody knows how many rounds a mesh takes: only whole ones are told.
    const ProgressFunction of_mesh = [&](std::size_t, std::size_t) {
      return !progress || progress(mesh, scene.meshes.size());
    };
    MIRRORBALL_TRY_VOID(refiners[mesh]->refine(of_mesh));
  }
  joinEdges(refiners);
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh)
    if (refiners[mesh]) refinements[mesh] = refiners[mesh]->refinement();
  return refinements;
}

}  // namespace mirrorball
