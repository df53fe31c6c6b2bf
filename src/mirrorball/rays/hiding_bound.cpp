#include "mirrorball/rays/hiding_bound.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/scene/bodies/box_tree.h"
#include "mirrorball/scene/closed_surface.h"

namespace mirrorball {
namespace {

/// The sine of the angle above a plane up to which all may be hidden: that share is its square.
constexpr float kLowSine = 0.2f;
/// Of the sky above, what may be hidden: with the other share a tenth.
constexpr float kMostHidden = 0.1f - kLowSine * kLowSine;
/// Parts of a scene that cover more of the sky are looked at one by one. A box that covers less and rises higher than a
/// low one does cannot hold a surface that runs on from the place, which would be nearer.
constexpr float kSmallShare = 1.0f / 512.0f;
/// What rounding may lift above a plane, over the size of the scene.
constexpr float kRounding = 1e-6f;
/// Triangles that one is compared with, after which it may hide much: fans and strips of many long ones.
constexpr std::size_t kMostCompared = 1 << 16;
constexpr std::uint32_t kTrianglesOfLeaf = 4;
constexpr int kLongestWay = 64;

struct Ball {
  glm::vec3 center{0.0f};
  float radius = 0.0f;
};

Ball ballAround(const Box& box) { return {box.center(), 0.5f * glm::distance(box.low, box.high)}; }

/// The most of the sky that a ball covers for a place within another one: (radius / distance)² where it is straight
/// above.
float coveredShare(const Ball& around, const Ball& ball) {
  const float distance = glm::distance(ball.center, around.center) - around.radius;
  return distance > ball.radius ? ball.radius * ball.radius / (distance * distance) : 1.0f;
}

/// Ericson 2005, "Real-Time Collision Detection", 5.1.5: by the region of the triangle's plane that a point lies over.
glm::vec3 closestPoint(const std::array<glm::vec3, 3>& t, glm::vec3 p) {
  const glm::vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1], cp = p - t[2];
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d1 <= 0.0f && d2 <= 0.0f) return t[0];
  if (d3 >= 0.0f && d4 <= d3) return t[1];
  if (d6 >= 0.0f && d5 <= d6) return t[2];
  const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return t[0] + d1 / (d1 - d3) * ab;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return t[0] + d2 / (d2 - d6) * ac;
  if (va <= 0.0f && d4 >= d3 && d5 >= d6) return t[1] + (d4 - d3) / (d4 - d3 + d5 - d6) * (t[2] - t[1]);
  return t[0] + (vb * ab + vc * ac) / (va + vb + vc);
}

/// 5.1.9 there.
float distanceOfSegments(glm::vec3 p1, glm::vec3 q1, glm::vec3 p2, glm::vec3 q2) {
  const glm::vec3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const float a = glm::dot(d1, d1), e = glm::dot(d2, d2), b = glm::dot(d1, d2), c = glm::dot(d1, r);
  const float f = glm::dot(d2, r), across = a * e - b * b;
  float s = across > 0.0f ? std::clamp((b * f - c * e) / across, 0.0f, 1.0f) : 0.0f;
  float t = e > 0.0f ? (b * s + f) / e : 0.0f;
  if (t < 0.0f || t > 1.0f) {
    t = std::clamp(t, 0.0f, 1.0f);
    s = a > 0.0f ? std::clamp((b * t - c) / a, 0.0f, 1.0f) : 0.0f;
  }
  return glm::distance(p1 + s * d1, p2 + t * d2);
}

/// Of two triangles that do not cut each other.
float distanceOfTriangles(const std::array<glm::vec3, 3>& a, const std::array<glm::vec3, 3>& b) {
  float distance = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    distance =
        std::min({distance, glm::distance(a[i], closestPoint(b, a[i])), glm::distance(b[i], closestPoint(a, b[i]))});
    for (std::size_t k = 0; k < 3; ++k)
      distance = std::min(distance, distanceOfSegments(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]));
  }
  return distance;
}

Box boxAround(const std::array<glm::vec3, 3>& corners) {
  Box box;
  for (const glm::vec3& corner : corners) box.include({corner, corner});
  return box;
}

class HidingBound {
 public:
  HidingBound(const Scene& scene, std::span<const std::uint8_t> shows_back);

  /// Whether it is true of all triangles.
  bool isLittle() const;

 private:
  bool mayHideMuch(const PlacedTriangle& viewer) const;
  bool isLow(const PlacedTriangle& viewer, const PlacedTriangle& other) const;

