#include "mirrorball/rays/occlusion_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/seen_from.h"

namespace mirrorball {
namespace {

/// From what lies between the corners, of an even sky's irradiance: twice the noise of the rays.
constexpr float kTolerance = 1.0f / 12.0f;
/// Of the radius of an object: triangles are not cut below that, and places are so far apart at most.
constexpr float kFinest = 1.0f / 24.0f;
constexpr float kBetweenPlaces = 1.0f / 4.0f;
constexpr int kMostPlacesAlong = 48;
constexpr int kMostSteps = 10;
constexpr std::size_t kMostVertices = 200'000;  // that are new
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

class Refiner {
 public:
  Refiner(const Scene& scene, const Geometry& geometry, std::size_t mesh, float radius)
      : scene_(scene), geometry_(geometry), radius_(radius), refiner_(scene.meshes[mesh]) {
    for (const Instance& instance : scene.instances)
      if (std::size_t(instance.mesh) == mesh) places_.push_back(&instance);
  }

  Result<void> refine(const ProgressFunction& progress);
  MeshRefinement refinement() const { return refiner_.refinement(); }

 private:
  bool differs(const PlacedTriangle& placed) const;
  bool isLarge(const PlacedTriangle& placed) const { return placed.longest_edge > 2.0f * kFinest * radius_; }

  const Scene& scene_;
  const Geometry& geometry_;
  float radius_;
  MeshRefiner refiner_;
  std::vector<const Instance*> places_;
};

/// Whether some place of it sees something else than what lies between its corners.
bool Refiner::differs(const PlacedTriangle& placed) const {
  const float inner = 1.0f - 3.0f * kFromEdges;
  const auto weightsOf = [&](glm::vec3 even) { return inner * even + kFromEdges; };
  std::array<glm::vec4, 3> seen;
  for (int i = 0; i < 3; ++i) {
    glm::vec3 corner(0.0f);
    corner[i] = 1.0f;
    seen[std::size_t(i)] = seenFrom(scene_, geometry_, placed, weightsOf(corner));
  }
  const int along =
      std::clamp(static_cast<int>(std::ceil(placed.longest_edge / (kBetweenPlaces * radius_))), 2, kMostPlacesAlong);
  for (int i = 0; i <= along; ++i)
    for (int k = 0; i + k <= along; ++k) {
      const glm::vec3 even = glm::vec3(i, k, along - i - k) / static_cast<float>(along);
      if (std::max({even.x, even.y, even.z}) == 1.0f) continue;
      const glm::vec4 between = even.x * seen[0] + even.y * seen[1] + even.z * seen[2];
      const glm::vec4 apart = seenFrom(scene_, geometry_, placed, weightsOf(even)) - between;
      if (std::max(glm::length(glm::vec3(apart)), std::abs(apart.w)) > kTolerance) return true;
    }
  return false;
}

Result<void> Refiner::refine(const ProgressFunction& progress) {
  std::vector<std::uint8_t> is_asked(refiner_.mesh().indices.size() / 3, 1);
  std::vector<std::uint8_t> is_cut;
  for (int step = 0; step < kMostSteps; ++step) {
    is_cut.assign(is_asked.size(), 0);
    constexpr std::size_t kGrain = 64;
    ProgressCounter counter(progress, (is_asked.size() + kGrain - 1) / kGrain);
    parallelFor(is_asked.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      if (counter.stopped()) return;
      for (std::size_t triangle = begin; triangle < end; ++triangle)
        is_cut[triangle] =
            is_asked[triangle] != 0 && std::any_of(places_.begin(), places_.end(), [&](const Instance* instance) {
              const PlacedTriangle at = placedTriangle(refiner_.mesh(), *instance, triangle);
              return isLarge(at) && differs(at);
            });
      counter.advance();
    });
    MIRRORBALL_TRY_VOID(counter.result());
    const auto cut = static_cast<std::size_t>(std::count(is_cut.begin(), is_cut.end(), std::uint8_t{1}));
    if (cut == 0 || refiner_.refinement().parents.size() + 2 * cut > kMostVertices) return {};
    const std::vector<std::uint32_t> lies_in = refiner_.cut(is_cut);
    is_asked.resize(lies_in.size());
    std::transform(lies_in.begin(), lies_in.end(), is_asked.begin(), [&](std::uint32_t old) { return is_cut[old]; });
  }
  return {};
}

bool isCut(const Scene& scene, const Mesh& mesh) {
  const Material& material = scene.materials[std::size_t(mesh.material)];
  return mesh.first_of_relief == 0 && material.height == HeightKind::none && material.transmission == 0.0f;
}

}  // namespace

Result<std::vector<MeshRefinement>> occlusionRefinements(const Scene& scene, const Geometry& geometry,
                                                         const ProgressFunction& progress) {
  std::vector<MeshRefinement> refinements(scene.meshes.size());
  const float radius = typicalRadius(scene);
  if (!(radius > 0.0f)) return refinements;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (!isCut(scene, scene.meshes[mesh])) continue;
    Refiner refiner(scene, geometry, mesh, radius);
    MIRRORBALL_TRY_VOID(refiner.refine(progress));
    refinements[mesh] = refiner.refinement();
  }
  return refinements;
}

}  // namespace mirrorball
