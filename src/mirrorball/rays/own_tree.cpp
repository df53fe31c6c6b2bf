#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "formula/bodies.h"
#include "mirrorball/rays/ray_tree.h"
#include "mirrorball/scene/bodies/box_tree.h"
#include "mirrorball/scene/box.h"

namespace mirrorball {
namespace {

constexpr std::uint32_t kItemsOfLeaf = 4;
constexpr int kDeepest = 64;
/// Larger places are left out: the area of a box must be finite.
constexpr float kLargest = 1e18f;

using Corners = std::array<glm::vec3, 3>;

/// What rays meet: a triangle, or the prism of a relief below it.
struct Item {
  std::uint32_t instance;
  std::uint32_t triangle;  ///< of its mesh
  Corners corners;         ///< of a triangle, world
};

bool isSmall(glm::vec3 p) { return glm::all(glm::lessThan(glm::abs(p), glm::vec3(kLargest))); }  // of NaN, too: no

Box boxOf(const Corners& corners) {
  Box box;
  for (const glm::vec3& corner : corners) box.include({corner, corner});
  return box;
}

/// A ray, in the axes in which it runs along +Z from the origin: what triangles with a common edge are asked on it then
/// is the same number.
class ShearedRay {
 public:
  ShearedRay(glm::vec3 origin, glm::vec3 direction) : origin_(origin) {
    const glm::vec3 size = glm::abs(direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (x_ + 1) % 3;
    if (direction[z_] < 0.0f) std::swap(x_, y_);  // so that windings stay
    shear_ = glm::vec3(direction[x_], direction[y_], 1.0f) / direction[z_];
  }

  struct Meeting {
    float distance;
    glm::vec2 barycentric;
  };
  /// From both sides; nothing also where the triangle is seen from its edge.
  std::optional<Meeting> meet(const Corners& corners) const {
    const glm::vec3 a = sheared(corners[0]), b = sheared(corners[1]), c = sheared(corners[2]);
    float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    if (u == 0.0f || v == 0.0f || w == 0.0f) {  // on an edge as far as floats know
      u = edge(c, b);
      v = edge(a, c);
      w = edge(b, a);
    }
    if (std::min({u, v, w}) < 0.0f && std::max({u, v, w}) > 0.0f) return std::nullopt;
    const float sum = u + v + w;
    if (sum == 0.0f) return std::nullopt;
    return Meeting{(u * a.z + v * b.z + w * c.z) / sum, glm::vec2(v, w) / sum};
  }

 private:
  static float edge(glm::vec3 p, glm::vec3 q) {
    return static_cast<float>(double(p.x) * double(q.y) - double(p.y) * double(q.x));
  }
  glm::vec3 sheared(glm::vec3 corner) const {
    const glm::vec3 from = corner - origin_;
    return {from[x_] - shear_.x * from[z_], from[y_] - shear_.y * from[z_], shear_.z * from[z_]};
  }

  glm::vec3 origin_;
  int x_, y_, z_;
  glm::vec3 shear_;
};

class OwnTree : public RayTree {
 public:
  OwnTree(const Scene& scene, const PrismsOfInstances& prisms);

  std::optional<Hit> hit(glm::vec3 origin, glm::vec3 direction, float nearest) const override;

 private:
  void addTriangles(const Scene& scene, std::uint32_t instance, std::vector<Box>& boxes);
  void addPrisms(const ReliefPrisms& prisms, std::uint32_t instance, std::vector<Box>& boxes);

  std::vector<Item> items_;  // as the tree has them
  BoxTree::Child root_ = {};
  std::vector<BoxTree::Node> nodes_;
  std::vector<const ReliefPrisms*> prisms_;  // of each instance; null: it has triangles
};

void OwnTree::addTriangles(const Scene& scene, std::uint32_t instance, std::vector<Box>& boxes) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[instance].mesh)];
  const glm::mat4& world_from_object = scene.instances[instance].world_from_object;
  for (std::uint32_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& position = mesh.vertices[mesh.indices[std::size_t{3} * triangle + i]].position;
      corners[i] = glm::vec3(world_from_object * glm::vec4(position, 1.0f));
    }
    if (!std::all_of(corners.begin(), corners.end(), isSmall)) continue;
    items_.push_back({instance, triangle, corners});
    boxes.push_back(boxOf(corners));
  }
}

