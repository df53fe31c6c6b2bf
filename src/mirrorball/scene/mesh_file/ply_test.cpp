#include "mirrorball/scene/mesh_file/ply.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/scene/mesh_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Bytes plyBytes(std::string_view text) { return Bytes(text.begin(), text.end()); }

Result<Scene> decodePlyText(const Bytes& bytes) { return decodePly(bytes, "model.ply"); }

void expectPlyRefused(const Bytes& bytes, ErrorCode code, const std::string& part) {
  const Result<Scene> scene = decodePlyText(bytes);
  ASSERT_FALSE(scene) << part;
  EXPECT_EQ(scene.error().code, code) << scene.error().message;
  EXPECT_THAT(scene.error().message, HasSubstr(part));
}

/// A square of two triangles with normals of its own, all values binary.
Bytes binaryPlySquare(std::endian order) {
  Bytes bytes = plyBytes(std::string("ply\nformat ") +
                         (order == std::endian::little ? "binary_little_endian" : "binary_big_endian") +
                         " 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty float y\n"
                         "property short z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                         "element face 1\nproperty uchar flags\nproperty list uchar uint vertex_indices\nend_header\n");
  const auto put = [&](auto value) {
    std::uint8_t raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (order != std::endian::native) std::reverse(raw, raw + sizeof value);
    bytes.insert(bytes.end(), raw, raw + sizeof value);
  };
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    put(static_cast<double>(x));
    put(static_cast<float>(y));
    put(std::int16_t{7});
    put(0.0f);
    put(0.0f);
    put(2.0f);
  }
  put(std::uint8_t{9});
  put(std::uint8_t{4});
  for (const std::uint32_t index : {0u, 1u, 2u, 3u}) put(index);
  return bytes;
}

TEST(Ply, ReadsBinaryOfBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Result<Scene> scene = decodePlyText(binaryPlySquare(order));
    ASSERT_TRUE(scene) << scene.error().message;
    const Mesh& mesh = scene->meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.vertices[2].position, glm::vec3(1, 1, 7));
    EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 0, 1));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
  }
}

TEST(Ply, ReadsAsciiWithColoursAndTextureCoordinates) {
  const Result<Scene> scene = decodePlyText(
      plyBytes("ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float z\r\nproperty float y\r\n"
               "property float x\r\nproperty float s\r\nproperty float t\r\nproperty uchar red\r\n"
               "property uchar green\r\nproperty uchar blue\r\nproperty uchar alpha\r\n"
               "element face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
               "0 0 1 0.25 0.75 255 188 0 51\r\n0 1 0 0 0 0 0 0 255\r\n1 0 0 1 1 0 0 0 255\r\n3 0 1 2\r\n"));
  ASSERT_TRUE(scene) << scene.error().message;
  const Vertex& vertex = scene->meshes.at(0)->vertices.at(0);
  EXPECT_EQ(vertex.position, glm::vec3(1, 0, 0));
  EXPECT_EQ(vertex.uv[0], glm::vec2(0.25f, 0.25f));
  EXPECT_EQ(vertex.color.r, 1.0f);
  EXPECT_NEAR(vertex.color.g, 0.5028864f, 1e-5f);  // sRGB 188
  EXPECT_EQ(vertex.color.b, 0.0f);
  EXPECT_NEAR(vertex.color.a, 0.2f, 1e-6f);
  EXPECT_NEAR(vertex.normal.x, 0.57735f, 1e-5f);  // none in the file: computed
}

// As OBJ: edges over which two faces turn by less than 45° are smooth.
TEST(Ply, WithoutNormalsABoxIsSharpAndARoundedEdgeIsSmooth) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  const Result<Scene> box =
      decodePlyText(plyBytes(header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                                      "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
  ASSERT_TRUE(box) << box.error().message;
  const Mesh& mesh = box->meshes.at(0);
  EXPECT_EQ(mesh.vertices.size(), 24u) << "three at each of 8 corners";
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 n = glm::abs(vertex.normal);
    EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1.0f, 1e-6f) << "along an axis";
    EXPECT_NEAR(glm::dot(vertex.normal, vertex.position - glm::vec3(0.5f)), 0.5f, 1e-6f) << "outwards, of its own face";
  }
  const Result<Scene> roof = decodePlyText(
      plyBytes("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
               "-1 0 0\n0 0 0.2\n0 1 0.2\n-1 1 0\n1 0 0\n1 1 0\n4 0 1 2 3\n4 1 4 5 2\n"));
  ASSERT_TRUE(roof) << roof.error().message;
  EXPECT_EQ(roof->meshes.at(0)->vertices.size(), 6u);
  for (const Vertex& vertex : roof->meshes.at(0)->vertices)
    if (vertex.position.x == 0.0f) {
      EXPECT_NEAR(vertex.normal.z, 1.0f, 1e-6f) << "the mean of both sides";
    }
}

