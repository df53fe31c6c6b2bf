#include "mirrorball/scene/shapes/builtin_shapes.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A point of a parametric surface: `tangent` is the unit direction of growing u.
struct SurfacePoint {
  dvec3 position;
  dvec3 normal;
  dvec3 tangent;
};

Vertex vertexOf(const SurfacePoint& point, dvec2 uv) {
  Vertex vertex;
  vertex.position = glm::vec3(point.position);
  vertex.normal = glm::vec3(point.normal);
  vertex.tangent = glm::vec4(glm::vec3(point.tangent), 1.0f);
  vertex.uv[0] = vertex.uv[1] = glm::vec2(uv);
  return vertex;
}

/// Which of its two ends a surface joins to the other: the places there are the same numbers, of whatever digits the
/// sines at the beginning and the end of a turn are.
enum class Joined { in_u, in_both };

/// Samples `surface(u, v)` on a grid over [0, 1]². Seen from outside u grows to the right and v downwards.
template <typename Surface>
Mesh gridMesh(int rows, int columns, Joined joined, Surface&& surface) {
  Mesh mesh;
  mesh.vertices.reserve(std::size_t(rows + 1) * std::size_t(columns + 1));
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double u = static_cast<double>(column) / columns;
      const double v = static_cast<double>(row) / rows;
      const double joined_u = column == columns ? 0.0 : u;
      const double joined_v = joined == Joined::in_both && row == rows ? 0.0 : v;
      mesh.vertices.push_back(vertexOf(surface(joined_u, joined_v), {u, v}));
    }
  }
  addGridTriangles(mesh, 0, rows, columns);
  return mesh;
}

/// A flat square of the given half side about `middle`.
void addSquare(Mesh& mesh, dvec3 middle, dvec3 right, dvec3 up, double half_side) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const dvec3 normal = glm::cross(right, up);
  for (const dvec2 uv : {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1), dvec2(1, 1)}) {
    const dvec3 offset = right * (2.0 * uv.x - 1.0) + up * (1.0 - 2.0 * uv.y);
    mesh.vertices.push_back(vertexOf({middle + offset * half_side, normal, right}, uv));
  }
  addGridTriangles(mesh, first, 1, 1);
}

/// The tube of radius `tube` about the (2, 3) torus knot c(s) on the torus of radii 2 and 1 about the Z axis.
SurfacePoint knotPoint(double u, double v, double tube) {
  const double s = kTurn * u;
  const dvec3 radial(std::cos(2 * s), std::sin(2 * s), 0);   // away from the axis
  const dvec3 around(-std::sin(2 * s), std::cos(2 * s), 0);  // radial' = 2 around, around' = −2 radial
  const double wide = std::cos(3 * s);
  const double high = std::sin(3 * s);
  const double distance = 2 + wide;  // of c from the axis
  const dvec3 axis(0, 0, 1);

  const dvec3 center = distance * radial + high * axis;
  const dvec3 velocity = -3 * high * radial + 2 * distance * around + 3 * wide * axis;
  const dvec3 acceleration = (-9 * wide - 4 * distance) * radial - 12 * high * around - 9 * high * axis;

  // The frame that closes without a seam: the curve lies on a torus, whose normal n turns with the curve, stands at
  // right angles to it, and returns to itself after one round.
  const dvec3 tangent = glm::normalize(velocity);
  const dvec3 n = wide * radial + high * axis;
  const dvec3 n_derivative = -3 * high * radial + 2 * wide * around + 3 * wide * axis;
  const dvec3 b = glm::cross(tangent, n);

  const double angle = kTurn * v;
  const dvec3 normal = std::cos(angle) * n + std::sin(angle) * b;
  const dvec3 sideways = -std::sin(angle) * n + std::cos(angle) * b;  // growing v

  // p_u = c′ + tube (cos n′ + sin b′), whose part along the curve is shortened or stretched by the curve's bending,
  // and whose part around the tube is the turning of the frame.
  const dvec3 bending = acceleration / glm::length(velocity);  // up to a part along the tangent
  const double along = glm::length(velocity) - tube * glm::dot(normal, bending);
  const double turning = tube * glm::dot(n_derivative, b);
  return {center + tube * normal, normal, glm::normalize(along * tangent + turning * sideways)};
}

}  // namespace