void OwnTree::addPrisms(const ReliefPrisms& prisms, std::uint32_t instance, std::vector<Box>& boxes) {
  for (std::uint32_t triangle = 0; triangle < prisms.size(); ++triangle) {
    const PrismBounds bounds = prisms.boundsOf(triangle);
    if (!isSmall(bounds.low) || !isSmall(bounds.high)) continue;
    items_.push_back({instance, triangle, {}});
    boxes.push_back({bounds.low, bounds.high});
  }
}

OwnTree::OwnTree(const Scene& scene, const PrismsOfInstances& prisms) {
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const auto found = prisms.find(i);
    prisms_.push_back(found == prisms.end() ? nullptr : found->second.get());
    if (prisms_.back())
      addPrisms(*prisms_.back(), i, boxes);
    else
      addTriangles(scene, i, boxes);
  }
  if (items_.empty()) return;
  BoxTree tree = boxTree(boxes, kItemsOfLeaf, kDeepest);
  std::vector<Item> sorted;
  sorted.reserve(items_.size());
  for (const std::uint32_t item : tree.items) sorted.push_back(items_[item]);
  items_ = std::move(sorted);
  root_ = tree.root;
  nodes_ = std::move(tree.nodes);
}

/// The distance at which a ray enters a box, if it is within it somewhere between `nearest` and `farthest`; else
/// kBeyondAll. The far end is moved by the rounding of its computation (Ize 2013, "Robust BVH ray traversal").
float entryOf(const Box& box, glm::vec3 origin, glm::vec3 inverse, float nearest, float farthest) {
  const glm::vec3 a = (box.low - origin) * inverse, b = (box.high - origin) * inverse;
  const glm::vec3 enters = glm::min(a, b), leaves = glm::max(a, b);
  const float first = std::max({enters.x, enters.y, enters.z, nearest});
  const float last = std::min({leaves.x, leaves.y, leaves.z, farthest}) * 1.0000005f;
  return first <= last ? first : formula::kBeyondAll;
}

std::optional<Hit> OwnTree::hit(glm::vec3 origin, glm::vec3 direction, float nearest) const {
  if (items_.empty()) return std::nullopt;
  const ShearedRay ray(origin, direction);
  const glm::vec3 inverse = formula::inverseDirection(direction);
  std::optional<Hit> best;
  float farthest = formula::kBeyondAll;
  const auto meet = [&](const Item& item) {
    if (const ReliefPrisms* const prisms = prisms_[item.instance]) {
      const auto place = prisms->hit(item.triangle, origin, direction, nearest, farthest);
      if (!place || !(place->distance < farthest)) return;
      farthest = place->distance;
      best = Hit{farthest,           item.instance,           item.triangle,
                 place->barycentric, place->geometric_normal, Hit::Relief{place->position, place->up}};
    } else if (const auto met = ray.meet(item.corners); met && met->distance > nearest && met->distance < farthest) {
      farthest = met->distance;
      const glm::vec3 across = glm::cross(item.corners[1] - item.corners[0], item.corners[2] - item.corners[0]);
      best = Hit{farthest, item.instance, item.triangle, met->barycentric, normalOfMet(across, direction), {}};
    }
  };
  struct Waiting {
    const BoxTree::Child* child;
    float entry;
  };
  std::array<Waiting, kDeepest> waiting;
  std::size_t count = 0;
  waiting[count++] = {&root_, entryOf(root_.box, origin, inverse, nearest, farthest)};
  while (count > 0) {
    auto [child, entry] = waiting[--count];
    if (!(entry < farthest)) continue;
    while (child->count == 0) {
      const BoxTree::Node& node = nodes_[child->first];
      const BoxTree::Child *near_child = &node.children[0], *far_child = &node.children[1];
      float near_entry = entryOf(near_child->box, origin, inverse, nearest, farthest);
      float far_entry = entryOf(far_child->box, origin, inverse, nearest, farthest);
      if (far_entry < near_entry) {
        std::swap(near_child, far_child);
        std::swap(near_entry, far_entry);
      }
      if (far_entry < formula::kBeyondAll) waiting[count++] = {far_child, far_entry};
      if (near_entry == formula::kBeyondAll) break;
      child = near_child;
    }
    for (std::uint32_t i = 0; i < child->count; ++i) meet(items_[child->first + i]);
  }
  return best;
}

}  // namespace

Result<std::unique_ptr<RayTree>> ownTree(const Scene& scene, const PrismsOfInstances& prisms) {
  return Result<std::unique_ptr<RayTree>>(std::make_unique<OwnTree>(scene, prisms));
}

}  // namespace mirrorball
