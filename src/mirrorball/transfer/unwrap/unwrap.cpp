#include "mirrorball/transfer/unwrap/unwrap.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "mirrorball/scene/tangents.h"
#include "mirrorball/transfer/unwrap/chart.h"
#include "mirrorball/transfer/unwrap/chart_packing.h"

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;

/// The mesh with the charts' places as texture coordinates; each chart has vertices of its own.
Mesh laidOut(const Mesh& mesh, const std::vector<Chart>& charts, const ChartPacking& packing, int size) {
  Mesh result = mesh;
  result.vertices.clear();
  for (std::size_t i = 0; i < charts.size(); ++i) {
    std::map<std::uint32_t, std::uint32_t> own;  // a vertex of the mesh → its copy for this chart
    for (std::size_t j = 0; j < charts[i].triangles.size(); ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t corner = std::size_t{3} * charts[i].triangles[j] + k;
        const auto [found, is_new] =
            own.emplace(mesh.indices[corner], static_cast<std::uint32_t>(result.vertices.size()));
        result.indices[corner] = found->second;
        if (!is_new) continue;
        const dvec2 place = (charts[i].corners[j][k] * packing.texels_per_unit + packing.corner[i]) / double(size);
        result.vertices.push_back(mesh.vertices[mesh.indices[corner]]);
        result.vertices.back().uv[0] = {float(place.x), float(1.0 - place.y)};  // up in the chart is up in the texture
      }
  }
  return result;
}

/// How a triangle's surface changes with its place in the texture.
struct Jacobian {
  dvec3 p_u{0.0}, p_v{0.0};
  double surface_area = 0.0, texture_area = 0.0;
};

Jacobian jacobianOf(const Mesh& mesh, std::size_t first) {
  const auto corner = [&](std::size_t k) -> const Vertex& { return mesh.vertices[mesh.indices[first + k]]; };
  const dvec3 edge1 = dvec3(corner(1).position) - dvec3(corner(0).position);
  const dvec3 edge2 = dvec3(corner(2).position) - dvec3(corner(0).position);
  const dvec2 step1 = dvec2(corner(1).uv[0]) - dvec2(corner(0).uv[0]);
  const dvec2 step2 = dvec2(corner(2).uv[0]) - dvec2(corner(0).uv[0]);
  const double determinant = step1.x * step2.y - step1.y * step2.x;
  Jacobian jacobian;
  jacobian.surface_area = 0.5 * glm::length(glm::cross(edge1, edge2));
  jacobian.texture_area = 0.5 * std::abs(determinant);
  if (determinant == 0.0) return jacobian;
  jacobian.p_u = (edge1 * step2.y - edge2 * step1.y) / determinant;
  jacobian.p_v = (edge2 * step1.x - edge1 * step2.x) / determinant;
  return jacobian;
}

/// The greatest length of a step of 1: the larger singular value.
double greatestLength(const Jacobian& jacobian) {
  const double a = glm::dot(jacobian.p_u, jacobian.p_u);
  const double b = glm::dot(jacobian.p_u, jacobian.p_v);
  const double c = glm::dot(jacobian.p_v, jacobian.p_v);
  return std::sqrt(0.5 * (a + c + std::sqrt((a - c) * (a - c) + 4.0 * b * b)));
}

void measureStretch(Unwrapped& unwrapped) {
  double surface = 0.0, texture = 0.0, squares = 0.0, worst = 0.0;
  for (std::size_t first = 0; first < unwrapped.mesh.indices.size(); first += 3) {
    const Jacobian jacobian = jacobianOf(unwrapped.mesh, first);
    surface += jacobian.surface_area;
    texture += jacobian.texture_area;
    squares +=
        0.5 * (glm::dot(jacobian.p_u, jacobian.p_u) + glm::dot(jacobian.p_v, jacobian.p_v)) * jacobian.surface_area;
    if (jacobian.surface_area > 0.0) worst = std::max(worst, greatestLength(jacobian));
  }
  unwrapped.used = texture;
  if (!(surface > 0.0 && texture > 0.0)) return;
  const double without = std::sqrt(surface / texture);
  unwrapped.stretch = std::sqrt(squares / surface) / without;
  unwrapped.worst_stretch = worst / without;
}

}  // namespace

Result<Unwrapped> unwrapped(const Mesh& mesh, int size, int gutter) {
  assert(size >= 1 && gutter >= 0);
  std::vector<Chart> charts = chartsOf(mesh);
  for (Chart& chart : charts) turnUpright(chart);
  const ChartPacking packing = packCharts(charts, size, gutter);
  if (packing.texels_per_unit == 0.0)
    return fail(ErrorCode::out_of_range, "its charts, " + std::to_string(charts.size()) +
                                             ", do not fit into a map of " + std::to_string(size) + " x " +
                                             std::to_string(size) + " texels; a larger map holds them");
  Unwrapped result{laidOut(mesh, charts, packing, size)};
  result.charts = charts.size();
  measureStretch(result);
  computeTangents(result.mesh);
  return result;
}

}  // namespace mirrorball
