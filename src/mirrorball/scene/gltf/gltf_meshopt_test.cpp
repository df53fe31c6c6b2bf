// EXT_meshopt_compression: every mode and filter, and what is wrong with a file.

#include <random>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using testing::GltfMaker;
using ::testing::HasSubstr;

constexpr int kSide = 20;
constexpr std::size_t kVertices = kSide * kSide;

/// A grid of quads, wavy so that its bytes are not all alike.
std::vector<float> gridPositions() {
  std::vector<float> positions;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) positions.insert(positions.end(), {float(x), float(y), float(x * y % 7)});
  return positions;
}

std::vector<std::uint32_t> gridIndices() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t y = 0; y + 1 < kSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
      indices.insert(indices.end(), {a, b, c, b, d, c});
    }
  return indices;
}

Bytes compressedVertices(const void* vertices, std::size_t count, std::size_t stride) {
  Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices, count, stride));
  return bytes;
}

Bytes compressedIndices(const std::vector<std::uint32_t>& indices, bool as_triangles) {
  Bytes bytes(meshopt_encodeIndexBufferBound(indices.size(), kVertices) +
              meshopt_encodeIndexSequenceBound(indices.size(), kVertices));
  bytes.resize(as_triangles ? meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size())
                            : meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}

/// A file all of whose views but those are of a second buffer, which has no bytes.
class CompressedFile {
 public:
  /// Appends a compressed view; returns its index.
  int view(const Bytes& bytes, std::size_t count, std::size_t stride, const std::string& mode,
           const std::string& more = "") {
    const std::size_t offset = data_.size();
    data_.insert(data_.end(), bytes.begin(), bytes.end());
    views_ += std::string(views_.empty() ? "" : ",") + R"({"buffer":1,"byteLength":)" + std::to_string(count * stride) +
              R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" + std::to_string(offset) +
              R"(,"byteLength":)" + std::to_string(bytes.size()) + R"(,"byteStride":)" + std::to_string(stride) +
              R"(,"count":)" + std::to_string(count) + R"(,"mode":")" + mode + "\"" + more + "}}}";
    return view_count_++;
  }

  int accessor(int view, std::size_t count, int component_type, const std::string& type, const std::string& more = "") {
    accessors_ += std::string(accessors_.empty() ? "" : ",") + R"({"bufferView":)" + std::to_string(view) +
                  R"(,"count":)" + std::to_string(count) + R"(,"componentType":)" + std::to_string(component_type) +
                  R"(,"type":")" + type + "\"" + more + "}";
    return accessor_count_++;
  }

  /// rest   more members of the root: ",\"animations\":[]"
  std::string json(const std::string& primitive, const std::string& rest = "") const {
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_meshopt_compression","KHR_mesh_quantization"],)"
           R"("nodes":[{"mesh":0)" +
           std::string(rest.empty() ? "" : ",\"skin\":0") + R"(},{}],"meshes":[{"primitives":[)" + primitive +
           R"(]}],"accessors":[)" + accessors_ + R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"byteLength":)" +
           std::to_string(data_.size()) + R"(,"uri":"data:application/octet-stream;base64,)" +
           GltfMaker::base64(data_) + R"("},{"byteLength":1000000000}])" + rest + "}";
  }

 private:
  Bytes data_;
  std::string views_, accessors_;
  int view_count_ = 0, accessor_count_ = 0;
};

Result<Scene> decodeModel(const std::string& json) { return decodeGltf(Bytes(json.begin(), json.end()), "model.gltf"); }

/// The grid, its indices in either mode.
std::string grid(const std::string& mode) {
  CompressedFile file;
  const std::vector<float> positions = gridPositions();
  const std::vector<std::uint32_t> indices = gridIndices();
  const int vertices = file.view(compressedVertices(positions.data(), kVertices, 12), kVertices, 12, "ATTRIBUTES");
  const int corners = file.view(compressedIndices(indices, mode == "TRIANGLES"), indices.size(), 4, mode);
  file.accessor(vertices, kVertices, 5126, "VEC3");
  file.accessor(vertices, kVertices, 5126, "VEC3");  // stands for normals, which all but the first have
  file.accessor(corners, indices.size(), 5125, "SCALAR");
  return file.json(R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":2})");
}

