#include "mirrorball/scene/relief/displaced_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/scene/relief/relief_surface.h"

namespace mirrorball {
namespace {

/// Triangles narrower than a texel, which follow the bend of its patch, may be so many of the most.
constexpr double kShareOfFineTriangles = 0.25;
constexpr double kFinest = 1.0 / 16.0;  // texels

/// Whether a place is a number, and near enough for texels to be told apart.
bool isOnTexture(glm::dvec2 place) { return std::abs(place.x) < 1e7 && std::abs(place.y) < 1e7; }

/// A corner of a piece of a triangle.
struct Corner {
  std::uint32_t vertex;
  unsigned edges;  ///< on which of the triangle's three it lies: a bit for each
};

/// A convex piece of a triangle. Each of four cuts makes at most one corner more out of three.
struct Piece {
  std::array<Corner, 8> corners;
  std::size_t count = 0;

  void add(Corner corner) {
    assert(count < corners.size());
    corners[count++] = corner;
  }
};

Vertex between(const Vertex& a, const Vertex& b, float t) {
  Vertex vertex;
  vertex.position = glm::mix(a.position, b.position, t);
  vertex.normal = glm::mix(a.normal, b.normal, t);
  vertex.tangent = glm::vec4(glm::mix(glm::vec3(a.tangent), glm::vec3(b.tangent), t), a.tangent.w);
  for (int set = 0; set < 2; ++set) vertex.uv[set] = glm::mix(a.uv[set], b.uv[set], t);
  vertex.color = glm::mix(a.color, b.color, t);
  return vertex;
}

/// Vertices that were put on edges, by the two at the ends of what of the edge was whole.
using CutEdges = std::unordered_map<std::uint64_t, std::uint32_t>;

/// Cuts a mesh along a grid on its texture.
class MeshCutter {
 public:
  /// step   from line to line [texels]
  MeshCutter(const Mesh& mesh, const Material& material, const HeightTexture& heights, double step)
      : base_(mesh), material_(material), heights_(heights), step_(step), first_(mesh.vertices.size()) {
    cut_ = base_;
    cut_.indices.clear();
    cut_.first_of_relief = first_;
    cut_.vertices.insert(cut_.vertices.end(), base_.vertices.begin(), base_.vertices.end());
    normals_.assign(cut_.vertices.size(), glm::vec3(0.0f));
    const glm::dvec2 texels = double(material.height_frequency) * glm::dvec2(heightMapOf(heights).size);
    for (const Vertex& vertex : cut_.vertices) places_.push_back((glm::dvec2(vertex.uv[0]) * texels - 0.5) / step);
  }

  Mesh cut() {
    for (std::size_t first = 0; first + 2 < base_.indices.size(); first += 3) cutTriangle(first);
    displace();
    return std::move(cut_);
  }

 private:
  void cutTriangle(std::size_t first);
  void cutStrip(Piece strip);
  void fill(const Piece& piece);
  Piece cutOff(Piece& rest, int axis, double line);
  Corner cutEdge(Corner a, Corner b, int axis, double line);
  void addNormal(std::uint32_t vertex);
  double least(const Piece& piece, int axis) const;
  void displace();

