#include "mirrorball/transfer/detail_transfer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mirrorball/transfer/transfer_testing.h"

namespace mirrorball {
namespace {

using testing::degreesBetween;
using testing::flatPlate;
using testing::plateMesh;

constexpr float kPi = std::numbers::pi_v<float>;

/// Waves of a known height, outside and inside of the plate.
float waveAt(glm::vec2 place) { return 0.03f * std::sin(2.0f * kPi * place.x) * std::cos(kPi * place.y); }

glm::vec3 normalOfWave(glm::vec2 place) {
  const float d_x = 0.06f * kPi * std::cos(2.0f * kPi * place.x) * std::cos(kPi * place.y);
  const float d_y = -0.03f * kPi * std::sin(2.0f * kPi * place.x) * std::sin(kPi * place.y);
  return glm::normalize(glm::vec3(-d_x, -d_y, 1.0f));
}

glm::vec2 placeOfTexel(int x, int y, int side) {
  const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / float(side);
  return {2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y};
}

/// Calls `visit(x, y, place on the light model)` for each texel that has its centre on it.
template <typename Visit>
void forEachPlace(const Scene& low, int side, const Visit& visit) {
  const auto surface = MappedSurface::make(low);
  const auto cover = TexelCover::make(surface->uvTriangles(), {side, side}, 1);
  std::vector<CoverSample> row{std::size_t(side)};
  for (int y = 0; y < side; ++y) {
    cover->coverRow(y, row);
    for (int x = 0; x < side; ++x)
      if (row[std::size_t(x)].triangle != CoverSample::kNothing) visit(x, y, surface->at(row[std::size_t(x)]));
  }
}

TEST(TransferDetail, OfAPlateWithWavesHasTheirHeightsAndNormals) {
  const Scene high = meshScene(plateMesh(400, waveAt)), low = meshScene(flatPlate());
  constexpr int kSide = 64;
  for (const float cage : {0.0f, 0.05f}) {
    const auto detail =
        transferDetail(high, low, {.size = {kSide, kSide}, .samples_side = 1, .cage = cage, .wants_heights = true});
    ASSERT_TRUE(detail) << detail.error().message;
    EXPECT_EQ(detail->covered, 1.0);
    EXPECT_EQ(detail->overlapping, 0.0);
    EXPECT_LT(detail->missed, 1e-3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::vec2 place = placeOfTexel(x, y, kSide);
        EXPECT_NEAR(*detail->heights.texel(x, y), waveAt(place), 1e-4f) << x << ", " << y;
        EXPECT_LT(degreesBetween(rgbAt(detail->normals, x, y), normalOfWave(place)), 0.2f) << x << ", " << y;
      }
  }
}

TEST(TransferDetail, OfADenseSphereMakesACoarseOneSmooth) {
  const Scene high = meshScene(sphereMesh(256, 512));
  const Scene low = meshScene(sphereMesh(8, 16));
  constexpr int kSide = 128;
  for (const NormalSpace space : {NormalSpace::tangent, NormalSpace::object}) {
    const auto detail = transferDetail(high, low, {.size = {kSide, kSide}, .samples_side = 1, .space = space});
    ASSERT_TRUE(detail) << detail.error().message;
    EXPECT_LT(detail->missed, 1e-3);
    forEachPlace(low, kSide, [&](int x, int y, const MappedPlace& place) {
      // Where the ray along the outside meets the unit sphere.
      const float b = glm::dot(place.position, place.outwards);
      const float c = glm::dot(place.position, place.position) - 1.0f;
      const glm::vec3 met = place.position + (-b + std::sqrt(b * b - c)) * place.outwards;
      const glm::vec3 stored = rgbAt(detail->normals, x, y);
      const glm::vec3 shown = space == NormalSpace::tangent ? place.frame.toWorld(stored) : stored;
      EXPECT_LT(degreesBetween(shown, met), 0.3f) << x << ", " << y;
    });
  }
}

TEST(TransferDetail, ReadsTheNormalMapOfTheDenseModel) {
  Scene high = meshScene(flatPlate());
  Texture texture{.image = Image8(1, 1, 4, 255)};
  for (const int channel : {0, 1, 2})
    texture.image.edit().texel(0, 0)[channel] = std::uint8_t(channel == 0 ? 200 : 180);
  high.textures.push_back(texture);
  high.materials[0].normal_map.texture = 0;
  const auto detail = transferDetail(high, meshScene(flatPlate()), {.size = {4, 4}});
  ASSERT_TRUE(detail);
  const glm::vec3 wanted = glm::normalize(glm::vec3(200, 180, 180) / 127.5f - 1.0f);
  EXPECT_LT(degreesBetween(rgbAt(detail->normals, 2, 1), wanted), 0.05f);
}

TEST(TransferDetail, TakesManySamplesATexel) {
  // Much finer than a texel: a single sample finds this slope or that, many find the plate.
  const auto ridges = [](glm::vec2 place) { return 0.01f * std::sin(40.0f * kPi * place.x); };
  const Scene high = meshScene(plateMesh(500, ridges)), low = meshScene(flatPlate());
  const auto worst = [&](int side) {
    const auto detail = transferDetail(high, low, {.size = {9, 9}, .samples_side = side});
    float angle = 0.0f;
    for (int i = 0; i < 81; ++i)
      angle = std::max(angle, degreesBetween(rgbAt(detail->normals, i % 9, i / 9), {0, 0, 1}));
    return angle;
  };
  EXPECT_GT(worst(1), 20.0f);
  EXPECT_LT(worst(8), 12.0f);
}

TEST(TransferDetail, OcclusionIsThatOfAGroove) {
  // A corner of two half planes at right angles: in the edge half of the sky is seen, by either side's cosine.
  const auto valley = [](glm::vec2 place) { return std::abs(place.x); };
  const Scene high = meshScene(plateMesh(200, valley));
  Mesh low = plateMesh(2, valley);
  const auto detail = transferDetail(
      high, meshScene(std::move(low)),
      {.size = {40, 8}, .samples_side = 1, .cage = 0.05f, .wants_occlusion = true, .occlusion_rays = 1024});
  ASSERT_TRUE(detail) << detail.error().message;
  // Beside the edge: the other wall takes all directions on its side that are above the ground but beyond it.
  EXPECT_NEAR(*detail->visible.texel(19, 4), 0.5f, 0.05f);
  EXPECT_GT(*detail->visible.texel(0, 4), 0.9f);
  // It comes from above, and more of it from where the wall itself faces: left of the edge to the right.
  const glm::vec3 left = rgbAt(detail->bent_normals, 18, 4), right = rgbAt(detail->bent_normals, 21, 4);
  EXPECT_GT(left.x, 0.1f);
  EXPECT_LT(right.x, -0.1f);
  EXPECT_GT(std::min(left.z, right.z), 0.9f);
}

TEST(TransferDetail, PassesWhatFacesAway) {
  // A second plate close above, which faces down.
  Mesh high = plateMesh(2, [](glm::vec2) { return -0.05f; });
  Mesh lid = plateMesh(2, [](glm::vec2) { return 0.01f; });
  for (std::size_t i = 0; i < lid.indices.size(); i += 3) std::swap(lid.indices[i + 1], lid.indices[i + 2]);
  Scene both = meshScene(std::move(high));
  both.meshes.push_back(std::move(lid));
  both.instances.push_back({1});
  for (const float cage : {0.0f, 0.1f}) {
    const auto detail =
        transferDetail(both, meshScene(flatPlate()), {.size = {4, 4}, .cage = cage, .wants_heights = true});
    ASSERT_TRUE(detail);
    EXPECT_NEAR(*detail->heights.texel(1, 1), -0.05f, 1e-4f);
  }
}

TEST(TransferDetail, IsTheSameForAnyNumberOfThreads) {
  const Scene high = meshScene(torusMesh(96, 48)), low = meshScene(torusMesh(12, 8));
  const TransferSettings settings{
      .size = {40, 40}, .wants_heights = true, .wants_occlusion = true, .occlusion_rays = 8};
  const auto one = transferDetail(high, low, settings);
  const int threads = threadLimit();
  setThreadLimit(1);
  const auto other = transferDetail(high, low, settings);
  setThreadLimit(threads);
  for (const auto map : {&TransferredDetail::normals, &TransferredDetail::heights, &TransferredDetail::visible,
                         &TransferredDetail::bent_normals})
    EXPECT_TRUE(std::ranges::equal(((*one).*map).samples(), ((*other).*map).samples()));
}

TEST(TransferDetail, FillsTexelsBesideTheEdgesAndLeavesOthersFlat) {
  Mesh low = flatPlate();
  for (Vertex& vertex : low.vertices) vertex.uv[0] = 0.25f + 0.5f * vertex.uv[0];
  const Scene high = meshScene(plateMesh(8, [](glm::vec2 place) { return 0.05f * place.x; }));
  const auto detail = transferDetail(high, meshScene(low), {.size = {32, 32}, .padding = 3});
  ASSERT_TRUE(detail);
  EXPECT_NEAR(detail->covered, 0.25, 1e-6);
  const glm::vec3 inside = rgbAt(detail->normals, 16, 16);
  EXPECT_LT(inside.x, -0.04f);
  EXPECT_LT(glm::distance(rgbAt(detail->normals, 5, 16), inside), 1e-3f);  // the texel 8 is the first inside
  EXPECT_EQ(rgbAt(detail->normals, 4, 16), glm::vec3(0, 0, 1));
}

TEST(TransferDetail, OfOneTriangleAndOneTexel) {
  Mesh triangle;
  for (const glm::vec2 place : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}) {
    Vertex& vertex = triangle.vertices.emplace_back();
    vertex.position = glm::vec3(place, 0.0f);
    vertex.uv[0] = {place.x, 1.0f - place.y};
  }
  triangle.indices = {0, 1, 2};
  const auto detail = transferDetail(meshScene(triangle), meshScene(triangle), {.size = {1, 1}, .samples_side = 4});
  ASSERT_TRUE(detail) << detail.error().message;
  EXPECT_LT(degreesBetween(rgbAt(detail->normals, 0, 0), {0, 0, 1}), 0.01f);
}

TEST(TransferDetail, CountsMirroredHalves) {
  Mesh low = plateMesh(2, [](glm::vec2) { return 0.0f; });
  for (Vertex& vertex : low.vertices) vertex.uv[0].x = std::abs(vertex.uv[0].x - 0.5f);
  computeTangents(low);
  const auto detail = transferDetail(meshScene(flatPlate()), meshScene(low), {.size = {32, 32}});
  ASSERT_TRUE(detail) << detail.error().message;
  EXPECT_NEAR(detail->overlapping, 1.0, 0.1);
}

TEST(TransferDetail, SaysWhatItCannotDo) {
  const Scene plate = meshScene(flatPlate());
  Mesh bare = flatPlate();
  for (Vertex& vertex : bare.vertices) vertex.uv[0] = glm::vec2(0.0f);
  const auto message = [](const auto& result) { return result ? std::string() : result.error().message; };
  EXPECT_NE(message(transferDetail(plate, meshScene(bare))).find("no texture coordinates"), std::string::npos);
  EXPECT_NE(message(transferDetail(Scene(), plate)).find("no triangles"), std::string::npos);
  EXPECT_NE(message(transferDetail(plate, Scene())).find("no triangles"), std::string::npos);
  Scene away = plate;
  away.instances[0].world_from_object[3] = {0, 0, 100, 1};
  EXPECT_NE(message(transferDetail(away, plate, {.size = {4, 4}})).find("no ray"), std::string::npos);
  const auto stopped = transferDetail(plate, plate, {.size = {64, 64}}, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST(TransferDetail, OfNumbersThatAreNotIsUnit) {
  Mesh broken = plateMesh(4, [](glm::vec2) { return 0.0f; });
  broken.vertices[6].position.x = std::numeric_limits<float>::quiet_NaN();
  broken.vertices[8].normal = glm::vec3(0.0f);
  for (Vertex& vertex : broken.vertices) vertex.tangent = glm::vec4(0.0f);
  const auto detail = transferDetail(meshScene(flatPlate()), meshScene(broken), {.size = {16, 16}});
  ASSERT_TRUE(detail) << detail.error().message;
  for (int i = 0; i < 256; ++i) EXPECT_NEAR(glm::length(rgbAt(detail->normals, i % 16, i / 16)), 1.0f, 1e-5f) << i;
}

// Rays from so far away that Embree would end the program meet nothing.
TEST(TransferDetail, WhatIsTooLargeForRaysIsRefused) {
  Mesh huge = testing::flatPlate();
  for (Vertex& vertex : huge.vertices) vertex.position = (vertex.position + 1.0f) * 1e20f;
  const auto detail = transferDetail(meshScene(testing::flatPlate()), meshScene(huge), {.size = {4, 4}});
  ASSERT_FALSE(detail);
  EXPECT_EQ(detail.error().code, ErrorCode::bad_shape);
}

}  // namespace
}  // namespace mirrorball
