#include "mirrorball/scene/shapes/revolution.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using glm::dvec2;

/// A point of the axis is one point, to whatever its cosine was rounded.
constexpr double kOnAxis = 1e-9;

/// The length of a profile up to each of its points, as a share of the whole.
std::vector<double> sharesOf(std::span<const ProfilePoint> profile) {
  std::vector<double> shares{0.0};
  for (std::size_t i = 1; i < profile.size(); ++i)
    shares.push_back(shares.back() + glm::distance(profile[i].place, profile[i - 1].place));
  for (double& share : shares) share /= shares.back();
  return shares;
}

/// The first vertex of a ring is there twice: its texture coordinates begin and end.
void addRing(Mesh& mesh, const ProfilePoint& point, double v, int segments) {
  const double radius = std::abs(point.place.x) < kOnAxis ? 0.0 : point.place.x;
  for (int segment = 0; segment <= segments; ++segment) {
    const double u = double(segment) / segments;
    const double longitude = 2.0 * std::numbers::pi * (segment == segments ? -0.5 : u - 0.5);
    const glm::dvec3 outwards(std::sin(longitude), 0.0, std::cos(longitude));
    Vertex vertex;
    vertex.position = glm::vec3(radius * outwards + glm::dvec3(0.0, point.place.y, 0.0));
    vertex.normal = glm::vec3(point.normal.x * outwards + glm::dvec3(0.0, point.normal.y, 0.0));
    vertex.tangent = glm::vec4(std::cos(longitude), 0.0, -std::sin(longitude), 1.0);
    vertex.uv[0] = vertex.uv[1] = glm::vec2(u, v);
    mesh.vertices.push_back(vertex);
  }
}

}  // namespace

void addArc(std::vector<ProfilePoint>& profile, dvec2 center, double radius, double first_deg, double last_deg,
            int steps) {
  assert(steps >= 1);
  for (int step = 0; step <= steps; ++step) {
    const double angle = glm::radians(std::lerp(first_deg, last_deg, double(step) / steps));
    const dvec2 normal(std::cos(angle), std::sin(angle));
    profile.push_back({center + radius * normal, normal});
  }
}

Mesh revolvedMesh(std::span<const ProfilePoint> profile, int segments) {
  assert(profile.size() >= 2 && segments >= 3);
  Mesh mesh;
  const std::vector<double> shares = sharesOf(profile);
  for (std::size_t i = 0; i < profile.size(); ++i) addRing(mesh, profile[i], shares[i], segments);
  addGridTriangles(mesh, 0, static_cast<int>(profile.size()) - 1, segments);
  return mesh;
}

}  // namespace mirrorball
