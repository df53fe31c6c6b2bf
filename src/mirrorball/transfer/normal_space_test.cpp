#include "mirrorball/transfer/normal_space.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "formula/tangent.h"
#include "mirrorball/transfer/transfer_testing.h"

namespace mirrorball {
namespace {

using testing::degreesBetween;

Image constantNormals(int width, int height, glm::vec3 n) {
  Image normals(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) normals.texel(x, y)[channel] = n[channel];
  return normals;
}

TEST(NormalsInSpace, OfFlatMapsAreTheNormalsOfTheSphere) {
  const Scene model = meshScene(sphereMesh(64, 128));
  const auto object = normalsInSpace(constantNormals(128, 64, {0, 0, 1}), model, NormalSpace::object);
  ASSERT_TRUE(object) << object.error().message;
  const auto surface = MappedSurface::make(model);
  const auto cover = TexelCover::make(surface->uvTriangles(), {128, 64}, 1);
  std::vector<CoverSample> row(128);
  for (int y = 0; y < 64; ++y) {
    cover->coverRow(y, row);
    for (int x = 0; x < 128; ++x) {
      if (row[std::size_t(x)].triangle == CoverSample::kNothing) continue;
      const glm::vec3 outwards = glm::normalize(surface->at(row[std::size_t(x)]).position);
      EXPECT_LT(degreesBetween(rgbAt(*object, x, y), outwards), 0.05f) << x << ", " << y;
    }
  }
}

TEST(NormalsInSpace, GoThereAndBack) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> side(-1.0f, 1.0f);
  Image normals(64, 48, 3);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::vec3 n = glm::normalize(glm::vec3(side(random), side(random), 1.1f + side(random)));
      for (int channel = 0; channel < 3; ++channel) normals.texel(x, y)[channel] = n[channel];
    }
  Scene turned = meshScene(knotMesh(64, 16));
  turned.instances[0].world_from_object =
      glm::mat4({0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0.5f, 0.5f, 0}, {5, 6, 7, 1});  // not even by the same to all sides
  for (const Scene& model :
       {meshScene(sphereMesh(16, 32)), meshScene(torusMesh(32, 16)), meshScene(cubeMesh()), turned}) {
    const auto object = normalsInSpace(normals, model, NormalSpace::object);
    const auto back = normalsInSpace(*object, model, NormalSpace::tangent);
    ASSERT_TRUE(back);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) EXPECT_LT(degreesBetween(rgbAt(*back, x, y), rgbAt(normals, x, y)), 0.1f);
  }
}

// Whose squares are below the least float, or nearly.
TEST(NormalsInSpace, AreUnitVectorsOfTinyOnes) {
  const Scene model = meshScene(torusMesh(32, 16));
  const auto object = normalsInSpace(constantNormals(8, 8, {1e-22f, 0.0f, 1e-22f}), model, NormalSpace::object);
  ASSERT_TRUE(object) << object.error().message;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(glm::length(rgbAt(*object, x, y)), 1.0f, 1e-5f);
}

// The frame is the one in which a surface is shaded.
TEST(NormalsInSpace, AreWhatTheShadersMakeOfTheMap) {
  const Scene model = meshScene(torusMesh(32, 16));
  const glm::vec3 n = glm::normalize(glm::vec3(0.4f, -0.3f, 0.8f));
  const auto object = normalsInSpace(constantNormals(32, 32, n), model, NormalSpace::object);
  const auto surface = MappedSurface::make(model);
  const auto cover = TexelCover::make(surface->uvTriangles(), {32, 32}, 1);
  const Mesh& mesh = model.meshes[0];
  std::vector<CoverSample> row(32);
  for (int y = 0; y < 32; ++y) {
    cover->coverRow(y, row);
    for (int x = 0; x < 32; ++x) {
      const CoverSample& sample = row[std::size_t(x)];
      ASSERT_NE(sample.triangle, CoverSample::kNothing);
      const auto corner = [&](std::size_t k) -> const Vertex& {
        return mesh.vertices[mesh.indices[3 * sample.triangle + k]];
      };
      const glm::vec2 b = sample.barycentric;
      const auto mixed = [&](auto Vertex::*member) {
        return (1.0f - b.x - b.y) * corner(0).*member + b.x * corner(1).*member + b.y * corner(2).*member;
      };
      const glm::vec3 shaded =
          formula::mappedNormal(mixed(&Vertex::tangent), glm::normalize(mixed(&Vertex::normal)), n, 1.0f);
      EXPECT_LT(degreesBetween(rgbAt(*object, x, y), shaded), 0.01f);
    }
  }
}