TEST(GltfMeshopt, ReadsAnimationsAndSkins) {
  CompressedFile file;
  const std::vector<float> times{0, 1}, places{0, 0, 0, 2, 4, 6}, corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<float> weights{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  const Bytes joints(12, 0);
  const auto add = [&](const auto& numbers, std::size_t stride, int component_type, const char* type) {
    const std::size_t count = numbers.size() * sizeof(numbers[0]) / stride;
    const int view = file.view(compressedVertices(numbers.data(), count, stride), count, stride, "ATTRIBUTES");
    file.accessor(view, count, component_type, type);
  };
  add(corners, 12, 5126, "VEC3");
  add(joints, 4, 5121, "VEC4");
  add(weights, 16, 5126, "VEC4");
  add(times, 4, 5126, "SCALAR");
  add(places, 12, 5126, "VEC3");
  const Result<Scene> rest =
      decodeModel(file.json(R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})",
                            R"(,"skins":[{"joints":[1]}],"animations":[{"samplers":[{"input":3,"output":4}],)"
                            R"("channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]}])"));
  ASSERT_TRUE(rest) << rest.error().message;
  const Result<Scene> half = posed(*rest, 0, 0.5);
  ASSERT_TRUE(half) << half.error().message;
  const glm::vec3 place = half->meshes.at(0)->vertices.at(1).position;
  EXPECT_THAT((std::vector{place.x, place.y, place.z}), ElementsAre(2.0f, 2.0f, 3.0f));
}

TEST(GltfMeshopt, ReadsVerticesAndIndicesOfBothModes) {
  for (const std::string mode : {"TRIANGLES", "INDICES"}) {
    const Result<Scene> scene = decodeModel(grid(mode));
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("1 normal has no direction and is made")));
    const Mesh& mesh = scene->meshes.at(0);
    // Triangles may begin at another corner of theirs.
    std::set<std::uint32_t> used(mesh.indices.begin(), mesh.indices.end());
    EXPECT_EQ(used.size(), kVertices);
    const std::vector<std::uint32_t> wanted = gridIndices();
    ASSERT_EQ(mesh.indices.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::uint32_t* const triangle = wanted.data() + i / 3 * 3;
      EXPECT_THAT(std::vector(triangle, triangle + 3), ::testing::Contains(mesh.indices[i]));
    }
    const std::vector<float> positions = gridPositions();
    for (std::size_t i = 0; i < kVertices; ++i)
      EXPECT_EQ(mesh.vertices[i].position, glm::vec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]));
  }
}

TEST(GltfMeshopt, FiltersNormalsAndNumbers) {
  CompressedFile file;
  const std::vector<float> numbers{0.5f, 0, 0, 1, 0, 0, 0, 2, 0};
  std::vector<std::uint32_t> exponential(9);
  meshopt_encodeFilterExp(exponential.data(), 3, 12, 20, numbers.data());
  file.accessor(
      file.view(compressedVertices(exponential.data(), 3, 12), 3, 12, "ATTRIBUTES", R"(,"filter":"EXPONENTIAL")"), 3,
      5126, "VEC3");
  const std::vector<float> normals{0, 0, 1, 0, 0.6f, 0.8f, 0, 0, -0.6f, 0.8f, 0, 0};
  std::vector<std::int8_t> octahedral(12);
  meshopt_encodeFilterOct(octahedral.data(), 3, 4, 8, normals.data());
  file.accessor(file.view(compressedVertices(octahedral.data(), 3, 4), 3, 4, "ATTRIBUTES", R"(,"filter":"OCTAHEDRAL")"),
                3, 5120, "VEC3", R"(,"normalized":true)");
  std::string json = file.json(R"({"attributes":{"POSITION":0,"NORMAL":1}})");
  // Three bytes of four are read.
  const std::string length = R"("byteLength":12,)";
  json.replace(json.find(length), length.size(), length + R"("byteStride":4,)");
  const Result<Scene> scene = decodeModel(json);
  ASSERT_TRUE(scene) << scene.error().message;
  const std::vector<Vertex>& vertices = scene->meshes.at(0)->vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::distance(vertices[i].position, glm::vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2])),
              1e-5f);
    EXPECT_LT(glm::distance(vertices[i].normal, glm::vec3(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2])),
              0.02f);
  }
}

/// The grid with a part of its JSON replaced.
void expectMeshoptRefused(const std::string& part, const std::string& by, const std::string& message,
                          ErrorCode code = ErrorCode::bad_file) {
  std::string json = grid("TRIANGLES");
  const std::size_t at = json.find(part);
  ASSERT_NE(at, std::string::npos) << part;
  const Result<Scene> scene = decodeModel(json.replace(at, part.size(), by));
  ASSERT_FALSE(scene) << by;
  EXPECT_EQ(scene.error().code, code) << scene.error().message;
  EXPECT_THAT(scene.error().message, HasSubstr(message));
  EXPECT_THAT(scene.error().message, ::testing::Not(HasSubstr("\n")));
}