TEST(Ply, ReadsTriangleStrips) {
  const Result<Scene> scene = decodePlyText(
      plyBytes("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n"));
  ASSERT_TRUE(scene) << scene.error().message;
  const Mesh& mesh = scene->meshes.at(0);
  std::vector<int> corners;
  for (const std::uint32_t index : mesh.indices)
    corners.push_back(static_cast<int>(mesh.vertices[index].position.x + 2.0f * mesh.vertices[index].position.y));
  EXPECT_THAT(corners, ElementsAre(0, 1, 2, 1, 3, 2, 0, 1, 2));
}

const std::string kAsciiHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Ply, NamesWhatIsWrong) {
  expectPlyRefused(plyBytes("solid"), ErrorCode::bad_file, "not a PLY file");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex 3\n"), ErrorCode::bad_file, "header does not end");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex minus\n"), ErrorCode::bad_file, "line 3");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex 1\nproperty vector x\nend_header\n"),
                   ErrorCode::bad_file, "line 4: not a valid property");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n0 0 0\n"),
                   ErrorCode::bad_file,
                   "ends in row 2 of 4000000000 of 'vertex'; it is truncated before its first face");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n"), ErrorCode::bad_file,
                   "the rows of 'vertex' have no properties");
  expectPlyRefused(plyBytes(kAsciiHeader + "0 0 0\n1 0 up\n0 1 0\n3 0 1 2\n"), ErrorCode::bad_file,
                   "line 2 of its data: no number for 'z' of its row 1");
  for (const char* nowhere : {"nan", "1e300", "-inf"})
    expectPlyRefused(plyBytes(kAsciiHeader + "0 0 0\n1 0 " + nowhere + "\n0 1 0\n3 0 1 2\n"), ErrorCode::bad_file,
                     "holds no face that can be drawn: 1 triangle reaches NaN or infinity");
  for (const char* index : {"3", "-1", "0.5", "nan", "1e30"})
    expectPlyRefused(plyBytes(kAsciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 " + index + "\n"), ErrorCode::bad_file,
                     "1 triangle names a vertex that is not there");
  expectPlyRefused(plyBytes(kAsciiHeader + "0 0 0\n1 0 0\n0 1 0\n99999999 0 1 2\n"), ErrorCode::bad_file,
                   "no valid length");
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n0 0 0\n"),
                   ErrorCode::unsupported, "holds no faces, but 1 point; only surfaces can be drawn: make one of them");
}

TEST(Ply, RefusesFacesThatPrecedeVerticesTheyLack) {
  expectPlyRefused(plyBytes("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                            "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                            "3 0 1 7\n0 0 0\n1 0 0\n0 1 0\n"),
                   ErrorCode::bad_file, "1 triangle names a vertex that is not there");
}

/// Expects a file of two faces to be read from where the first ends, with a remark as far as the second does not.
void expectReadWhereverItIsCut(const Bytes& file, std::size_t end_of_first, std::size_t end_of_second) {
  const Result<Scene> whole = decodePlyText(file);
  ASSERT_TRUE(whole) << whole.error().message;
  const std::size_t indices = whole->meshes.at(0)->indices.size();
  for (std::size_t size = 0; size <= file.size(); ++size) {
    const Result<Scene> scene = decodePlyText(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)));
    ASSERT_EQ(bool(scene), size >= end_of_first) << size;
    if (!scene) continue;
    const bool is_whole = size >= end_of_second;
    EXPECT_EQ(scene->meshes.at(0)->indices.size(), is_whole ? indices : indices / 2) << size;
    if (is_whole)
      EXPECT_THAT(scene->warnings, IsEmpty()) << size;
    else
      EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("ends in row 2 of 2 of 'face'; it is truncated, and its "
                                                         "faces up to there")))
          << size;
  }
}

