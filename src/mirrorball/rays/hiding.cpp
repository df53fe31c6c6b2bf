#include "mirrorball/rays/hiding.h"

#include "mirrorball/rays/surface_point.h"

namespace mirrorball {
namespace {

/// Surfaces that one ray may pass, then the next counts as solid.
constexpr int kMostPassed = 32;

}  // namespace

std::uint32_t mixed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t state = (a * 747796405u + 2891336453u) ^ (b * 0x9E3779B9u + 0x7F4A7C15u);
  state = state * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

glm::vec2 sharesOf(std::uint32_t bits) { return glm::vec2(bits & 0xFFFFu, bits >> 16u) / 65536.0f; }

bool isCulled(const Material& material, const Hit& hit, glm::vec3 direction) {
  return !material.double_sided && !isBody(material) && glm::dot(direction, hit.geometric_normal) > 0.0f;
}

std::optional<Hit> hidingHit(const Scene& scene, const Geometry& geometry, glm::vec3 origin, glm::vec3 direction,
                             std::uint32_t random) {
  float nearest = 0.0f;
  for (int passed = 0; passed <= kMostPassed; ++passed) {
    const std::optional<Hit> hit = geometry.hit(origin, direction, nearest);
    if (!hit) return std::nullopt;
    const Material& material = materialOf(scene, hit->instance);
    const float hides =
        isCulled(material, *hit, direction) ? 0.0f : opacityAt(scene, *hit) * (1.0f - material.transmission);
    if (hides >= 1.0f || passed == kMostPassed || sharesOf(mixed(random, std::uint32_t(passed))).x < hides) return hit;
    nearest = hit->distance * (1.0f + 1e-5f);
  }
  return std::nullopt;
}

}  // namespace mirrorball
