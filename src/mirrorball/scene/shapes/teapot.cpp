#include "mirrorball/scene/shapes/teapot.h"

#include <cassert>
#include <cstddef>
#include <span>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using glm::dvec3;

/// A round row of control points about the Y axis: each quarter circle is a cubic from (radius, 0) over
/// (radius, aside) and (aside, radius) to (0, radius). The data take 0.56 · radius for `aside` (a circle would be
/// best matched by 0.5523), but for the lid's knob.
struct RoundRow {
  double radius;
  double height;
  double aside;
};

constexpr RoundRow roundRow(double radius, double height) { return {radius, height, 0.56 * radius}; }

constexpr RoundRow kLid[] = {
    roundRow(0, 3.15),  {0.8, 3.15, 0.45},   roundRow(0, 2.85),  // knob
    roundRow(0.2, 2.7), roundRow(0.4, 2.55), roundRow(1.3, 2.55), roundRow(1.3, 2.4),
};

constexpr RoundRow kBody[] = {
    roundRow(1.4, 2.4),  roundRow(1.3375, 2.53125), roundRow(1.4375, 2.53125),  // rim
    roundRow(1.5, 2.4),  roundRow(1.75, 1.875),     roundRow(2, 1.35),          // upper body
    roundRow(2, 0.9),    roundRow(2, 0.45),         roundRow(1.5, 0.225),       // lower body
    roundRow(1.5, 0.15), roundRow(1.5, 0.075),      roundRow(1.425, 0),        roundRow(0, 0),
};

/// A row of control points around the handle or the spout, which are symmetric in z: from the inner point in the plane
/// z = 0 over half_width to the outer point, and back on the other side.
struct TubeRow {
  double inner_x;
  double inner_y;
  double outer_x;
  double outer_y;
  double half_width;
};

constexpr TubeRow kHandle[] = {
    {-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3.0, 2.25, 0.3},
    {-2.7, 1.8, -3.0, 1.8, 0.3},    {-2.7, 1.575, -3.0, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2.0, 0.9, -1.9, 0.6, 0.3},
};

constexpr TubeRow kSpout[] = {
    {1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66},     {2.3, 2.1, 2.4, 2.025, 0.25},
    {2.7, 2.4, 3.3, 2.4, 0.25},   {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
};

constexpr std::size_t kLidPatches = 8;

using ControlLoop = std::vector<dvec3>;  // closed: the last point is the first

/// From −Z over −X, +Z and +X: to the right as seen from outside.
ControlLoop loopOf(const RoundRow& row) {
  constexpr dvec3 kQuarters[] = {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};
  const dvec3 up(0, row.height, 0);
  ControlLoop loop = {up + kQuarters[0] * row.radius};
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec3 from = kQuarters[i];
    const dvec3 to = kQuarters[i + 1];
    loop.push_back(up + from * row.radius + to * row.aside);
    loop.push_back(up + from * row.aside + to * row.radius);
    loop.push_back(up + to * row.radius);
  }
  return loop;
}

ControlLoop loopOf(const TubeRow& row) {
  const auto inner = [&](double z) { return dvec3(row.inner_x, row.inner_y, z); };
  const auto outer = [&](double z) { return dvec3(row.outer_x, row.outer_y, z); };
  const double z = row.half_width;
  return {inner(0), inner(-z), outer(-z), outer(0), outer(z), inner(z), inner(0)};
}

/// Cuts rows of control points, of which neighbouring patches share every third, into patches.
template <typename Row>
void addPatches(std::vector<BezierPatch>& patches, std::span<const Row> rows) {
  std::vector<ControlLoop> loops;
  for (const Row& row : rows) loops.push_back(loopOf(row));
  for (std::size_t top = 0; top + 3 < loops.size(); top += 3) {
    for (std::size_t left = 0; left + 3 < loops[top].size(); left += 3) {
      BezierPatch& patch = patches.emplace_back();
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) patch[row][column] = loops[top + row][left + column];
    }
  }
}

/// A cubic Bézier curve and its derivative at t, by de Casteljau's construction.
struct CurvePoint {
  dvec3 position;
  dvec3 derivative;
};
CurvePoint curveAt(const std::array<dvec3, 4>& control, double t) {
  const auto between = [t](dvec3 a, dvec3 b) { return a + (b - a) * t; };
  const dvec3 a = between(control[0], control[1]);
  const dvec3 b = between(control[1], control[2]);
  const dvec3 c = between(control[2], control[3]);
  const dvec3 left = between(a, b);
  const dvec3 right = between(b, c);
  return {between(left, right), 3.0 * (right - left)};
}

Vertex patchVertex(const BezierPatch& patch, double u, double v) {
  std::array<dvec3, 4> positions;
  std::array<dvec3, 4> derivatives;
  for (std::size_t row = 0; row < 4; ++row) {
    const CurvePoint point = curveAt(patch[row], u);
    positions[row] = point.position;
    derivatives[row] = point.derivative;
  }
  const CurvePoint down = curveAt(positions, v);
  const CurvePoint across = curveAt(derivatives, v);

  // At the middle of the lid and of the bottom a whole edge is one point and p_u is 0; its direction is then that
  // which it has just inside, ±p_uv.
  dvec3 growing_u = across.position;
  if (glm::length(growing_u) < 1e-9) growing_u = v < 0.5 ? across.derivative : -across.derivative;

  Vertex vertex;
  vertex.position = glm::vec3(down.position);
  vertex.normal = glm::vec3(glm::normalize(glm::cross(down.derivative, growing_u)));
  vertex.tangent = glm::vec4(glm::vec3(glm::normalize(growing_u)), 1.0f);
  vertex.uv[0] = vertex.uv[1] = glm::vec2(u, v);
  return vertex;
}

}  // namespace

std::vector<BezierPatch> teapotPatches() {
  std::vector<BezierPatch> patches;
  addPatches(patches, std::span<const RoundRow>(kLid));
  addPatches(patches, std::span<const RoundRow>(kBody));
  addPatches(patches, std::span<const TubeRow>(kHandle));
  addPatches(patches, std::span<const TubeRow>(kSpout));
  return patches;
}

Mesh teapotMesh(int divisions) {
  assert(divisions >= 2);
  std::vector<BezierPatch> patches = teapotPatches();
  const double widening = kBody[0].radius / kLid[std::size(kLid) - 1].radius;
  for (std::size_t i = 0; i < kLidPatches; ++i)
    for (auto& row : patches[i])
      for (dvec3& point : row) point *= dvec3(widening, 1, widening);

  Mesh mesh;
  for (const BezierPatch& patch : patches) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int row = 0; row <= divisions; ++row)
      for (int column = 0; column <= divisions; ++column)
        mesh.vertices.push_back(
            patchVertex(patch, static_cast<double>(column) / divisions, static_cast<double>(row) / divisions));
    addGridTriangles(mesh, first, divisions, divisions);
  }
  fitToUnitSphere(mesh);
  return mesh;
}

}  // namespace mirrorball