// A row that is cut is not one, and neither is the last number of a text that may have had more digits.
TEST(Ply, IsReadAsFarAsItsFacesGoWhereverItIsCut) {
  const Bytes text = plyBytes(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  const std::size_t end_of_first_face = text.size() - std::strlen("3 0 2 3\n");
  expectReadWhereverItIsCut(text, end_of_first_face, text.size() - 1);  // without its last line break it is whole
  Bytes binary = binaryPlySquare(std::endian::little);
  const std::size_t end_of_square = binary.size();
  const std::string_view count = "element face 1";
  *(std::search(binary.begin(), binary.end(), count.begin(), count.end()) + std::ptrdiff_t(count.size()) - 1) = '2';
  const Bytes square(binary.end() - 2 - 4 * std::ptrdiff_t(sizeof(std::uint32_t)), binary.end());
  binary.insert(binary.end(), square.begin(), square.end());
  expectReadWhereverItIsCut(binary, end_of_square, binary.size());
}

TEST(Ply, SurvivesRandomDamage) {
  const Bytes whole = binaryPlySquare(std::endian::big);
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i) {
    Bytes damaged = whole;
    for (int flips = 0; flips < 3; ++flips)
      damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    const Result<Scene> scene = decodePlyText(damaged);
    if (!scene) continue;
    for (const std::uint32_t index : scene->meshes.at(0)->indices) ASSERT_LT(index, scene->meshes[0]->vertices.size());
  }
}

TEST(Ply, MemoryIsAskedForBeforeItIsTaken) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(4 * sizeof(Vertex) - 1);
  expectPlyRefused(binaryPlySquare(std::endian::little), ErrorCode::too_large, "of memory");
  setMemoryLimit(before);
  EXPECT_TRUE(decodePlyText(binaryPlySquare(std::endian::little)));
}

// Either would fit.
TEST(Ply, VerticesAndFacesAreRefusedIfTheyAreTooLargeTogether) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(4 * sizeof(Vertex) + 200);
  expectPlyRefused(binaryPlySquare(std::endian::little), ErrorCode::too_large, "of memory");
  setMemoryLimit(before);
}

// Their rows are few, and their triangles many.
TEST(Ply, TrianglesOfLargeFacesAndStripsAreAskedFor) {
  const std::uint64_t before = memoryLimit();
  const std::uint64_t corners = 10'000, vertices = corners * (sizeof(Vertex) + sizeof(glm::dvec3));
  for (const std::string element : {"face", "tristrips"}) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 10000\nproperty float x\nproperty float y\n"
        "property float z\nelement " +
        element + " 1\nproperty list uint uint vertex_indices\nend_header\n";
    std::string list = "10000";
    for (std::uint64_t i = 0; i < corners; ++i) {
      text += std::to_string(i) + (i % 2 == 0 ? " 0 0\n" : " 1 0\n");
      list += " " + std::to_string(i);
    }
    setMemoryLimit(vertices + 299 * corners);
    expectPlyRefused(plyBytes(text + list + "\n"), ErrorCode::too_large, "of memory");
    setMemoryLimit(vertices + 320 * corners);
    EXPECT_TRUE(decodePlyText(plyBytes(text + list + "\n"))) << element;
  }
  setMemoryLimit(before);
}

TEST(Ply, WhatTheHeaderSaysIsQuoted) {
  const std::string name = "\x1b[2J\x9b" + std::string(100'000, 'x');
  const std::string ascii = "format ascii 1.0\n", end = "\nend_header\n";
  for (const std::string& header :
       {"format " + name + " 1.0" + end, ascii + name + end,
        ascii + "element " + name + " 4000000000\nproperty list uchar int a" + end,
        ascii + "element vertex 1\nproperty char x\nproperty char y\nproperty char z\nproperty float " + name + end +
            "0 0 0 x\n",
        ascii + "element face 1\nproperty list char int " + name + end + "-1\n"}) {
    const Result<Scene> scene = decodePlyText(plyBytes("ply\n" + header));
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().message, HasSubstr("'?[2J?xxx"));
    EXPECT_LT(scene.error().message.size(), 400u);
  }
}

}  // namespace
}  // namespace mirrorball
