// STL files as programs write them.

#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "mirrorball/scene/mesh_file/mesh_file_testing.h"
#include "mirrorball/scene/mesh_file/stl.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::totalArea;

/// The square from −1 to 1 as text.
std::string squareText() {
  std::string text = "solid a\n";
  for (const char* corners :
       {"vertex -1 -1 0\n  vertex 1 -1 0\n  vertex 1 1 0", "vertex -1 -1 0\n  vertex 1 1 0\n  vertex -1 1 0"})
    text += "facet normal 0 0 1\n outer loop\n  " + std::string(corners) + "\n endloop\nendfacet\n";
  return text + "endsolid a\n";
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string upperCase(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

/// The same square, and what else a binary file may have.
struct BinarySquare {
  std::string header = "made by a CAD program";
  std::uint32_t count = 2;
  std::array<std::uint16_t, 2> attributes{0, 0};
  std::string behind = "";
  std::vector<std::array<float, 9>> facets{{-1, -1, 0, 1, -1, 0, 1, 1, 0}, {-1, -1, 0, 1, 1, 0, -1, 1, 0}};

  std::string bytes() const {
    std::string file = header;
    file.resize(80, ' ');
    const auto put = [&](const auto& value) { file.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(count);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      put(std::array<float, 3>{0, 0, 1});
      put(facets[i]);
      put(i < attributes.size() ? attributes[i] : std::uint16_t{0});
    }
    return file + behind;
  }
};

Scene sceneOfStl(const std::string& file) {
  Result<Scene> scene = decodeStl(testing::toBytes(file), "model.stl");
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene();
}

void expectSquare(const std::string& file, const std::vector<std::string>& remarks = {}) {
  const Scene scene = sceneOfStl(file);
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
  ASSERT_EQ(scene.warnings.size(), remarks.size()) << (scene.warnings.empty() ? "" : scene.warnings[0]);
  for (std::size_t i = 0; i < remarks.size(); ++i) EXPECT_EQ(scene.warnings[i], "model.stl: " + remarks[i]);
}

TEST(StlAsFound, TextInAnyCaseAndIndentIsRead) {
  const std::string text = squareText();
  expectSquare(text);
  expectSquare(upperCase(text));
  expectSquare("\n  " + text);
  expectSquare(replaced(text, "\n", "\r\n"));
  expectSquare(replaced(text, "\n", "\r"));
  expectSquare("\xEF\xBB\xBF" + text);
  expectSquare(replaced(text, "solid a", "solid \xE7\xA9\xBF\xE5\xB1\xB1\xE7\x94\xB2"));
  expectSquare(replaced(text, "solid a", "solid"));
  expectSquare(replaced(text, "endsolid a", "end solid a"));
  expectSquare(replaced(text, "solid a", "solid a vertex of a facet"));
  expectSquare(replaced(text, " 0 0 1\n", "\n"));
}

TEST(StlAsFound, TextOfSeveralSolidsIsOneModel) {
  const std::string text = squareText();
  const std::string empty = "solid none\nendsolid none\n";
  EXPECT_NEAR(totalArea(sceneOfStl(empty + text + "\n" + replaced(text, "0\n", "5\n") + empty)), 8.0, 1e-6);
}

TEST(StlAsFound, WhatIsOddInATextIsTold) {
  const std::string text = squareText();
  expectSquare(text.substr(0, text.find("endsolid")), {"does not end with 'endsolid'; it may be truncated"});
  expectSquare(replaced(text, "-1", "-1,0"),
               {"has decimal commas (the first in line 4: '-1,0'), which are read as points"});
  const std::string facet = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\nvertex 0 1 0\nendloop\nendfacet\n";
  expectSquare(replaced(text, "endsolid", facet + "endsolid"), {"1 triangle reaches NaN or infinity and is left out"});
}

TEST(StlAsFound, ABinaryFileMayBeginWithSolidAndHaveBytesBehind) {
  expectSquare(BinarySquare{}.bytes());
  expectSquare(BinarySquare{.header = "solid part1"}.bytes());
  expectSquare(BinarySquare{.header = "SOLID part1"}.bytes());
  expectSquare(BinarySquare{.behind = std::string(2, '\0')}.bytes(), {"2 bytes are behind its last facet: left out"});
  expectSquare(BinarySquare{.header = "solid part1", .behind = std::string(10, 'x')}.bytes(),
               {"10 bytes are behind its last facet: left out"});
}

TEST(StlAsFound, AWrongCountOfFacetsIsTold) {
  expectSquare(BinarySquare{.count = 0}.bytes(), {"its header names 0 facets, and it holds 2, which are shown"});
  expectSquare(BinarySquare{.count = 1}.bytes(), {"its header names 1 facet, and it holds 2, which are shown"});
  expectSquare(BinarySquare{.count = 0xFFFFFFFF}.bytes(),
               {"its header names 4294967295 facets, and it holds 2, which are shown; it may be truncated"});
}

// A checksum, a preview or padding may be as long as facets.
TEST(StlAsFound, WhatIsAsLongAsFacetsNeedNotBeSome) {
  const std::vector<std::string> remarks = {"100 bytes are behind its last facet: left out"};
  expectSquare(BinarySquare{.behind = std::string(100, '\0')}.bytes(), remarks);
  expectSquare(BinarySquare{.behind = std::string(100, 'x')}.bytes(), remarks);
  std::string words;
  while (words.size() < 100) words += "preview of the part; ";
  expectSquare(BinarySquare{.behind = words.substr(0, 100)}.bytes(), remarks);
}

TEST(StlAsFound, FacetsThatAreNowhereAreLeftOut) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  BinarySquare square{.count = 3};
  square.facets.push_back({kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN});
  expectSquare(square.bytes(), {"1 triangle reaches NaN or infinity and is left out"});
}

/// The colours of the two facets.
std::array<glm::vec3, 2> facetColors(const Scene& scene) {
  return {glm::vec3(scene.meshes.at(0)->vertices.at(0).color), glm::vec3(scene.meshes[0]->vertices.at(3).color)};
}

TEST(StlAsFound, ColoursOfSolidViewAndVisCamAreRead) {
  // Bit 15 says that there is a colour; blue is lowest.
  const Scene scene = sceneOfStl(BinarySquare{.attributes = {0x8000 | 31 << 10, 0x8000 | 31 << 5 | 15}}.bytes());
  EXPECT_EQ(facetColors(scene)[0], glm::vec3(1, 0, 0));
  EXPECT_EQ(facetColors(scene)[1].g, 1.0f);
  EXPECT_NEAR(facetColors(scene)[1].b, 0.19941f, 1e-4f) << "15 of 31 of sRGB";
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("in the way of SolidView and VisCAM")));
  const Scene half = sceneOfStl(BinarySquare{.attributes = {0x8000 | 31, 31}}.bytes());
  EXPECT_EQ(facetColors(half)[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(facetColors(half)[1], Material().base_color) << "it has none";
  EXPECT_EQ(sceneOfStl(BinarySquare{.attributes = {31, 7}}.bytes()).materials.at(0).base_color, Material().base_color);
}

TEST(StlAsFound, ColoursOfMagicsAreRead) {
  // Bit 15 says that the facet has the object's; red is lowest.
  const std::string header("COLOR=\xFF\0\0\xFF,MATERIAL=", 20);
  const Scene scene = sceneOfStl(BinarySquare{.header = header, .attributes = {0x8000, 31 << 5}}.bytes());
  EXPECT_EQ(facetColors(scene)[0], glm::vec3(1, 0, 0));
  EXPECT_EQ(facetColors(scene)[1], glm::vec3(0, 1, 0));
  EXPECT_THAT(scene.warnings, IsEmpty());
  const Scene plain = sceneOfStl(BinarySquare{.header = header}.bytes());
  EXPECT_EQ(facetColors(plain)[1], glm::vec3(1, 0, 0)) << "rather than black";
  EXPECT_THAT(plain.warnings, ElementsAre(HasSubstr("'COLOR='")));
}

}  // namespace
}  // namespace mirrorball