TEST(GltfMeshopt, NamesWhatIsWrong) {
  const std::string key = "bufferViews[0].extensions.EXT_meshopt_compression";
  expectMeshoptRefused(R"("mode":"ATTRIBUTES")", R"("mode":"A\nB")", key + ".mode is 'A?B', none of ATTRIBUTES");
  expectMeshoptRefused(R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"SEPIA")", ".filter is 'SEPIA'");
  expectMeshoptRefused(R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"QUATERNION")", "its filter takes 8");
  expectMeshoptRefused(R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"OCTAHEDRAL")",
                       "its filter takes 4 or 8");
  expectMeshoptRefused(R"("mode":"TRIANGLES")", R"("mode":"TRIANGLES","filter":"EXPONENTIAL")", "for vertices alone");
  expectMeshoptRefused(R"("mode":"ATTRIBUTES")", R"("mode":"INDICES")", "indices have 2 or 4 bytes");
  expectMeshoptRefused(R"("byteStride":12)", R"("byteStride":0)", "byteStride is 0, no multiple of 4 up to 256");
  expectMeshoptRefused(R"("byteStride":12)", R"("byteStride":6)", "no multiple of 4");
  expectMeshoptRefused(R"("byteStride":12)", R"("byteStride":512)", "no multiple of 4");
  expectMeshoptRefused(R"("byteStride":12)", R"("byteStride":4)", ".count is 400, not the bufferView's byteLength");
  expectMeshoptRefused(R"("count":400,"mode")", R"("count":18446744073709551615,"mode")",
                       ".count is 18446744073709551615");
  expectMeshoptRefused(R"("buffer":0)", R"("buffer":7)", key + ".buffer is 7, but there are 2 buffers");
  expectMeshoptRefused(R"("byteOffset":0)", R"("byteOffset":18446744073709551615)",
                       "bytes from byte 18446744073709551615");
  expectMeshoptRefused(R"("byteOffset":0)", R"("byteOffset":1)", "the compressed bytes are damaged");
  expectMeshoptRefused(R"("mode":"TRIANGLES")", R"("mode":"INDICES")", "the compressed bytes are damaged");
  expectMeshoptRefused(R"("count":400,"mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES")", key + ".count is missing");
  expectMeshoptRefused(R"("buffer":1,"byteLength":4800,"extensions":{"EXT_meshopt_compression")",
                       R"("buffer":1,"byteLength":4800,"extensions":{"other")",
                       "buffers[1].byteLength is 1000000000, but the binary chunk has 0 bytes");
}

TEST(GltfMeshopt, AStreamThatCannotHoldAsManyIsRefusedBeforeMemoryIsTaken) {
  CompressedFile file;
  const std::vector<float> zeros(3 * 16);
  const Bytes bytes = compressedVertices(zeros.data(), 16, 12);
  file.accessor(file.view(bytes, 100'000'000, 12, "ATTRIBUTES"), 16, 5126, "VEC3");
  const Result<Scene> scene = decodeModel(file.json(R"({"attributes":{"POSITION":0}})"));
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message, HasSubstr("bytes cannot hold 1200000000"));
}

// As little as the coding can make of them.
TEST(GltfMeshopt, WhatIsAllAlikeIsRead) {
  constexpr std::size_t kMany = 65536;
  CompressedFile file;
  const std::vector<float> zeros(3 * kMany);
  const Bytes bytes = compressedVertices(zeros.data(), kMany, 12);
  EXPECT_GT(kMany * 12 / bytes.size(), 60u);
  file.accessor(file.view(bytes, kMany, 12, "ATTRIBUTES"), kMany, 5126, "VEC3");
  EXPECT_THAT(decodeModel(file.json(R"({"attributes":{"POSITION":0}})")).error().message,
              HasSubstr("shows no triangles"));
}

TEST(GltfMeshopt, CompressedBytesSurviveRandomDamage) {
  const std::string whole = grid("TRIANGLES");
  const std::string mark = "base64,";
  const std::size_t first = whole.find(mark) + mark.size();
  const std::size_t size = whole.find('"', first) - first;
  std::mt19937 random(6);
  int read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole;
    for (int letters = 0; letters < 2; ++letters)
      damaged[first + random() % (size - 4)] =
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"[random() % 64];
    const Result<Scene> scene = decodeModel(damaged);
    if (!scene) continue;
    ++read;
    for (const Mesh& mesh : scene->meshes)
      for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace mirrorball
