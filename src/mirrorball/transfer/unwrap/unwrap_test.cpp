#include "mirrorball/transfer/unwrap/unwrap.h"

#include <algorithm>
#include <string>
#include <vector>

#include "mirrorball/transfer/simplify.h"
#include "mirrorball/transfer/texel_cover.h"
#include "mirrorball/transfer/transfer_testing.h"
#include "mirrorball/transfer/unwrap/flat_triangles.h"

namespace mirrorball {
namespace {

/// A mesh with one vertex a place.
Mesh welded(const Mesh& mesh) { return simplified(meshScene(mesh), mesh.indices.size())->mesh; }

/// Which triangles are in the map, and whether any lie over each other.
struct Coverage {
  std::size_t overlapping = 0;
  double share = 0.0;
};

Coverage coverageOf(const Mesh& mesh, int size) {
  std::vector<UvTriangle> triangles;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    UvTriangle& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = mesh.vertices[mesh.indices[i + k]].uv[0];
  }
  const auto cover = TexelCover::make(triangles, {size, size}, 2);
  std::vector<CoverSample> row(std::size_t(size) * 4);
  Coverage coverage;
  for (int y = 0; y < size; ++y) {
    coverage.overlapping += cover->coverRow(y, row);
    for (const CoverSample& sample : row) coverage.share += sample.triangle == CoverSample::kNothing ? 0.0 : 1.0;
  }
  coverage.share /= 4.0 * size * size;
  return coverage;
}

void expectSoundMap(const Mesh& before, const Unwrapped& after, int size) {
  ASSERT_EQ(after.mesh.indices.size(), before.indices.size());
  for (std::size_t i = 0; i < before.indices.size(); ++i)
    EXPECT_EQ(after.mesh.vertices[after.mesh.indices[i]].position, before.vertices[before.indices[i]].position);
  for (const Vertex& vertex : after.mesh.vertices) {
    EXPECT_TRUE(vertex.uv[0].x >= 0.0f && vertex.uv[0].x <= 1.0f && vertex.uv[0].y >= 0.0f && vertex.uv[0].y <= 1.0f);
    EXPECT_EQ(vertex.tangent.w, 1.0f);  // nothing is mirrored
  }
  const Coverage coverage = coverageOf(after.mesh, size);
  EXPECT_EQ(coverage.overlapping, 0u);
  EXPECT_NEAR(coverage.share, after.used, 0.01);
  EXPECT_GE(after.stretch, 1.0 - 1e-6);
  EXPECT_GE(after.worst_stretch, after.stretch);
}

TEST(Unwrapped, CubeHasSixSidesWithoutStretch) {
  const Mesh cube = welded(cubeMesh());
  const auto flat = unwrapped(cube, 256, 4);
  ASSERT_TRUE(flat) << flat.error().message;
  expectSoundMap(cube, *flat, 256);
  EXPECT_EQ(flat->charts, 6u);
  EXPECT_EQ(flat->mesh.vertices.size(), 24u);
  EXPECT_NEAR(flat->stretch, 1.0, 1e-5);
  EXPECT_NEAR(flat->worst_stretch, 1.0, 1e-5);
  EXPECT_GT(flat->used, 0.5);
}

TEST(Unwrapped, CurvedAndThinSurfacesDoNotOverlap) {
  for (const Mesh& made : {sphereMesh(32, 64), torusMesh(64, 32), knotMesh(96, 16)}) {
    const Mesh mesh = welded(made);
    const auto flat = unwrapped(mesh, 512, 4);
    ASSERT_TRUE(flat) << flat.error().message;
    expectSoundMap(mesh, *flat, 512);
    EXPECT_LT(flat->stretch, 1.35);
    EXPECT_LT(flat->worst_stretch, 4.0);
    EXPECT_GT(flat->used, 0.3);
    EXPECT_LT(flat->charts, 200u);
  }
}

// A strip wound like a spring, whose turns lie over each other when it is seen from above.
TEST(Unwrapped, SpringIsCutWhereItWouldCoverItself) {
  Mesh spring;
  constexpr int kSteps = 120;
  for (int i = 0; i <= kSteps; ++i)
    for (const float radius : {0.6f, 1.0f}) {
      const float angle = 0.2f * float(i);
      spring.vertices.emplace_back().position = {radius * std::cos(angle), radius * std::sin(angle), 0.02f * float(i)};
    }
  for (std::uint32_t i = 0; i < 2 * kSteps; i += 2)
    for (const std::uint32_t corner : {i, i + 1, i + 2, i + 2, i + 1, i + 3}) spring.indices.push_back(corner);
  computeNormals(spring);
  const auto flat = unwrapped(spring, 256, 4);
  ASSERT_TRUE(flat) << flat.error().message;
  expectSoundMap(spring, *flat, 256);
  EXPECT_GE(flat->charts, 4u);
  EXPECT_LE(flat->charts, 12u);
}

// No texel is touched by two charts, nor are neighbours across the gutter.
TEST(Unwrapped, ChartsKeepTheirDistance) {
  const auto flat = unwrapped(welded(cubeMesh()), 64, 6);
  ASSERT_TRUE(flat);
  const Mesh& mesh = flat->mesh;
  for (std::size_t side = 0; side < 6; ++side)
    for (std::size_t other = 0; other < side; ++other) {
      glm::vec2 apart(0.0f);
      const auto box = [&](std::size_t i) {
        glm::vec2 low(1e9f), high(-1e9f);
        for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
          low = glm::min(low, 64.0f * mesh.vertices[k].uv[0]);
          high = glm::max(high, 64.0f * mesh.vertices[k].uv[0]);
        }
        return std::pair(low, high);
      };
      const auto [low_a, high_a] = box(side);
      const auto [low_b, high_b] = box(other);
      apart = glm::max(low_a - high_b, low_b - high_a);
      EXPECT_GE(std::max(apart.x, apart.y), 5.0f) << side << " and " << other;
    }
}

