#include "mirrorball/rays/relief_prisms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mirrorball/scene/relief/prism_list.h"
#include "mirrorball/scene/relief/relief_surface.h"

namespace mirrorball {
namespace {

/// So far from the surface, in heights, a place may lie that is taken for one of it. A ray that goes on into the next
/// prism below the surface is said to meet it at the prism's side.
constexpr float kOnSurface = 0.02f;
/// How far a ray goes on from such a place, or from the one that it has just passed, in depths of the relief.
constexpr float kPassed = 2e-3f;
constexpr int kMostPrismsPassed = 16;

formula::ReliefPrism placed(const formula::ReliefPrism& prism, const glm::mat4& world_from_object) {
  const glm::mat3 linear(world_from_object);
  formula::ReliefPrism world = prism;
  world.a = glm::vec3(world_from_object * glm::vec4(prism.a, 1.0f));
  for (glm::vec3* along : {&world.along_x, &world.along_y, &world.up, &world.up_along_x, &world.up_along_y})
    *along = linear * *along;
  return world;
}

/// The same prism with its bottom as the top.
formula::ReliefPrism turnedOver(formula::ReliefPrism prism) {
  prism.a -= prism.up;
  prism.along_x -= prism.up_along_x;
  prism.along_y -= prism.up_along_y;
  prism.up = -prism.up;
  prism.up_along_x = -prism.up_along_x;
  prism.up_along_y = -prism.up_along_y;
  prism.joined = glm::vec3(0.0f);
  prism.heights = glm::vec2(1.0f - prism.heights.y, 1.0f - prism.heights.x);
  return prism;
}

glm::vec3 upAt(const formula::ReliefPrism& p, glm::vec2 q) { return p.up + q.x * p.up_along_x + q.y * p.up_along_y; }

float surfaceHeight(const HeightTexture& heights, const formula::ReliefPrism& prism, glm::vec2 q) {
  const glm::vec3 place = formula::onHeightMap(prism, {q, 0.0f});
  return formula::heightAt(heights, heightMapOf(heights), glm::vec2(place));
}

/// The normal of the bilinear patch: across how the place changes with x and with y.
glm::vec3 patchNormal(const HeightTexture& heights, const formula::ReliefPrism& prism, glm::vec3 q) {
  const glm::vec2 place(formula::onHeightMap(prism, q));
  const glm::vec2 first = glm::floor(place), part = place - first;
  const glm::vec4 c = formula::patchCorners(heights, heightMapOf(heights), first);
  const glm::vec2 slope = formula::slopeOfPatch(c, part);
  const glm::vec3 up = upAt(prism, glm::vec2(q));
  const glm::vec3 along_x = prism.along_x + (q.z - 1.0f) * prism.up_along_x + glm::dot(slope, prism.texel_along_x) * up;
  const glm::vec3 along_y = prism.along_y + (q.z - 1.0f) * prism.up_along_y + glm::dot(slope, prism.texel_along_y) * up;
  return glm::normalize(glm::cross(along_x, along_y));
}

}  // namespace

bool hasBack(const Material& material) { return material.transmission > 0.0f || material.double_sided; }

Result<void> TwoSidedHeights::makeDepths() {
  if (depths) return {};
  MIRRORBALL_TRY(below, heightTexture(turnedOver(heights.heights), heights.edges));
  depths = std::move(below);
  return {};
}

ReliefPrisms::ReliefPrisms(const Scene& scene, std::size_t instance, const TwoSidedHeights& heights)
    : heights_(heights), has_back_(hasBack(materialOf(scene, instance))) {
  const Instance& placing = scene.instances[instance];
  const Mesh& mesh = scene.meshes[std::size_t(placing.mesh)];
  const std::vector<glm::vec3> joined = joinedSides(mesh);
  const float reach = reachOf(mesh);
  prisms_.reserve(joined.size());
  for (std::size_t triangle = 0; triangle < joined.size(); ++triangle) {
    formula::ReliefPrism prism = reliefPrism(mesh, 3 * triangle, materialOf(scene, instance), heights.heights);
    prism.joined = joined[triangle];
    prism.heights = heightsBelow(prism, heights.heights.bounds, reach);
    const formula::ReliefPrism world = placed(prism, placing.world_from_object);
    prisms_.push_back({world, formula::boxOfPrism(world)});
  }
}

PrismBounds ReliefPrisms::boundsOf(std::size_t triangle) const {
  const formula::ReliefPrism& prism = prisms_[triangle].from_above;
  PrismBounds bounds{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  const glm::vec2 slab = formula::slabOfPrism(prism);
  // A place depends on each coordinate alone evenly, and so lies between the corners.
  for (const glm::vec2 corner : {glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f)})
    for (const float height : {slab.x - formula::kBeyond, slab.y + formula::kBeyond}) {
      const glm::vec3 place = formula::placeInPrism(prism, {corner, height});
      bounds.low = glm::min(bounds.low, place);
      bounds.high = glm::max(bounds.high, place);
    }
  const glm::vec3 margin = 1e-5f * (bounds.high - bounds.low) + 1e-6f * glm::max(abs(bounds.low), abs(bounds.high));
  return {bounds.low - margin, bounds.high + margin};
}

/// The first place where a ray meets one side of the surface.
std::optional<ReliefPlace> ReliefPrisms::placeOn(bool from_above, const formula::ReliefPrism& prism, glm::vec3 origin,
                                                 glm::vec3 direction, glm::vec2 between, float nearest) const {
  const HeightTexture& heights = from_above ? heights_.heights : *heights_.depths;
  const formula::ReliefPrism side = from_above ? prism : turnedOver(prism);
  const float step = kPassed * glm::length(prism.up);
  for (int passed = 0; passed < kMostPrismsPassed && between.x < between.y; ++passed) {
    const formula::ReliefHit found =
        formula::hitOfPrism(heights, heightMapOf(heights), side, origin, direction, between.x, between.y);
    if (found.distance < 0.0f) return std::nullopt;
    const glm::vec2 q(found.coordinates);
    const float found_height = from_above ? found.coordinates.z : 1.0f - found.coordinates.z;
    const float height = surfaceHeight(heights_.heights, prism, q);
    const glm::vec3 normal = patchNormal(heights_.heights, prism, {q, height});
    const bool is_passed = nearest > 0.0f && found.distance <= nearest + step;
    const bool is_on_surface = std::abs(found_height - height) < kOnSurface;
    // Where the sides of prisms are bent, a ray that has just left the surface may seem to be below it in the next one.
    const bool is_met = from_above == (glm::dot(direction, normal) < 0.0f);
    if (!is_passed && is_on_surface && is_met)
      return ReliefPlace{found.distance, q, formula::placeInPrism(prism, {q, height}), upAt(prism, q), normal};
    between.x = found.distance + step;
  }
  return std::nullopt;
}

std::optional<ReliefPlace> ReliefPrisms::hit(std::size_t triangle, glm::vec3 origin, glm::vec3 direction, float nearest,
                                             float farthest) const {
  const Placed& prism = prisms_[triangle];
  const glm::vec2 way = formula::wayThroughPrismBox(prism.box, origin, direction);
  const glm::vec2 between(std::max(way.x, nearest), std::min(way.y, farthest));
  const auto above = placeOn(true, prism.from_above, origin, direction, between, nearest);
  if (!has_back_) return above;
  // Each side by itself: what seems to be the one must not hide the other just behind it.
  const glm::vec2 up_to_above(between.x, above ? above->distance : between.y);
  const auto below = placeOn(false, prism.from_above, origin, direction, up_to_above, nearest);
  return below ? below : above;
}

}  // namespace mirrorball
