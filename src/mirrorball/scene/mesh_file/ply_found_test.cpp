// PLY files as programs write them.

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "mirrorball/scene/mesh_file/mesh_file_testing.h"
#include "mirrorball/scene/mesh_file/ply.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::totalArea;

/// The square from −1 to 1, of two triangles, with more properties.
struct PlySquare {
  std::string comments = "";
  std::string type = "float";
  std::string of_vertex = "";                         ///< properties after x, y and z
  std::vector<std::string> vertices{"", "", "", ""};  ///< what those are
  std::string of_face = "";                           ///< properties after the list of corners
  std::vector<std::string> faces{"", ""};
  std::string more = "";  ///< after all

  std::string text() const {
    std::string file = "ply\nformat ascii 1.0\n" + comments + "element vertex 4\nproperty " + type + " x\nproperty " +
                       type + " y\nproperty " + type + " z\n" + of_vertex +
                       "element face 2\nproperty list uchar int vertex_indices\n" + of_face + "end_header\n";
    const char* places[] = {"-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"};
    for (std::size_t i = 0; i < 4; ++i) file += std::string(places[i]) + " " + vertices[i] + "\n";
    file += "3 0 1 2 " + faces[0] + "\n3 0 2 3 " + faces[1] + "\n";
    return file + more;
  }
};

Scene sceneOfPly(const std::string& file, const std::filesystem::path& path = "model.ply") {
  Result<Scene> scene = decodePly(testing::toBytes(file), path);
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene();
}

/// The colour of the vertex that a corner of the first mesh has.
glm::vec4 colorAt(const Scene& scene, std::size_t corner) {
  const Mesh& mesh = scene.meshes.at(0);
  return mesh.vertices.at(mesh.indices.at(corner)).color;
}

TEST(PlyAsFound, ATextMayHaveCommentsAmongItsData) {
  PlySquare square;
  square.vertices[3] = "\ncomment of faces 1 2 3\nobj_info more\n";
  const Scene scene = sceneOfPly(square.text());
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(PlyAsFound, WhatLiesBehindItsElementsIsTold) {
  PlySquare square;
  square.more = " \n";
  EXPECT_THAT(sceneOfPly(square.text()).warnings, IsEmpty());
  square.more = "3 0 1 2";
  const Scene scene = sceneOfPly(square.text());
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
  EXPECT_THAT(scene.warnings, ElementsAre("model.ply: 7 bytes are behind what its header counts, and left out"));
}

TEST(PlyAsFound, ColoursOfVerticesHaveManyNames) {
  for (const std::string prefix : {"", "diffuse_"})
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"red", "green", "blue"}, std::vector<std::string>{"r", "g", "b"}}) {
      if (!prefix.empty() && names[0] == "r") continue;
      PlySquare square;
      for (const std::string& name : names) square.of_vertex += "property uchar " + prefix + name + "\n";
      square.vertices = {"255 188 0", "0 0 0", "0 0 0", "0 0 0"};
      const Scene scene = sceneOfPly(square.text());
      EXPECT_EQ(colorAt(scene, 0).r, 1.0f) << prefix << names[0];
      EXPECT_NEAR(colorAt(scene, 0).g, 0.5028864f, 1e-5f);
      EXPECT_EQ(colorAt(scene, 0).a, 1.0f);
      EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1)) << "they are shown as they are";
      EXPECT_THAT(scene.warnings, IsEmpty());
    }
}

TEST(PlyAsFound, ColoursAreInPartsOfWhatTheirTypeHolds) {
  const auto readRed = [](const std::string& type, const std::string& red, bool is_told) {
    PlySquare square;
    for (const std::string name : {"red", "green", "blue"}) square.of_vertex += "property " + type + " " + name + "\n";
    square.vertices = std::vector<std::string>(4, red + " 0 0");
    const Scene scene = sceneOfPly(square.text());
    EXPECT_EQ(scene.warnings.size(), is_told ? 1u : 0u) << type << red;
    if (is_told) EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("are read as codes of 255")));
    return colorAt(scene, 0).r;
  };
  EXPECT_NEAR(readRed("ushort", "48316", false), 0.5028864f, 1e-3f) << "188/255 of 65535";
  EXPECT_NEAR(readRed("ushort", "188", true), 0.5028864f, 1e-5f);
  EXPECT_NEAR(readRed("int", "188", true), 0.5028864f, 1e-5f);
  EXPECT_NEAR(readRed("float", "188", true), 0.5028864f, 1e-5f);
  EXPECT_EQ(readRed("float", "0.25", false), 0.25f) << "linear";
  EXPECT_EQ(readRed("float", "nan", false), 1.0f);
}