TEST(Unwrapped, TakesTrianglesWithoutAreaAndOneAlone) {
  Mesh mesh = testing::plateMesh(2, [](glm::vec2) { return 0.0f; });
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 2, 2, 2});
  const auto flat = unwrapped(mesh, 64, 2);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_EQ(coverageOf(flat->mesh, 64).overlapping, 0u);

  Mesh one = testing::flatPlate();
  one.indices.resize(3);
  const auto triangle = unwrapped(one, 16, 2);
  ASSERT_TRUE(triangle);
  EXPECT_EQ(triangle->charts, 1u);
  EXPECT_GT(triangle->used, 0.15);
}

// A box around it would be a billion times as large as the triangle.
TEST(Unwrapped, ANeedleTakesNoTimeAndKeepsOthersAway) {
  Mesh mesh;
  for (const glm::vec3 place : {glm::vec3(0), glm::vec3(1, 1, 0), glm::vec3(1 - 1e-7f, 1, 0)})
    mesh.vertices.emplace_back().position = place;
  mesh.indices = {0, 1, 2};
  computeNormals(mesh);
  const auto alone = unwrapped(mesh, 64, 2);
  ASSERT_TRUE(alone) << alone.error().message;

  FlatTriangles flat(3);
  flat.setCell(1e-4);
  flat.add({glm::dvec2(0, 0), {1, 1}, {0.999, 1}});
  flat.add({glm::dvec2(2, 2), {2.0001, 2}, {2, 2.0001}});
  EXPECT_TRUE(flat.overlaps({glm::dvec2(0.4999, 0.5), {0.5001, 0.5}, {0.5, 0.5001}})) << "small, on the needle";
  EXPECT_FALSE(flat.overlaps({glm::dvec2(0.5, 0.4), {0.5001, 0.4}, {0.5, 0.4001}}));
  EXPECT_TRUE(flat.overlaps({glm::dvec2(1.9, 2), {2.1, 2}, {2, 2.1}})) << "wide itself, on a small one";
}

TEST(Unwrapped, SizesFromHugeToTinyAreTheSame) {
  for (const float scale : {1e-12f, 1e12f}) {
    Mesh mesh = welded(sphereMesh(16, 32));
    for (Vertex& vertex : mesh.vertices) vertex.position *= scale;
    const auto flat = unwrapped(mesh, 128, 2);
    ASSERT_TRUE(flat);
    EXPECT_EQ(coverageOf(flat->mesh, 128).overlapping, 0u);
    EXPECT_GT(flat->used, 0.3);
  }
}

TEST(Unwrapped, SaysWhereAMapIsTooSmall) {
  const auto flat = unwrapped(welded(sphereMesh(16, 32)), 8, 8);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().code, ErrorCode::out_of_range);
  EXPECT_NE(flat.error().message.find("8 x 8"), std::string::npos);
}

}  // namespace
}  // namespace mirrorball
