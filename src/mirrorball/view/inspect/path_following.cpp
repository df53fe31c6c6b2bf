#include "mirrorball/view/inspect/path_following.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "formula/bodies.h"
#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/surface.h"
#include "mirrorball/rays/surface_finder.h"
#include "mirrorball/rays/surface_shares.h"
#include "mirrorball/view/inspect/lobe_outline.h"

namespace mirrorball {
namespace {

constexpr float kFaintestShare = 1e-3f;
/// A further surface that has half of its lobe farther away than that is matt.
constexpr float kWidestHalfLobe_rad = 0.5236f;  // 30°

glm::vec3 placeOf(const PathVertex& vertex) {
  const Hit& hit = vertex.hit;
  return hit.relief ? hit.relief->position : vertex.arriving.origin + hit.distance * vertex.arriving.direction;
}

/// Not where the normal of a file is no number, and so neither is the share.
bool hasLight(glm::vec3 share) { return std::max({share.x, share.y, share.z}) > 0.0f; }

bool isMatt(const PathVertex& vertex) {
  return formula::ggxHalfAngle(vertex.point.material.perceptual_roughness) > kWidestHalfLobe_rad;
}

/// The way of more light at a further surface; nothing: none stands for what it shows.
std::optional<RayTurn> turnAt(const PathVertex& vertex, const SurfaceShares& shares) {
  if (hasLight(shares.refracted) && formula::luminance(shares.refracted) >= formula::luminance(shares.reflected))
    return RayTurn::refracted;
  if (!hasLight(shares.reflected) || isMatt(vertex)) return std::nullopt;
  return shares.is_total ? RayTurn::totally_reflected : RayTurn::reflected;
}

glm::vec3 directionAfter(const PathVertex& vertex, RayTurn turn) {
  const glm::vec3 n = frameOnRaysSide(vertex).n;
  return turn == RayTurn::refracted ? refractedDirection(vertex, n) : reflectedDirection(vertex, n);
}

/// The lobe of a surface that the eye sees, as maps show it. What a thin wall lets through is as wide as what it
/// reflects (KHR_materials_transmission); of bodies the refracted lobe is left out.
std::vector<glm::vec3> lobeAt(const PathVertex& vertex, RayTurn turn, const LightAround& around) {
  constexpr float kShare = 0.5f;
  constexpr int kDirections = 64;
  constexpr float kSmoothAlpha = 1e-4f;  // as narrow as a float's direction
  const formula::Material& material = vertex.point.material;
  const glm::vec2 alpha = formula::stretchedAlpha(material.perceptual_roughness, material.anisotropy);
  const bool is_refracted = turn == RayTurn::refracted;
  if (std::max(alpha.x, alpha.y) < kSmoothAlpha || (is_refracted && !vertex.surface->thin_walled)) return {};
  const Frame frame = frameOnRaysSide(vertex);
  std::vector<glm::vec3> lobe =
      lobeOutline(glm::max(alpha, kSmoothAlpha), frame.toLocal(-vertex.arriving.direction), kShare, kDirections);
  for (glm::vec3& direction : lobe) {
    if (is_refracted) direction.z = -direction.z;
    direction = environmentDirection(around, placeOf(vertex), frame.toWorld(direction));
  }
  return lobe;
}

}  // namespace

std::optional<RayPath> followedPath(const PathWorld& world, const PathVertex& first, bool is_refracted) {
  SurfaceFinder finder(world.scene, world.geometry, world.relief, [] { return 0.0f; });
  PathVertex vertex = first;
  SurfaceShares shares = sharesAt(first);
  if (!hasLight(is_refracted ? shares.refracted : shares.reflected)) return std::nullopt;
  std::optional<RayTurn> turn = RayTurn::refracted;
  if (!is_refracted) turn = shares.is_total ? RayTurn::totally_reflected : RayTurn::reflected;
  glm::vec3 share(1.0f);
  RayPath path;
  while (true) {
    share *= *turn == RayTurn::refracted ? shares.refracted : shares.reflected;
    if (std::max({share.x, share.y, share.z}) < kFaintestShare) {
      path.end = PathEnd::faint;
      return path;
    }
    Ray ray = leavingRay(vertex, directionAfter(vertex, *turn));
    const glm::vec3 from = placeOf(vertex);
    path.segments.push_back(
        {from, from + world.reach * ray.direction, *turn, formula::fillingBody(ray.media) >= 0, share});
    const auto hit = finder.first(ray, INFINITY, false, share);
    if (!hit) {
      path.direction = environmentDirection(world.around, ray.origin, ray.direction);
      path.radiance = radianceOf(world.around, path.direction);
      if (path.segments.size() == 1) path.lobe = lobeAt(first, *turn, world.around);
      return path;
    }
    vertex = pathVertexAt(world.scene, world.world_from_normal, *hit, ray, world.relief);
    path.segments.back().to = placeOf(vertex);
    shares = sharesAt(vertex);
    turn = turnAt(vertex, shares);
    if (turn && path.segments.size() < std::size_t(world.most_segments)) continue;
    path.end = turn ? PathEnd::limit : PathEnd::matt;
    return path;
  }
}

}  // namespace mirrorball