  std::vector<PlacedTriangle> triangles_;
  std::vector<std::uint8_t> shows_back_;  // of each triangle
  std::vector<std::uint32_t> hiders_;     // the triangles that the tree has, by its items
  BoxTree tree_;
  float rounding_ = 0.0f;
};

HidingBound::HidingBound(const Scene& scene, std::span<const std::uint8_t> shows_back) {
  std::vector<Box> boxes;
  Box all;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    for (std::size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
      const PlacedTriangle placed = placedTriangle(mesh, instance, triangle);
      const Box box = boxAround(placed.corners);
      if (!isFinite(box.low) || !isFinite(box.high) || placed.geometric_normal == glm::vec3(0.0f)) continue;
      triangles_.push_back(placed);
      shows_back_.push_back(shows_back[i]);
      all.include(box);
      if (scene.materials[std::size_t(mesh.material)].transmission >= 1.0f) continue;  // hidingHit passes it
      hiders_.push_back(static_cast<std::uint32_t>(triangles_.size() - 1));
      boxes.push_back(box);
    }
  }
  if (boxes.empty()) return;
  tree_ = boxTree(boxes, kTrianglesOfLeaf, kLongestWay);
  rounding_ = kRounding * std::max(glm::distance(all.low, all.high), glm::length(glm::max(-all.low, all.high)));
}

/// Whether another triangle reaches above a triangle's plane by a small angle only, seen from anywhere on it.
bool HidingBound::isLow(const PlacedTriangle& viewer, const PlacedTriangle& other) const {
  glm::vec3 heights;
  for (int i = 0; i < 3; ++i)
    heights[i] = glm::dot(other.corners[std::size_t(i)] - viewer.corners[0], viewer.geometric_normal);
  const float highest = std::max({heights.x, heights.y, heights.z});
  if (highest <= rounding_) return true;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 corner = other.corners[std::size_t(i)];
    if (heights[i] > rounding_ &&
        !(heights[i] <= kLowSine * glm::distance(corner, closestPoint(viewer.corners, corner))))
      return false;
  }
  // Of two that touch, one may lie over the other although its corners, beyond it, are low. That is found from the one
  // above, since the corners of the one below are straight in front of it.
  const float distance = distanceOfTriangles(viewer.corners, other.corners);
  return highest <= kLowSine * distance || distance <= rounding_;
}

bool HidingBound::mayHideMuch(const PlacedTriangle& viewer) const {
  const Ball around = ballAround(boxAround(viewer.corners));
  float hidden = 0.0f;
  std::array<BoxTree::Child, kLongestWay + 2> waiting;
  std::size_t count = 0;
  std::size_t compared = 0;
  waiting[count++] = tree_.root;
  while (count > 0) {
    const BoxTree::Child part = waiting[--count];
    const glm::vec3 highest =
        glm::mix(part.box.low, part.box.high, glm::vec3(glm::greaterThan(viewer.geometric_normal, glm::vec3(0.0f))));
    const float height = glm::dot(highest - viewer.corners[0], viewer.geometric_normal);
    const Ball ball = ballAround(part.box);
    const float away = glm::distance(ball.center, around.center) - around.radius - ball.radius;
    if (height <= rounding_ || height <= kLowSine * away) continue;
    const float share = coveredShare(around, ball);
    if (share <= kSmallShare) {
      hidden += share;
      if (hidden > kMostHidden) return true;
    } else if (part.count == 0) {
      for (const BoxTree::Child& child : tree_.nodes[part.first].children) waiting[count++] = child;
    } else {
      for (std::uint32_t i = 0; i < part.count; ++i) {
        if (++compared > kMostCompared) return true;
        const PlacedTriangle& other = triangles_[hiders_[tree_.items[part.first + i]]];
        if (!isLow(viewer, other)) hidden += coveredShare(around, ballAround(boxAround(other.corners)));
      }
      if (hidden > kMostHidden) return true;
    }
  }
  return false;
}

bool HidingBound::isLittle() const {
  if (hiders_.empty()) return true;
  std::atomic<bool> is_little = true;
  parallelFor(triangles_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && is_little; ++i)
      if (mayHideMuch(triangles_[i]) || (shows_back_[i] != 0 && mayHideMuch(triangles_[i].turnedOver())))
        is_little = false;
  });
  return is_little;
}

}  // namespace

bool hidesLittleSurely(const Scene& scene, std::span<const std::uint8_t> shows_back) {
  // The most usual convex body is recognised without a tree.
  if (scene.instances.size() == 1 && shows_back[0] == 0 && isBall(scene.meshes[std::size_t(scene.instances[0].mesh)]))
    return true;
  return HidingBound(scene, shows_back).isLittle();
}

}  // namespace mirrorball