TEST(PlyAsFound, ColoursOfFloatsThatAreNotWholeAreCutAtOne) {
  PlySquare square;
  for (const std::string name : {"red", "green", "blue"}) square.of_vertex += "property float " + name + "\n";
  square.vertices = {"1.0001 0.25 0", "0.5 0 0", "0 0 0", "0 0 0"};
  const Scene rounded = sceneOfPly(square.text());
  EXPECT_EQ(colorAt(rounded, 0), glm::vec4(1, 0.25f, 0, 1));
  EXPECT_EQ(colorAt(rounded, 1), glm::vec4(0.5f, 0, 0, 1));
  EXPECT_THAT(rounded.warnings, IsEmpty());
  square.vertices[0] = "1.5 0.25 -1";
  const Scene bright = sceneOfPly(square.text());
  EXPECT_EQ(colorAt(bright, 0), glm::vec4(1, 0.25f, 0, 1));
  EXPECT_THAT(bright.warnings, ElementsAre(HasSubstr("go from -1 to 1.5, and are cut to 0 to 1")));
}

TEST(PlyAsFound, OpacitiesAreInPartsOfWhatTheirOwnTypeHolds) {
  const auto readAlpha = [](const std::string& type, const std::string& of_alpha, const std::string& color) {
    PlySquare square;
    for (const std::string name : {"red", "green", "blue"}) square.of_vertex += "property " + type + " " + name + "\n";
    square.of_vertex += "property " + of_alpha + " alpha\n";
    square.vertices = std::vector<std::string>(4, color);
    return colorAt(sceneOfPly(square.text()), 0).a;
  };
  EXPECT_EQ(readAlpha("uchar", "float", "255 0 0 0.5"), 0.5f);
  EXPECT_EQ(readAlpha("float", "uchar", "0.5 0 0 51"), 0.2f);
  EXPECT_EQ(readAlpha("float", "float", "255 0 0 1"), 1.0f);
  EXPECT_EQ(readAlpha("float", "float", "255 0 0 51"), 0.2f);
  EXPECT_EQ(readAlpha("uchar", "ushort", "255 0 0 65535"), 1.0f);
}

TEST(PlyAsFound, EachElementOfFacesHasItsOwnColours) {
  const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string list = "element face 1\nproperty list uchar int vertex_indices\n";
  PlySquare square{.of_face = colors + list + colors, .faces = {"188 0 0", "188 188 0"}};
  std::string text = square.text();
  text.replace(text.find("element face 2"), 14, "element face 1");
  const Scene two = sceneOfPly(text);
  EXPECT_NEAR(colorAt(two, 0).r, 0.5028864f, 1e-5f) << "turned into light once";
  EXPECT_NEAR(colorAt(two, 3).g, 0.5028864f, 1e-5f);
  square.of_face = list + colors;
  square.faces = {"", "0 188 0"};
  text = square.text();
  text.replace(text.find("element face 2"), 14, "element face 1");
  EXPECT_EQ(colorAt(sceneOfPly(text), 0), glm::vec4(1)) << "the first has none";
}

TEST(PlyAsFound, ColoursOfFacesAreShown) {
  PlySquare square;
  square.of_face = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  square.faces = {"255 0 0", "0 255 0"};
  const Scene scene = sceneOfPly(square.text());
  for (std::size_t corner = 0; corner < 6; ++corner)
    EXPECT_EQ(colorAt(scene, corner), corner < 3 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1)) << corner;
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1));
  EXPECT_THAT(scene.warnings, IsEmpty());
  square.of_vertex = square.of_face;
  square.vertices = std::vector<std::string>(4, "0 0 255");
  const Scene both = sceneOfPly(square.text());
  EXPECT_EQ(colorAt(both, 0), glm::vec4(1, 0, 0, 1));
  EXPECT_THAT(both.warnings, ElementsAre(HasSubstr("those of the faces are shown")));
}

TEST(PlyAsFound, NormalsWithoutADirectionAreMadeForThoseVerticesAlone) {
  PlySquare square;
  square.of_vertex = "property float nx\nproperty float ny\nproperty float nz\n";
  for (const std::string normal : {"nan nan nan", "0 0 0", "-nan(ind) 0 1"}) {
    square.vertices = {"0 0.6 0.8", "0 0.6 0.8", "0 0.6 0.8", normal};
    const Scene scene = sceneOfPly(square.text());
    for (const Vertex& vertex : scene.meshes.at(0)->vertices) {
      const bool is_made = vertex.position == glm::vec3(-1, 1, 0);
      EXPECT_LT(glm::length(vertex.normal - (is_made ? glm::vec3(0, 0, 1) : glm::vec3(0, 0.6f, 0.8f))), 1e-6f);
    }
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("1 normal has no direction and is made")));
  }
  square.vertices = std::vector<std::string>(4, "0 0 0");
  EXPECT_EQ(sceneOfPly(square.text()).meshes.at(0)->vertices[0].normal, glm::vec3(0, 0, 1)) << "as where it has none";
}

TEST(PlyAsFound, TrianglesThatAreNowhereAreLeftOut) {
  PlySquare square;
  std::string text = square.text();
  text.replace(text.find("-1 1 0"), 6, "-1 nan 0");
  const Scene scene = sceneOfPly(text);
  EXPECT_NEAR(totalArea(scene), 2.0, 1e-6);
  EXPECT_THAT(scene.warnings, ElementsAre("model.ply: 1 triangle reaches NaN or infinity and is left out"));
}

