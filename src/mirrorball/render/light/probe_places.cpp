#include "mirrorball/render/light/probe_places.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

float radiusOf(const Box& box) { return glm::length(box.high - box.low) / 2.0f; }

bool isFlat(const Box& box) {
  constexpr float kFlat = 1.0f / 16.0f;
  const glm::vec3 side = box.high - box.low;
  return std::min({side.x, side.y, side.z}) <= kFlat * std::max({side.x, side.y, side.z});
}

}  // namespace

std::vector<Box> boxesOf(const Scene& scene) {
  std::vector<Box> boxes;
  for (const Instance& instance : scene.instances) boxes.push_back(boundingBox(scene, instance));
  return boxes;
}

bool liesIn(const Box& part, const Box& whole) {
  const glm::vec3 middle = part.center();
  return glm::all(glm::greaterThanEqual(middle, whole.low)) && glm::all(glm::lessThanEqual(middle, whole.high)) &&
         radiusOf(part) <= radiusOf(whole);
}

bool liesInside(const Box& part, const Box& whole) { return liesIn(part, whole) && !liesIn(whole, part); }

bool isReflective(const Material& material) {
  constexpr float kGlossy = 0.5f;  // perceptual roughness
  if (material.unlit) return false;
  return material.transmission > 0.0f || material.metallic >= 0.5f || material.clearcoat > 0.0f ||
         material.perceptual_roughness <= kGlossy;
}

std::vector<int> withParts(const Scene& scene, int instance) {
  const std::vector<Box> boxes = boxesOf(scene);
  std::vector<int> parts;
  for (int part = 0; part < static_cast<int>(boxes.size()); ++part)
    if (part == instance || liesIn(boxes[std::size_t(part)], boxes[std::size_t(instance)])) parts.push_back(part);
  return parts;
}

ProbePlaces probePlaces(const Scene& scene, int most) {
  const std::vector<Box> boxes = boxesOf(scene);
  std::vector<int> by_size;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (!boxes[std::size_t(i)].isEmpty()) by_size.push_back(i);
  sortDownBy(by_size, [&](int i) { return radiusOf(boxes[std::size_t(i)]); });
  std::vector<bool> is_taken(boxes.size(), false);
  ProbePlaces places;
  for (const int i : by_size) {
    const Box& box = boxes[std::size_t(i)];
    if (is_taken[std::size_t(i)] || !isReflective(materialOf(scene, std::size_t(i))) || isFlat(box)) continue;
    ReflectiveObject object{box.center(), radiusOf(box), {}};
    for (const int part : by_size) {
      if (is_taken[std::size_t(part)] || !liesIn(boxes[std::size_t(part)], box)) continue;
      is_taken[std::size_t(part)] = true;
      object.instances.push_back(part);
    }
    const bool has_probe = static_cast<int>(places.probes.size()) < most;
    (has_probe ? places.probes : places.others).push_back(std::move(object));
  }
  return places;
}

std::vector<float> probeShares(const ReflectiveObject& object, const std::vector<ReflectiveObject>& probes) {
  constexpr std::size_t kNearest = 3;
  std::vector<float> shares;
  for (const ReflectiveObject& probe : probes) {
    const glm::vec3 away = probe.middle - object.middle;
    shares.push_back(1.0f / std::max(glm::dot(away, away), 1e-30f));
  }
  if (shares.size() > kNearest) {
    std::vector<float> sorted = shares;
    std::nth_element(sorted.begin(), sorted.begin() + kNearest, sorted.end(), std::greater());
    for (float& share : shares)
      if (share <= sorted[kNearest]) share = 0.0f;
  }
  float sum = 0.0f;
  for (const float share : shares) sum += share;
  for (float& share : shares) share /= sum;
  return shares;
}

}  // namespace mirrorball