void addGridTriangles(Mesh& mesh, std::uint32_t first, int rows, int columns) {
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::vec3 p = mesh.vertices[a].position;
    const glm::vec3 q = mesh.vertices[b].position;
    const glm::vec3 r = mesh.vertices[c].position;
    if (p != q && q != r && r != p) mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  mesh.indices.reserve(mesh.indices.size() + std::size_t(rows) * std::size_t(columns) * 6);
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t top_left = first + row * stride + column;
      const std::uint32_t bottom_left = top_left + stride;
      add(top_left, bottom_left, bottom_left + 1);
      add(top_left, bottom_left + 1, top_left + 1);
    }
  }
}

void fitToUnitSphere(Mesh& mesh) {
  Scene scene = meshScene(std::move(mesh));
  const BoundingSphere bounds = boundingSphere(scene);
  mesh = *scene.meshes.front();
  for (Vertex& vertex : mesh.vertices) vertex.position = (vertex.position - bounds.center) / bounds.radius;
}

void fitToUnitSphere(Scene& scene) {
  const BoundingSphere bounds = boundingSphere(scene);
  const glm::mat4 fitted = glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / bounds.radius)), -bounds.center);
  for (Instance& instance : scene.instances) instance.world_from_object = fitted * instance.world_from_object;
}

Mesh sphereMesh(int rings, int segments) {
  assert(rings >= 2 && segments >= 3);
  return gridMesh(rings, segments, Joined::in_u, [](double u, double v) {
    const double longitude = kTurn * (u - 0.5);
    const double colatitude = std::numbers::pi * v;
    // The sine is 0 at the lower pole too, where that of the rounded π is not: the pole is one point.
    const double ring = v == 1.0 ? 0.0 : std::sin(colatitude);
    const dvec3 position(std::sin(longitude) * ring, std::cos(colatitude), std::cos(longitude) * ring);
    return SurfacePoint{position, position, dvec3(std::cos(longitude), 0, -std::sin(longitude))};
  });
}

Mesh torusMesh(int segments, int sides) {
  assert(segments >= 3 && sides >= 3);
  constexpr double kMainRadius = 0.7;
  constexpr double kTubeRadius = 1.0 - kMainRadius;
  return gridMesh(sides, segments, Joined::in_both, [](double u, double v) {
    const double longitude = kTurn * (u - 0.5);
    const double angle = kTurn * (0.5 - v);  // 0 at the outer equator, growing upwards
    const dvec3 outwards(std::sin(longitude), 0, std::cos(longitude));
    const dvec3 normal = std::cos(angle) * outwards + dvec3(0, std::sin(angle), 0);
    return SurfacePoint{kMainRadius * outwards + kTubeRadius * normal, normal,
                        dvec3(std::cos(longitude), 0, -std::sin(longitude))};
  });
}

Mesh knotMesh(int segments, int sides) {
  assert(segments >= 12 && sides >= 3);
  constexpr double kTube = 0.55;  // thick enough for broad reflections, and strands do not touch
  Mesh mesh = gridMesh(sides, segments, Joined::in_both, [](double u, double v) { return knotPoint(u, v, kTube); });
  fitToUnitSphere(mesh);
  return mesh;
}

Mesh planeMesh() {
  Mesh mesh;
  addSquare(mesh, dvec3(0), dvec3(1, 0, 0), dvec3(0, 0, -1), std::numbers::sqrt2 / 2);
  return mesh;
}

Mesh cubeMesh() {
  struct Face {
    dvec3 right;
    dvec3 up;
  };
  constexpr std::array<Face, 6> kFaces = {{
      {{0, 0, -1}, {0, 1, 0}},  // +X
      {{0, 0, 1}, {0, 1, 0}},   // −X
      {{1, 0, 0}, {0, 0, -1}},  // +Y
      {{1, 0, 0}, {0, 0, 1}},   // −Y
      {{1, 0, 0}, {0, 1, 0}},   // +Z
      {{-1, 0, 0}, {0, 1, 0}},  // −Z
  }};
  constexpr double kHalfSide = std::numbers::inv_sqrt3;
  Mesh mesh;
  for (const Face& face : kFaces)
    addSquare(mesh, glm::cross(face.right, face.up) * kHalfSide, face.right, face.up, kHalfSide);
  return mesh;
}

}  // namespace mirrorball