TEST(NormalsInSpace, OfMirroredPicturesTurnRound) {
  Mesh mirrored = testing::flatPlate();
  for (Vertex& vertex : mirrored.vertices) vertex.uv[0].x = 1.0f - vertex.uv[0].x;
  computeTangents(mirrored);
  const glm::vec3 n = glm::normalize(glm::vec3(0.5f, 0.25f, 1.0f));
  const auto plain = normalsInSpace(constantNormals(4, 4, n), meshScene(testing::flatPlate()), NormalSpace::object);
  const auto turned = normalsInSpace(constantNormals(4, 4, n), meshScene(mirrored), NormalSpace::object);
  EXPECT_LT(degreesBetween(rgbAt(*plain, 1, 2), n), 0.01f);
  EXPECT_LT(degreesBetween(rgbAt(*turned, 1, 2), {-n.x, n.y, n.z}), 0.01f);
}

// Both halves show the same picture from the line between them on, whose vertices they share before tangents are found.
TEST(MappedSurface, HasNoSeamBetweenMirroredHalves) {
  Mesh mesh = testing::plateMesh(4, [](glm::vec2) { return 0.0f; });
  for (Vertex& vertex : mesh.vertices) vertex.uv[0].x = std::abs(vertex.uv[0].x - 0.5f);
  computeTangents(mesh);
  const Scene model = meshScene(mesh);
  const auto surface = MappedSurface::make(model);
  const glm::vec3 n = glm::normalize(glm::vec3(0.5f, 0.25f, 1.0f));
  for (std::uint32_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle)
    for (const glm::vec2 b : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(0.3f, 0.3f)}) {
      const MappedPlace place = surface->at({triangle, b});
      const MappedPlace middle = surface->at({triangle, glm::vec2(0.3f)});
      const float side = middle.position.x < 0.0f ? -1.0f : 1.0f;
      EXPECT_LT(degreesBetween(place.frame.toWorld(n), {side * n.x, n.y, n.z}), 0.01f) << triangle;
    }
}

TEST(NormalsInSpace, NeedTextureCoordinatesAndDirections) {
  Mesh bare = cubeMesh();
  for (Vertex& vertex : bare.vertices) vertex.uv[0] = glm::vec2(0.0f);
  const Image flat = constantNormals(1, 1, {0, 0, 1});
  const auto without = normalsInSpace(flat, meshScene(bare), NormalSpace::object);
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message.find("no texture coordinates"), std::string::npos);
  EXPECT_FALSE(normalsInSpace(flat, Scene(), NormalSpace::object));
  for (const float bad : {0.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const auto none =
        normalsInSpace(constantNormals(2, 2, glm::vec3(bad)), meshScene(cubeMesh()), NormalSpace::tangent);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("(0, 0)"), std::string::npos) << none.error().message;
  }
}

TEST(NormalsInSpace, AreUnitWhereTextureCoordinatesHaveNoArea) {
  Mesh mesh = cubeMesh();
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 2) mesh.vertices[i].uv[0] = glm::vec2(0.25f);
  computeTangents(mesh);
  const auto object = normalsInSpace(constantNormals(16, 16, {1, 1, 1}), meshScene(mesh), NormalSpace::object);
  ASSERT_TRUE(object);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_NEAR(glm::length(rgbAt(*object, x, y)), 1.0f, 1e-5f);
}

}  // namespace
}  // namespace mirrorball
