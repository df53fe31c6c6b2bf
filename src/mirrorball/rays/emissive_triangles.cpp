#include "mirrorball/rays/emissive_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/color.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/rays/vertex_places.h"
#include "mirrorball/scene/unit_vector.h"

namespace mirrorball {
namespace {

/// The middle of a triangle and places near its corners, which a texture may tell apart.
constexpr std::array<glm::vec2, 4> kPlaces{glm::vec2(1.0f / 3.0f), {0.15f, 0.15f}, {0.7f, 0.15f}, {0.15f, 0.7f}};

}  // namespace

EmissiveTriangles::EmissiveTriangles(const Scene& scene, const std::vector<glm::mat3>& world_from_normal,
                                     const std::function<bool(std::uint32_t instance)>& counts)
    : scene_(scene), world_from_normal_(world_from_normal), kept_(scene.instances.size()) {
  const bool is_all_unlit = std::all_of(scene.materials.begin(), scene.materials.end(),
                                        [](const Material& material) { return material.unlit; });
  if (is_all_unlit) return;
  for (std::uint32_t instance = 0; instance < scene.instances.size(); ++instance) {
    const Material& material = materialOf(scene, instance);
    if ((material.emission == glm::vec3(0.0f) && !material.unlit) || (counts && !counts(instance))) continue;
    const std::size_t count = scene.meshes[std::size_t(scene.instances[instance].mesh)]->indices.size() / 3;
    kept_[instance].assign(count, 0);
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) add(instance, triangle);
  }
}

void EmissiveTriangles::add(std::uint32_t instance, std::uint32_t triangle) {
  const auto [a, b, c] = cornersFrom(scene_, instance, std::size_t{3} * triangle);
  const glm::vec3 across = glm::cross(b - a, c - a);
  const float area =
      hasPlainSquare(across) ? 0.5f * glm::length(across) : static_cast<float>(0.5 * glm::length(glm::dvec3(across)));
  float brightness = 0.0f;
  for (const glm::vec2 place : kPlaces)
    brightness += formula::luminance(emission({.instance = instance, .triangle = triangle, .barycentric = place}));
  const double power = double(area) * double(brightness) / double(kPlaces.size());
  if (!(power > 0.0) || !std::isfinite(power)) return;
  const glm::dvec3 middle = glm::dvec3(a + b + c) / 3.0;
  places_ += power * middle;
  squares_ += power * glm::dot(middle, middle);
  sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + power);
  triangles_.push_back({instance, triangle, area});
  kept_[instance][triangle] = static_cast<std::uint32_t>(triangles_.size());
}

EmissiveTriangles::Place EmissiveTriangles::chosen(glm::vec3 numbers) const {
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), double(numbers.x) * sums_.back());
  const auto number = std::min(static_cast<std::size_t>(found - sums_.begin()), triangles_.size() - 1);
  const Triangle& triangle = triangles_[number];
  const auto [a, b, c] = cornersFrom(scene_, triangle.instance, std::size_t{3} * triangle.triangle);
  // Evenly by area (Turk 1990, "Generating random points in triangles").
  const float root = std::sqrt(numbers.y);
  const glm::vec2 place(root * (1.0f - numbers.z), root * numbers.z);
  const Hit hit{.instance = triangle.instance,
                .triangle = triangle.triangle,
                .barycentric = place,
                .geometric_normal = directionOr(glm::cross(b - a, c - a), glm::vec3(0.0f))};
  return {hit, a + place.x * (b - a) + place.y * (c - a), density(hit)};
}

float EmissiveTriangles::density(const Hit& hit) const {
  const std::vector<std::uint32_t>& of_instance = kept_[hit.instance];
  if (of_instance.empty() || of_instance[hit.triangle] == 0) return 0.0f;
  const std::size_t number = of_instance[hit.triangle] - 1;
  const double power = sums_[number] - (number == 0 ? 0.0 : sums_[number - 1]);
  return static_cast<float>(power / sums_.back()) / triangles_[number].area;
}

float EmissiveTriangles::largestIrradiance(glm::vec3 place) const {
  const double power = sums_.back();
  const glm::dvec3 center = places_ / power;
  const glm::dvec3 away = glm::dvec3(place) - center;
  const double spread = std::max(squares_ / power - glm::dot(center, center), 0.0);
  constexpr double kLargest = 1e30;  // in the middle of a single triangle
  return static_cast<float>(std::min(power / std::max(glm::dot(away, away) + spread, 1e-30), kLargest));
}

glm::vec3 EmissiveTriangles::emission(const Hit& hit) const {
  return surfacePointAt(scene_, world_from_normal_[hit.instance], hit, ReliefKind::none).material.emission;
}

}  // namespace mirrorball
