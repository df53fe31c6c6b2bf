#include "mirrorball/scene/mesh_file/stl.h"

#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

Bytes stlBytes(std::string_view text) { return Bytes(text.begin(), text.end()); }

/// Two facets of a square in z = 0, beginning with the word of the ascii format, as many binary files do.
Bytes binaryStlSquare() {
  Bytes bytes = stlBytes("solid, yet binary");
  bytes.resize(80, 0);
  const auto put = [&](auto value) {
    std::uint8_t raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.insert(bytes.end(), raw, raw + sizeof value);
  };
  put(std::uint32_t{2});
  for (const std::array<float, 9>& corners :
       {std::array<float, 9>{0, 0, 0, 1, 0, 0, 1, 1, 0}, std::array<float, 9>{0, 0, 0, 1, 1, 0, 0, 1, 0}}) {
    for (int i = 0; i < 3; ++i) put(0.0f);  // no normal, as many programs leave it
    for (const float number : corners) put(number);
    put(std::uint16_t{0});
  }
  return bytes;
}

constexpr const char* kAscii =
    "solid made by hand\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1e0 0 0\n   vertex 0 1 0\n"
    "  endloop\n endfacet\nendsolid made by hand\n";

void expectStlRefused(const Bytes& bytes, const std::string& part) {
  const Result<Scene> scene = decodeStl(bytes);
  ASSERT_FALSE(scene) << part;
  EXPECT_EQ(scene.error().code, ErrorCode::bad_file);
  EXPECT_THAT(scene.error().message, HasSubstr(part));
}

TEST(Stl, TellsBinaryBySize) {
  const Result<Scene> scene = decodeStl(binaryStlSquare());
  ASSERT_TRUE(scene) << scene.error().message;
  const Mesh& mesh = scene->meshes.at(0);
  ASSERT_EQ(mesh.indices.size(), 6u);
  EXPECT_EQ(mesh.vertices[2].position, glm::vec3(1, 1, 0));
  for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST(Stl, ReadsAscii) {
  const Result<Scene> scene = decodeStl(stlBytes(kAscii));
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->meshes.at(0)->vertices.size(), 3u);
  EXPECT_EQ(scene->meshes[0]->vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->meshes[0]->vertices[1].normal, glm::vec3(0, 0, 1));
}

TEST(Stl, LeavesOutFacetsWithoutArea) {
  Bytes bytes = binaryStlSquare();
  std::memset(bytes.data() + 84 + 12, 0, 36);
  const Result<Scene> scene = decodeStl(bytes);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
  std::memset(bytes.data() + 84 + 50 + 12, 0, 36);
  expectStlRefused(bytes, "no facet with an area");
}

TEST(Stl, NamesWhatIsWrong) {
  expectStlRefused({}, "too short");
  expectStlRefused(stlBytes("nothing of the kind"), "too short");
  Bytes wrong_count = binaryStlSquare();
  wrong_count[0] = 'x';
  wrong_count[83] = 0x7f;
  expectStlRefused(wrong_count, "it is truncated or no STL file");
  Bytes not_finite = binaryStlSquare();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(not_finite.data() + 84 + 50 + 12 + 4, &nan, sizeof nan);
  expectStlRefused(not_finite, "facet 1 (byte 146)");
  expectStlRefused(stlBytes("solid\nfacet\nvertex 0 0 nan\n"), "line 3: a corner needs three finite numbers");
  expectStlRefused(stlBytes("solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nfacet\n"), "line 5: the facet before it");
  expectStlRefused(stlBytes("solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"), "endsolid");
}

TEST(Stl, MemoryIsAskedForBeforeItIsTaken) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(3 * sizeof(Vertex));
  for (const Bytes& bytes : {binaryStlSquare(), stlBytes(kAscii)}) {
    const Result<Scene> refused = decodeStl(bytes);
    EXPECT_FALSE(refused);
    if (!refused) EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  }
  setMemoryLimit(before);
  EXPECT_TRUE(decodeStl(binaryStlSquare()));
}

TEST(Stl, IsRefusedWhenCutAnywhere) {
  const Bytes binary = binaryStlSquare();
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_FALSE(decodeStl(std::span(binary).first(size))) << size;
  const Bytes ascii = stlBytes(kAscii);
  const std::size_t last_word = std::string_view(kAscii).find("endsolid") + std::strlen("endsolid");
  for (std::size_t size = 0; size < last_word; ++size) EXPECT_FALSE(decodeStl(std::span(ascii).first(size))) << size;
}

TEST(Stl, SurvivesRandomDamage) {
  std::mt19937 random(2);
  for (const Bytes& whole : {binaryStlSquare(), stlBytes(kAscii)}) {
    for (int i = 0; i < 3000; ++i) {
      Bytes damaged = whole;
      for (int flips = 0; flips < 3; ++flips)
        damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
      const Result<Scene> scene = decodeStl(damaged);
      if (!scene) continue;
      for (const std::uint32_t index : scene->meshes.at(0)->indices)
        ASSERT_LT(index, scene->meshes[0]->vertices.size());
    }
  }
}

}  // namespace
}  // namespace mirrorball