  const Mesh& base_;
  const Material& material_;
  const HeightTexture& heights_;
  double step_;
  std::size_t first_;               // of the vertices that have triangles: those before stay where they are
  Mesh cut_;                        // until displace() where the base is, with its normals
  std::vector<glm::dvec2> places_;  // of its vertices, in steps
  std::vector<glm::vec3> normals_;  // for shading, sums over the triangles around
  CutEdges of_triangles_;
  CutEdges on_last_line_, on_next_line_;  // of the strip that is being cut
  formula::ReliefPrism prism_{};          // of the triangle that is being cut
};

double MeshCutter::least(const Piece& piece, int axis) const {
  double least = INFINITY;
  for (std::size_t i = 0; i < piece.count; ++i) least = std::min(least, places_[piece.corners[i].vertex][axis]);
  return least;
}

/// The normal that the triangle says there is at a vertex.
void MeshCutter::addNormal(std::uint32_t vertex) {
  // Its place in the prism: least squares on the triangle.
  const glm::dvec3 x(prism_.along_x), y(prism_.along_y), off(cut_.vertices[vertex].position - prism_.a);
  const double xx = glm::dot(x, x), xy = glm::dot(x, y), yy = glm::dot(y, y);
  const double area = xx * yy - xy * xy;
  if (area <= 0.0) return;
  const double ox = glm::dot(off, x), oy = glm::dot(off, y);
  const glm::vec2 x_y((ox * yy - oy * xy) / area, (oy * xx - ox * xy) / area);
  const glm::vec3 normal = reliefNormal(heights_, prism_, material_.height_scale, x_y);
  if (!glm::any(glm::isnan(normal))) normals_[vertex] += normal;
}

/// The vertex where a line crosses an edge.
Corner MeshCutter::cutEdge(Corner a, Corner b, int axis, double line) {
  if (places_[a.vertex][axis] > places_[b.vertex][axis]) std::swap(a, b);
  const unsigned edges = a.edges & b.edges;
  const std::uint64_t key = std::uint64_t{a.vertex} << 32 | b.vertex;
  CutEdges& cuts = edges != 0 ? of_triangles_ : on_next_line_;
  if (edges == 0)
    if (const auto found = on_last_line_.find(key); found != on_last_line_.end()) return {found->second, 0};
  const auto [found, is_new] = cuts.try_emplace(key, static_cast<std::uint32_t>(cut_.vertices.size()));
  if (is_new) {
    const glm::dvec2 from = places_[a.vertex], to = places_[b.vertex];
    const double t = (line - from[axis]) / (to[axis] - from[axis]);
    cut_.vertices.push_back(between(cut_.vertices[a.vertex], cut_.vertices[b.vertex], static_cast<float>(t)));
    places_.push_back(glm::mix(from, to, t));
    places_.back()[axis] = line;
    normals_.emplace_back(0.0f);
  }
  if (is_new || edges != 0) addNormal(found->second);
  return {found->second, edges};
}

/// Cuts off what lies before a line, and leaves the rest.
Piece MeshCutter::cutOff(Piece& rest, int axis, double line) {
  Piece before, after;
  const auto side = [&](const Corner& corner) { return places_[corner.vertex][axis] - line; };
  bool is_after = false;
  for (std::size_t i = 0; i < rest.count; ++i) {
    const Corner& here = rest.corners[i];
    const Corner& next = rest.corners[(i + 1) % rest.count];
    if (side(here) <= 0.0) before.add(here);
    if (side(here) >= 0.0) after.add(here);
    is_after = is_after || side(here) > 0.0;
    if (side(here) * side(next) >= 0.0) continue;
    const Corner cut = cutEdge(here, next, axis, line);
    before.add(cut);
    after.add(cut);
  }
  rest = is_after ? after : Piece{};
  return before;
}

void MeshCutter::fill(const Piece& piece) {
  for (std::size_t i = 2; i < piece.count; ++i)
    for (const std::size_t corner : {std::size_t{0}, i - 1, i}) cut_.indices.push_back(piece.corners[corner].vertex);
}

void MeshCutter::cutStrip(Piece strip) {
  for (double line = std::floor(least(strip, 1)) + 1.0; strip.count > 0; line += 1.0) fill(cutOff(strip, 1, line));
  on_last_line_ = std::exchange(on_next_line_, {});
}

void MeshCutter::cutTriangle(std::size_t first) {
  prism_ = reliefPrism(base_, first, material_, heights_);
  Piece rest;
  bool is_on_texture = true;
  for (unsigned i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::uint32_t>(first_ + base_.indices[first + i]);
    rest.add({vertex, 1u << i | 1u << (i + 2) % 3});
    is_on_texture = is_on_texture && isOnTexture(places_[vertex]);
  }
  if (!is_on_texture) return fill(rest);
  for (const Corner& corner : {rest.corners[0], rest.corners[1], rest.corners[2]}) addNormal(corner.vertex);
  on_last_line_.clear();
  for (double line = std::floor(least(rest, 0)) + 1.0; rest.count > 0; line += 1.0) cutStrip(cutOff(rest, 0, line));
}

void MeshCutter::displace() {
  const formula::HeightMap map = heightMapOf(heights_);
  for (std::size_t i = first_; i < cut_.vertices.size(); ++i) {
    Vertex& vertex = cut_.vertices[i];
    const glm::vec2 place(places_[i] * step_);
    if (!isOnTexture(places_[i])) continue;
    const float height = formula::heightAt(heights_, map, place);
    vertex.position += (height - 1.0f) * material_.height_scale * vertex.normal;
    if (glm::dot(normals_[i], normals_[i]) > 0.0f) vertex.normal = glm::normalize(normals_[i]);
  }
}

/// How many triangles a mesh becomes, rather too many.
double trianglesOf(const Mesh& mesh, const Material& material, const HeightTexture& heights, double step) {
  double triangles = 0.0;
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const formula::ReliefPrism prism = reliefPrism(mesh, first, material, heights);
    const glm::dvec2 x = glm::dvec2(prism.texel_along_x) / step, y = glm::dvec2(prism.texel_along_y) / step;
    const double cells = 0.5 * std::abs(x.x * y.y - x.y * y.x);
    const glm::dvec2 lines = glm::abs(x) + glm::abs(y) + glm::abs(x - y);
    const bool is_cut = isOnTexture(x) && isOnTexture(y) && isOnTexture(glm::dvec2(prism.texel) / step);
    triangles += is_cut ? 1.0 + 2.0 * (cells + lines.x + lines.y) : 1.0;
  }
  return triangles;
}

const HeightTexture* heightsOf(const Scene& scene, const Mesh& mesh) {
  const Material& material = scene.materials[std::size_t(mesh.material)];
  if (material.height == HeightKind::none || material.height_texture < 0 || !hasTextureCoordinates(mesh))
    return nullptr;
  return &*scene.height_textures[std::size_t(material.height_texture)];
}

double trianglesOf(const Scene& scene, double step) {
  double triangles = 0.0;
  for (const Mesh& mesh : scene.meshes)
    if (const HeightTexture* heights = heightsOf(scene, mesh))
      triangles += trianglesOf(mesh, scene.materials[std::size_t(mesh.material)], *heights, step);
  return triangles;
}

/// From line to line, in texels: a power of 2 times the widest.
double stepFor(Scene& scene, const DisplacementSettings& settings) {
  const auto most = static_cast<double>(settings.max_triangles);
  const double widest = double(settings.texels_per_triangle);
  double step = widest;
  while (step > kFinest && trianglesOf(scene, 0.5 * step) <= kShareOfFineTriangles * most) step *= 0.5;
  constexpr double kCoarsest = 0x1p40;
  while (step < kCoarsest && trianglesOf(scene, step) > most) step *= 2.0;
  if (step > widest)
    scene.warnings.push_back("relief as geometry: " + std::to_string(settings.max_triangles) +
                             " triangles at most, so that each is " + std::to_string(std::llround(step)) +
                             " texels of the heights wide");
  return step;
}

}  // namespace

Result<void> displaceMeshes(Scene& scene, const DisplacementSettings& settings) {
  const double step = stepFor(scene, settings);
  constexpr double kBytesPerTriangle = 60.0;
  MIRRORBALL_TRY_VOID(withName("relief as geometry",
                               checkMemory(static_cast<std::uint64_t>(trianglesOf(scene, step) * kBytesPerTriangle))));
  for (Shared<Mesh>& mesh : scene.meshes) {
    const Material& material = scene.materials[std::size_t(mesh->material)];
    if (const HeightTexture* heights = heightsOf(scene, mesh))
      mesh = MeshCutter(mesh, material, *heights, step).cut();
    else if (material.height_texture >= 0)
      scene.warnings.push_back("relief as geometry: a mesh has no texture coordinates, and stays as it is");
  }
  for (Material& material : scene.materials) {
    if (material.height_texture < 0) continue;
    material.height = HeightKind::none;
    material.height_texture = -1;
  }
  scene.height_textures.clear();
  return {};
}

}  // namespace mirrorball
