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

using ::testing::ElementsAre;
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

Result<Scene> decodeStlBytes(std::span<const std::uint8_t> bytes) { return decodeStl(bytes, "model.stl"); }

void expectStlRefused(const Bytes& bytes, const std::string& part) {
  const Result<Scene> scene = decodeStlBytes(bytes);
  ASSERT_FALSE(scene) << part;
  EXPECT_EQ(scene.error().code, ErrorCode::bad_file);
  EXPECT_THAT(scene.error().message, HasSubstr(part));
}

TEST(Stl, TellsBinaryBySize) {
  const Result<Scene> scene = decodeStlBytes(binaryStlSquare());
  ASSERT_TRUE(scene) << scene.error().message;
  const Mesh& mesh = scene->meshes.at(0);
  ASSERT_EQ(mesh.indices.size(), 6u);
  EXPECT_EQ(mesh.vertices[2].position, glm::vec3(1, 1, 0));
  for (const Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST(Stl, ReadsAscii) {
  const Result<Scene> scene = decodeStlBytes(stlBytes(kAscii));
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->meshes.at(0)->vertices.size(), 3u);
  EXPECT_EQ(scene->meshes[0]->vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->meshes[0]->vertices[1].normal, glm::vec3(0, 0, 1));
}

TEST(Stl, LeavesOutFacetsWithoutArea) {
  Bytes bytes = binaryStlSquare();
  std::memset(bytes.data() + 84 + 12, 0, 36);
  const Result<Scene> scene = decodeStlBytes(bytes);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
  std::memset(bytes.data() + 84 + 50 + 12, 0, 36);
  expectStlRefused(bytes, "no facet with an area");
}

TEST(Stl, NamesWhatIsWrong) {
  expectStlRefused({}, "holds no facets");
  expectStlRefused(stlBytes("nothing of the kind"), "holds no facets; it is not an STL file, or ends before the first");
  expectStlRefused(stlBytes("solid a\nendsolid a\n"), "holds no facets");
  expectStlRefused(Bytes(84, 0), "holds no facets");
  expectStlRefused(stlBytes("SOLID" + std::string(200, ' ') + "These are words, and none of them is of a facet."),
                   "is not an STL file: it has no facets in words");
  expectStlRefused(Bytes(500, 0x7f), "is not an STL file");
  expectStlRefused(Bytes(100, 0), "is not an STL file");
  expectStlRefused(stlBytes("solid\nfacet\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 0\nendsolid\n"),
                   "holds no facet with an area; 1 triangle reaches NaN or infinity");
  expectStlRefused(stlBytes("solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nfacet\nendsolid\n"),
                   "1 facet is left out that has not three corners");
}

TEST(Stl, MemoryIsAskedForBeforeItIsTaken) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(3 * sizeof(Vertex));
  for (const Bytes& bytes : {binaryStlSquare(), stlBytes(kAscii)}) {
    const Result<Scene> refused = decodeStlBytes(bytes);
    EXPECT_FALSE(refused);
    if (!refused) EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  }
  setMemoryLimit(before);
  EXPECT_TRUE(decodeStlBytes(binaryStlSquare()));
}

TEST(Stl, IsReadAsFarAsItGoesWhereverItIsCut) {
  const Bytes binary = binaryStlSquare();
  for (std::size_t size = 0; size < binary.size(); ++size) {
    const Result<Scene> scene = decodeStlBytes(std::span(binary).first(size));
    ASSERT_EQ(bool(scene), size >= 84 + 50) << size;
    if (scene) EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("names 2 facets, and it holds 1"))) << size;
  }
  const Bytes ascii = stlBytes(kAscii);
  const std::size_t last_corner = std::string_view(kAscii).find("0 1 0") + 5;
  const std::size_t last_word = std::string_view(kAscii).find("endsolid") + std::strlen("endsolid");
  for (std::size_t size = 0; size < last_word; ++size) {
    const Result<Scene> scene = decodeStlBytes(std::span(ascii).first(size));
    // Where the file ends right behind a number, that may lack digits.
    ASSERT_EQ(bool(scene), size > last_corner) << size;
    if (scene) EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("does not end with 'endsolid'"))) << size;
  }
}

TEST(Stl, SurvivesRandomDamage) {
  std::mt19937 random(2);
  for (const Bytes& whole : {binaryStlSquare(), stlBytes(kAscii)}) {
    for (int i = 0; i < 3000; ++i) {
      Bytes damaged = whole;
      for (int flips = 0; flips < 3; ++flips)
        damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
      const Result<Scene> scene = decodeStlBytes(damaged);
      if (!scene) continue;
      for (const std::uint32_t index : scene->meshes.at(0)->indices)
        ASSERT_LT(index, scene->meshes[0]->vertices.size());
    }
  }
}

}  // namespace
}  // namespace mirrorball
