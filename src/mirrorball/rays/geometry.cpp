#include "mirrorball/rays/geometry.h"

#include <map>
#include <mutex>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/rays/ray_tree.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

/// What a triangle takes while its tree is built. Embree's: with the vertices 111 to 128 bytes, of which 78 to 85 are
/// kept, measured on grids of 0.18 to 8 million triangles. Our own: by the sizes of its parts 160, of which 65 are.
constexpr std::uint64_t bytesPerTriangle(RayTracer tracer) { return tracer == RayTracer::embree ? 130 : 170; }

/// Of a triangle with relief: its prism, and what a tree takes for that.
constexpr std::uint64_t kBytesPerPrism = 500;

bool hasRelief(const Scene& scene, std::size_t instance) {
  return showsHeightTexture(materialOf(scene, instance), ReliefKind::exact);
}

/// What the triangles of all instances may take, or of those with relief, at so many bytes each.
std::uint64_t memoryFor(const Scene& scene, std::uint64_t bytes_each, bool is_of_reliefs) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (!is_of_reliefs || hasRelief(scene, i))
      bytes += scene.meshes[std::size_t(scene.instances[i].mesh)]->indices.size() / 3 * bytes_each;
  return bytes;
}

}  // namespace

struct Geometry::State {
  explicit State(RayTracer by) : tracer(by) {}

  RayTracer tracer;
  std::unique_ptr<RayTree> triangles = {};
  std::mutex making_reliefs = {};
  // All three stay where they are in memory: trees and prisms refer to them.
  std::map<int, std::unique_ptr<TwoSidedHeights>> heights = {};  // of Scene::height_textures
  PrismsOfInstances prisms = {};
  std::unique_ptr<RayTree> reliefs = {};  // instances with relief by their prisms, others by triangles; null: not made

  /// Ours where Embree does not run.
  Result<std::unique_ptr<RayTree>> treeOf(const Scene& scene, const PrismsOfInstances& of_prisms) {
    if (tracer == RayTracer::embree) {
      auto tree = embreeTree(scene, of_prisms);
      if (tree || tree.error().code != ErrorCode::unsupported) return tree;
      tracer = RayTracer::own;
    }
    return ownTree(scene, of_prisms);
  }
  Result<void> makePrisms(const Scene& scene);
};

/// The prisms of all instances with relief.
Result<void> Geometry::State::makePrisms(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!hasRelief(scene, i)) continue;
    const int texture = materialOf(scene, i).height_texture;
    const auto [found, is_new] = heights.try_emplace(texture);
    if (is_new) found->second = std::make_unique<TwoSidedHeights>(scene.height_textures[std::size_t(texture)]);
    if (hasBack(materialOf(scene, i))) MIRRORBALL_TRY_VOID(found->second->makeDepths());
    prisms[i] = std::make_unique<ReliefPrisms>(scene, i, *found->second);
  }
  return {};
}

Geometry::Geometry(std::unique_ptr<State> state) : state_(std::move(state)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

Result<Geometry> Geometry::make(const Scene& scene, RayTracer tracer) {
  MIRRORBALL_TRY_VOID(
      withName("the scene's triangles", checkMemory(memoryFor(scene, bytesPerTriangle(tracer), false))));
  static const PrismsOfInstances kNoPrisms;
  auto state = std::make_unique<State>(tracer);
  MIRRORBALL_TRY(triangles, state->treeOf(scene, kNoPrisms));
  state->triangles = std::move(triangles);
  return Geometry(std::move(state));
}

Result<void> Geometry::makeReliefs(const Scene& scene) {
  State& state = *state_;
  const std::lock_guard lock(state.making_reliefs);
  if (state.reliefs) return {};
  MIRRORBALL_TRY_VOID(withName("the scene's relief", checkMemory(memoryFor(scene, kBytesPerPrism, true))));
  MIRRORBALL_TRY_VOID(state.makePrisms(scene));
  if (state.prisms.empty()) return {};
  MIRRORBALL_TRY(reliefs, state.treeOf(scene, state.prisms));
  state.reliefs = std::move(reliefs);
  return {};
}

RayTracer Geometry::tracer() const { return state_->tracer; }

std::optional<Hit> Geometry::hit(glm::vec3 origin, glm::vec3 direction, float nearest, Surfaces surfaces) const {
  constexpr float kFarthest = 1e18f;  // Embree takes no ray from farther away: it may end the program
  const bool is_near = glm::all(glm::lessThanEqual(glm::abs(origin), glm::vec3(kFarthest)));
  if (!is_near || !isFinite(direction)) return std::nullopt;
  const bool meets_reliefs = surfaces == Surfaces::reliefs && state_->reliefs;
  return (meets_reliefs ? state_->reliefs : state_->triangles)->hit(origin, direction, nearest);
}

}  // namespace mirrorball
