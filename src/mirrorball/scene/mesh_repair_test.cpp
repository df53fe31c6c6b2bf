#include "mirrorball/scene/mesh_repair.h"

#include <limits>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A square in z = 0, of two triangles, whose normals lean towards +x by 30°.
Mesh leaningSquare() {
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
    Vertex& vertex = mesh.vertices.emplace_back();
    vertex.position = glm::vec3(corner, 0.0f);
    vertex.normal = {0.5f, 0.0f, 0.8660254f};
    vertex.uv[0] = corner;
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

TEST(RepairMesh, ChangesNothingOfASoundMesh) {
  Mesh mesh = leaningSquare();
  const MeshRepair repair = repairMesh(mesh);
  EXPECT_EQ(remarkOn(repair), "");
  const Mesh before = leaningSquare();
  EXPECT_EQ(mesh.indices, before.indices);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.vertices[i].normal, before.vertices[i].normal);
}

TEST(RepairMesh, MakesTheNormalsThatHaveNoDirectionAndNoOthers) {
  for (const glm::vec3 bad : {glm::vec3(0.0f), glm::vec3(kNan), glm::vec3(0, kInfinity, 0), glm::vec3(1, kNan, 0)}) {
    Mesh mesh = leaningSquare();
    mesh.vertices[1].normal = bad;
    EXPECT_EQ(remarkOn(repairMesh(mesh)), "1 normal has no direction and is made from the triangles around");
    EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1));
    for (const std::size_t kept : {0u, 2u, 3u})
      EXPECT_EQ(mesh.vertices[kept].normal, leaningSquare().vertices[kept].normal);
  }
}

TEST(RepairMesh, AVertexOfATriangleWithoutAreaGetsAHarmlessNormal) {
  Mesh mesh = leaningSquare();
  for (const float x : {0.0f, 0.1f, 0.2f}) {
    mesh.vertices.emplace_back().position = {x, 0, 0};
    mesh.vertices.back().normal = glm::vec3(0.0f);
  }
  mesh.indices.insert(mesh.indices.end(), {4, 5, 6});
  EXPECT_EQ(repairMesh(mesh).normals_made, 3u);
  EXPECT_EQ(mesh.indices.size(), 9u);
  EXPECT_EQ(mesh.vertices[0].normal, leaningSquare().vertices[0].normal);
  for (std::size_t i = 4; i < 7; ++i) EXPECT_EQ(glm::length(mesh.vertices[i].normal), 1.0f);
}

TEST(RepairMesh, LeavesOutTrianglesThatAreNowhereAndKeepsTheBox) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    Mesh mesh = leaningSquare();
    mesh.vertices[1].position.y = bad;
    EXPECT_EQ(remarkOn(repairMesh(mesh)), "1 triangle reaches NaN or infinity and is left out");
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.vertices[1].position, mesh.vertices[0].position);
  }
}

TEST(RepairMesh, LeavesOutTrianglesOfVerticesThatAreNotThere) {
  Mesh mesh = leaningSquare();
  mesh.indices = {0, 1, 4, 0, 2, 3, 4294967295u, 1, 2, 0, 1};
  EXPECT_EQ(remarkOn(repairMesh(mesh)), "2 triangles name vertices that are not there and are left out");
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(RepairMesh, NothingIsLeftWhereNothingIsSomewhere) {
  Mesh mesh = leaningSquare();
  for (Vertex& vertex : mesh.vertices) vertex.position.z = kNan;
  EXPECT_EQ(repairMesh(mesh).trianglesLeftOut(), 2u);
  EXPECT_TRUE(mesh.indices.empty());
  EXPECT_EQ(mesh.vertices[3].position, glm::vec3(0.0f));
  Mesh none;
  EXPECT_EQ(remarkOn(repairMesh(none)), "");
}

TEST(RepairMesh, CoordinatesAndColoursThatAreNoNumbersAreHarmless) {
  Mesh mesh = leaningSquare();
  mesh.vertices[2].uv[0].x = kNan;
  mesh.vertices[3].uv[1].y = kInfinity;
  mesh.vertices[3].color.a = kNan;
  EXPECT_EQ(remarkOn(repairMesh(mesh)),
            "2 texture coordinates hold NaN or infinity and are read as 0; 1 vertex colour holds NaN or infinity and "
            "is read as white");
  EXPECT_EQ(mesh.vertices[2].uv[0], glm::vec2(0.0f));
  EXPECT_EQ(mesh.vertices[3].uv[0], glm::vec2(0, 1));
  EXPECT_EQ(mesh.vertices[3].uv[1], glm::vec2(0.0f));
  EXPECT_EQ(mesh.vertices[3].color, glm::vec4(1.0f));
}

TEST(MeshRepair, AddsUp) {
  MeshRepair sum;
  Mesh mesh = leaningSquare();
  mesh.vertices[1].normal = glm::vec3(0.0f);
  sum += repairMesh(mesh);
  mesh = leaningSquare();
  mesh.vertices[1].normal = glm::vec3(kNan);
  sum += repairMesh(mesh);
  EXPECT_EQ(remarkOn(sum), "2 normals have no direction and are made from the triangles around");
}

}  // namespace
}  // namespace mirrorball