TEST(PlyAsFound, HeadersHaveLinesOfAnyKind) {
  PlySquare square{.comments = "comment made by hand\nobj_info a b c\n\n"};
  const std::string text = square.text();
  for (const char* end : {"\r\n", "\r"}) {
    std::string other = text;
    for (std::size_t at = other.find('\n'); at != std::string::npos; at = other.find('\n', at + 2))
      other.replace(at, 1, end);
    EXPECT_NEAR(totalArea(sceneOfPly(other)), 4.0, 1e-6);
  }
  EXPECT_NEAR(totalArea(sceneOfPly("\xEF\xBB\xBF" + text)), 4.0, 1e-6);
}

TEST(PlyAsFound, ElementsAndListsThatAreNotKnownArePassedOver) {
  PlySquare square{.type = "double", .of_vertex = "property float quality\nproperty list uchar int rings\n"};
  square.vertices = {"0.5 2 7 8", "0.5 0", "0.5 1 9", "nan 0"};
  square.of_face = "property list uchar float weights\nproperty int flags\nelement edge 1\nproperty int vertex1\n";
  square.faces = {"1 0.5 0", "0 7"};
  square.more = "4\n";
  const Scene scene = sceneOfPly(square.text());
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(PlyAsFound, PointsAreRefusedWithWhatHelps) {
  const std::string begin =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const auto refusal = [](const std::string& text) {
    const Result<Scene> scene = decodePly(testing::toBytes(text), "model.ply");
    return scene ? "" : scene.error().message;
  };
  EXPECT_THAT(refusal(begin + "end_header\n0 0 0\n"), HasSubstr("make one of them in MeshLab"));
  EXPECT_THAT(refusal(begin + "element face 0\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"),
              HasSubstr("1 point"));
  EXPECT_THAT(refusal(begin + "property float f_dc_0\nproperty float scale_0\nend_header\n0 0 0 1 1\n"),
              HasSubstr("Gaussian splats"));
}

class PlyFolderTest : public testing::MeshFolderTest {};

// As MeshLab and photogrammetry write them: the picture in a comment, its coordinates of each face's corners.
TEST_F(PlyFolderTest, APictureOfCommentsHasCoordinatesOfCorners) {
  writePicture("tex one.ppm", {255, 0, 0});
  PlySquare square{.comments = "comment VCGLIB generated\ncomment TextureFile tex one.ppm\n"};
  for (const std::string name : {"texcoord", "t"}) {
    square.of_face = "property list uchar float " + name + "\n";
    square.faces = {"6 0 0 1 0 1 1", "6 0.5 0 1 1 0 1"};
    const Scene scene = sceneOfPly(square.text(), path("model.ply"));
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_THAT(scene.textures[0].image.samples(), ElementsAre(255, 0, 0, 255));
    EXPECT_EQ(scene.materials.at(0).base_color_map.texture, 0);
    EXPECT_EQ(scene.materials[0].base_color, glm::vec3(1));
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.vertices[mesh.indices.at(0)].uv[0], glm::vec2(0, 1));
    EXPECT_EQ(mesh.vertices[mesh.indices.at(3)].uv[0], glm::vec2(0.5f, 1)) << "of the same vertex, in another face";
    EXPECT_THAT(scene.warnings, IsEmpty());
  }
}

TEST_F(PlyFolderTest, FacesChooseTheirPictureByNumber) {
  writePicture("a.ppm", {255, 0, 0});
  writePicture("b.ppm", {0, 0, 255});
  PlySquare square{.comments = "comment TextureFile a.ppm\ncomment TextureFile b.ppm\n"};
  square.of_face = "property list uchar float texcoord\nproperty int texnumber\n";
  square.faces = {"6 0 0 1 0 1 1 0", "6 0 0 1 1 0 1 1"};
  const Scene scene = sceneOfPly(square.text(), path("model.ply"));
  ASSERT_EQ(scene.meshes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Material& material = scene.materials.at(std::size_t(scene.meshes[i]->material));
    EXPECT_EQ(scene.textures.at(std::size_t(material.base_color_map.texture)).image.texel(0, 0)[i == 0 ? 0 : 2], 255);
    EXPECT_EQ(scene.meshes[i]->indices.size(), 3u);
  }
}

TEST_F(PlyFolderTest, APictureStandsBeforeColoursAndMayBeMissing) {
  PlySquare square{.comments = "comment TextureFile a.ppm\n"};
  square.of_vertex =
      "property float u\nproperty float v\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  square.vertices = std::vector<std::string>(4, "0.25 0.75 0 255 0");
  const Scene missing = sceneOfPly(square.text(), path("model.ply"));
  EXPECT_EQ(colorAt(missing, 0), glm::vec4(0, 1, 0, 1));
  EXPECT_THAT(missing.warnings, ElementsAre(HasSubstr("'a.ppm' is missing")));
  writePicture("a.ppm", {255, 0, 0});
  const Scene shown = sceneOfPly(square.text(), path("model.ply"));
  EXPECT_EQ(colorAt(shown, 0), glm::vec4(1));
  EXPECT_THAT(shown.warnings, ElementsAre(HasSubstr("colours beside its picture, which alone is shown")));
}

}  // namespace
}  // namespace mirrorball
