#include "mirrorball/scene/relief/displaced_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/scene/relief/relief_surface.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// Heights that no bilinear patch of another size can show.
Image rough(int width, int height) {
  Image heights(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      heights.texel(x, y)[0] = static_cast<float>((x * 37 + y * 61 + x * y * 13) % 101) / 100.0f;
  return heights;
}

Scene sceneWith(Mesh mesh, Image heights, MapEdges edges, float frequency = 1.0f, float scale = 0.1f) {
  Material material;
  material.height = HeightKind::map;
  material.height_texture = 0;
  material.height_scale = scale;
  material.height_frequency = frequency;
  Scene scene = meshScene(std::move(mesh), material);
  auto texture = heightTexture(std::move(heights), edges);
  EXPECT_TRUE(texture);
  scene.height_textures.push_back(std::move(*texture));
  return scene;
}

Mesh displaced(Scene scene, const DisplacementSettings& settings = {}) {
  const auto done = displaceMeshes(scene, settings);
  EXPECT_TRUE(done) << done.error().message;
  return scene.meshes[0];
}

/// The area on the texture of all triangles; below 0: they are seen from behind there.
double areaOnTexture(const Mesh& mesh, double& least) {
  double sum = 0.0;
  least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto uv = [&](std::size_t k) { return glm::dvec2(mesh.vertices[mesh.indices[i + k]].uv[0]); };
    const glm::dvec2 x = uv(1) - uv(0), y = uv(2) - uv(0);
    const double area = 0.5 * (x.y * y.x - x.x * y.y);
    least = std::min(least, area);
    sum += area;
  }
  return sum;
}

/// The edges that only one triangle has, as pairs of vertices.
std::vector<std::pair<std::uint32_t, std::uint32_t>> openEdges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t from = mesh.indices[i], to = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    ++count[{from, to}];
    --count[{to, from}];
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const auto& [edge, n] : count)
    if (n > 0) open.push_back(edge);
  return open;
}

struct Map {
  int width, height;
  MapEdges edges;
  float frequency;
};

void PrintTo(const Map& map, std::ostream* out) { *out << map.width << " x " << map.height << " * " << map.frequency; }

class DisplacedMeshTest : public ::testing::TestWithParam<Map> {};

TEST_P(DisplacedMeshTest, PutsThePlanesVerticesOnTheSurface) {
  const Map map = GetParam();
  const Scene scene = sceneWith(planeMesh(), rough(map.width, map.height), map.edges, map.frequency);
  const HeightTexture& heights = scene.height_textures[0];
  const Mesh mesh = displaced(scene);
  const glm::vec2 texels = map.frequency * glm::vec2(map.width, map.height);
  for (const std::uint32_t index : mesh.indices) {
    const Vertex& vertex = mesh.vertices[index];
    const float h = formula::heightAt(heights, heightMapOf(heights), vertex.uv[0] * texels - glm::vec2(0.5f));
    ASSERT_NEAR(vertex.position.y, 0.1f * (h - 1.0f), 1e-4f) << vertex.uv[0].x << ", " << vertex.uv[0].y;
    ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f);
    ASSERT_GT(vertex.normal.y, 0.0f);
  }
}

TEST_P(DisplacedMeshTest, CoversTheTextureOnceAndHasNoGaps) {
  const Map map = GetParam();
  const Mesh mesh = displaced(sceneWith(planeMesh(), rough(map.width, map.height), map.edges, map.frequency));
  double least = 0.0;
  EXPECT_NEAR(areaOnTexture(mesh, least), 1.0, 1e-5);
  EXPECT_GE(least, -1e-9);
  for (const auto& [from, to] : openEdges(mesh)) {
    const glm::vec2 middle = 0.5f * (mesh.vertices[from].uv[0] + mesh.vertices[to].uv[0]);
    const float to_border = std::min({middle.x, middle.y, 1.0f - middle.x, 1.0f - middle.y});
    ASSERT_NEAR(to_border, 0.0f, 1e-6f) << middle.x << ", " << middle.y;
  }
}

TEST_P(DisplacedMeshTest, NoTriangleIsWiderThanATexel) {
  const Map map = GetParam();
  const Mesh mesh = displaced(sceneWith(planeMesh(), rough(map.width, map.height), map.edges, map.frequency));
  const glm::vec2 texel = 1.0f / (map.frequency * glm::vec2(map.width, map.height));
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const glm::vec2 edge = mesh.vertices[mesh.indices[i]].uv[0] - mesh.vertices[mesh.indices[next]].uv[0];
    ASSERT_LE(std::abs(edge.x), texel.x * 1.001f);
    ASSERT_LE(std::abs(edge.y), texel.y * 1.001f);
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, DisplacedMeshTest,
                         ::testing::Values(Map{1, 1, MapEdges::tiled, 1.0f}, Map{1, 5, MapEdges::clamped, 1.0f},
                                           Map{13, 7, MapEdges::tiled, 2.7f}, Map{13, 7, MapEdges::clamped, 0.3f},
                                           Map{64, 64, MapEdges::tiled, 2.0f}));

/// But for its seam and the triangles at its poles, which do not share their vertices.
TEST(DisplacedMesh, ASphereStaysClosed) {
  constexpr int kRings = 8;
  const Mesh mesh = displaced(sceneWith(sphereMesh(kRings, 16), rough(32, 16), MapEdges::tiled, 1.0f));
  for (const auto& [from, to] : openEdges(mesh)) {
    const float u = mesh.vertices[from].uv[0].x;
    const float v = 0.5f * (mesh.vertices[from].uv[0].y + mesh.vertices[to].uv[0].y);
    const bool is_at_pole = std::abs(v - 0.5f) > 0.5f - 1.0f / kRings;
    ASSERT_TRUE(is_at_pole || std::abs(u) < 1e-6f || std::abs(u - 1.0f) < 1e-6f) << u;
  }
  for (const Vertex& vertex : mesh.vertices) {
    ASSERT_LE(glm::length(vertex.position), 1.0f + 1e-5f);
    ASSERT_GE(glm::length(vertex.position), 0.87f);
  }
}

TEST(DisplacedMesh, LeavesTheModelAsLarge) {
  Scene scene = sceneWith(planeMesh(), rough(16, 16), MapEdges::tiled);
  const BoundingSphere before = boundingSphere(scene);
  ASSERT_TRUE(displaceMeshes(scene));
  EXPECT_EQ(boundingSphere(scene).center, before.center);
  EXPECT_EQ(boundingSphere(scene).radius, before.radius);
}

TEST(DisplacedMesh, FollowsAPatchsBend) {
  // Between two triangles of a patch this surface is 0.5 high or 0 in the middle; it is 0.25.
  Image saddle(2, 2, 1);
  saddle.texel(1, 1)[0] = 1.0f;
  const Mesh mesh = displaced(sceneWith(planeMesh(), std::move(saddle), MapEdges::clamped));
  const auto middle = std::ranges::find_if(
      mesh.vertices, [](const Vertex& v) { return glm::distance(v.uv[0], glm::vec2(0.5f)) < 1e-6f; });
  ASSERT_NE(middle, mesh.vertices.end());
  EXPECT_NEAR(middle->position.y, -0.075f, 1e-6f);
}

TEST(DisplacedMesh, MakesTrianglesWiderThanTexelsRatherThanTooMany) {
  Scene scene = sceneWith(planeMesh(), rough(64, 64), MapEdges::tiled, 1000.0f);
  ASSERT_TRUE(displaceMeshes(scene, {.max_triangles = 50'000}));
  EXPECT_LE(scene.meshes[0]->indices.size() / 3, 50'000u);
  EXPECT_GE(scene.meshes[0]->indices.size() / 3, 5'000u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0],
            "relief as geometry: 50000 triangles at most, so that each is 512 texels of the heights wide");
}

TEST(DisplacedMesh, LeavesWhatHasNoTextureCoordinates) {
  Mesh mesh = planeMesh();
  for (Vertex& vertex : mesh.vertices) vertex.uv[0] = glm::vec2(0.0f);
  Scene scene = sceneWith(std::move(mesh), rough(4, 4), MapEdges::tiled);
  ASSERT_TRUE(displaceMeshes(scene));
  EXPECT_EQ(scene.meshes[0]->vertices.size(), planeMesh().vertices.size());
  EXPECT_EQ(scene.meshes[0]->vertices[0].position, planeMesh().vertices[0].position);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.materials[0].height, HeightKind::none);
  EXPECT_EQ(scene.materials[0].height_texture, -1);
}

TEST(DisplacedMesh, BearsCoordinatesThatAreNoNumbersOrLieOnALine) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    Mesh mesh = planeMesh();
    mesh.vertices[0].uv[0].x = bad;
    const Mesh cut = displaced(sceneWith(std::move(mesh), rough(4, 4), MapEdges::tiled), {.max_triangles = 10'000});
    EXPECT_GE(cut.indices.size(), 6u) << bad;
    EXPECT_LE(cut.indices.size() / 3, 10'000u) << bad;
    for (const Vertex& vertex : cut.vertices) EXPECT_FALSE(glm::any(glm::isnan(vertex.position))) << bad;
  }
  Mesh line = planeMesh();
  for (Vertex& vertex : line.vertices) vertex.uv[0].y = 0.625f;  // on a line of the grid
  const Mesh cut = displaced(sceneWith(std::move(line), rough(4, 4), MapEdges::tiled));
  double area = 0.0;
  for (std::size_t i = 0; i < cut.indices.size(); i += 3) {
    const auto flat = [&](std::size_t k) {
      const glm::vec3 p = cut.vertices[cut.indices[i + k]].position;
      return glm::dvec2(p.x, p.z);
    };
    const glm::dvec2 x = flat(1) - flat(0), y = flat(2) - flat(0);
    area += 0.5 * std::abs(x.x * y.y - x.y * y.x);
  }
  EXPECT_NEAR(area, 2.0, 1e-5);
}

}  // namespace
}  // namespace mirrorball
