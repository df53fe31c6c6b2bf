// OBJ files as programs write them: what stands in each is read as by the programs that read them.

#include "mirrorball/scene/mesh_file/obj_geometry.h"

#include <cmath>
#include <string>

#include "mirrorball/scene/mesh_file/mesh_file_testing.h"
#include "mirrorball/scene/mesh_file/obj.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::totalArea;

Scene sceneOfObj(std::string_view text) {
  Result<Scene> scene = decodeObj(testing::toBytes(text), "model.obj");
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene();
}

/// Expects the square from −1 to 1, read without a remark.
void expectSquare(std::string_view text) {
  const Scene scene = sceneOfObj(text);
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6) << text;
  EXPECT_THAT(scene.warnings, IsEmpty()) << text;
}

const std::string kSquareVertices = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

TEST(ObjGeometry, LinesOfManyKindsAreRead) {
  expectSquare(kSquareVertices + "f 1 2 3 4\n");
  expectSquare("\xEF\xBB\xBF" + kSquareVertices + "f 1 2 3 4\n");
  expectSquare(kSquareVertices + "f 1 2 \\\n3 4");
  expectSquare(kSquareVertices + "f 1 2 \\\r\n3 \\\r\n4\r\n");
  expectSquare("# C:\\models\\\n" + kSquareVertices + "f 1 2 3 4\n");
  expectSquare("v\t-1\t-1\t0\r\rv 1 -1 0\rv 1 1 0\rv -1 1 0\rf 1 2 3 4\r");
  expectSquare("  V -1 -1 0\n\n" + kSquareVertices.substr(kSquareVertices.find('\n') + 1) + "F 1 2 3 4 # front\n");
  expectSquare(kSquareVertices + "fo 1 2 3 4\n");
  expectSquare(kSquareVertices + "f -4 -3 -2 -1\n");
  expectSquare(kSquareVertices + "vt 0 0 0\nvn 0 0 1\nf 1/1/ 2/1/ 3/1/ 4/1/\n");
  expectSquare(kSquareVertices + "vn 0 0 1\nf 1/0/1 2/0/1 3/0/1 4/0/1\n");
  expectSquare("v -1 -1 0 1.0\nv 1 -1 0 1\nv 1 1 0 1\nv -1 1 0 1\nf 1 2 3 4\n");
}

TEST(ObjGeometry, WhatIsNotAFaceIsLeftOutAndTold) {
  const auto remarks = [](const std::string& more) {
    const Scene scene = sceneOfObj(kSquareVertices + "f 1 2 3 4\n" + more);
    EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
    return scene.warnings;
  };
  EXPECT_THAT(remarks("l 1 2\nl 2 3\np 1\n"),
              ElementsAre("model.obj: 2 lines and 1 point are left out, since only faces are drawn"));
  EXPECT_THAT(remarks("p 1\n"), ElementsAre("model.obj: 1 point is left out, since only faces are drawn"));
  EXPECT_THAT(remarks("cstype bspline\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\n"),
              ElementsAre("model.obj: 1 free-form curve or surface is left out; export the model as polygons"));
}

// What C's atof and JavaScript's parseInt pass over.
TEST(ObjGeometry, CommasAndPointsBehindNumbersArePassedOver) {
  const Scene list = sceneOfObj("v -1.0, -1, 0\nv 1, -1.0, 0\nv 1, 1, 0\nv -1, 1, 0\nf 1 2 3 4\n");
  EXPECT_NEAR(totalArea(list), 4.0, 1e-6);
  EXPECT_THAT(list.warnings, ElementsAre("model.obj: has commas behind numbers (the first in line 1: '-1.0,'), which "
                                         "are passed over"));
  for (const char* face : {"f 1.0 2.0 3.00 4\n", "f 1, 2, 3, 4\n", "f 1.0/1.0 2.0/1.0 3/1 4/1.\n"}) {
    const Scene scene = sceneOfObj(kSquareVertices + "vt 0 0\n" + face);
    EXPECT_NEAR(totalArea(scene), 4.0, 1e-6) << face;
    EXPECT_THAT(scene.warnings, ElementsAre("model.obj: line 6: has a point or a comma behind an index, which is read "
                                            "without it"));
  }
  for (const char* face : {"f 1.5 2 3\n", "f 1,2,3,4\n", "f . 2 3\n", "f , 2 3\n", "f 1.0.0 2 3\n"})
    EXPECT_FALSE(decodeObj(testing::toBytes(kSquareVertices + face), "model.obj")) << face;
}

TEST(ObjGeometry, NumbersThatAreNoneLeaveOutTheirTrianglesAlone) {
  const Scene scene = sceneOfObj(kSquareVertices + "v nan 0 0\nv 1 2\nf 1 2 3 4\nf 1 2 5\nf 1 6 2 3\n");
  EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
  EXPECT_THAT(scene.warnings, ElementsAre("model.obj: 3 triangles reach NaN or infinity and are left out"));
  const Scene comma = sceneOfObj("v -1,0 -1 0\nv 1 -1,0 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  EXPECT_NEAR(totalArea(comma), 4.0, 1e-6);
  EXPECT_THAT(comma.warnings, ElementsAre(HasSubstr("has decimal commas (the first in line 1: '-1,0')")));
}

TEST(ObjGeometry, NormalsWithoutADirectionAreMadeForThoseCornersAlone) {
  for (const char* normal : {"nan nan nan", "-1.#IND00 -1.#IND00 -1.#IND00", "-nan(ind) 0 0", "0 0 0", "1e300 0 0"}) {
    const Scene scene =
        sceneOfObj(kSquareVertices + "vn 0 0.6 0.8\nvn " + normal + "\nf 1//1 2//1 3//1\nf 1//1 3//1 4//2\n");
    std::size_t made = 0;
    for (const Vertex& vertex : scene.meshes.at(0)->vertices) {
      const bool is_made = vertex.position == glm::vec3(-1, 1, 0);
      EXPECT_LT(glm::length(vertex.normal - (is_made ? glm::vec3(0, 0, 1) : glm::vec3(0, 0.6f, 0.8f))), 1e-6f)
          << normal;
      made += is_made ? 1 : 0;
    }
    EXPECT_EQ(made, 1u);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("1 normal has no direction and is made")));
  }
}

TEST(ObjGeometry, FacesThatNameWhatIsNotThereAreLeftOutOrGoWithout) {
  const Scene scene = sceneOfObj(
      kSquareVertices + "f 1 2 3 4\nf 1 2 5\nf 0 1 2\nf -9 1 2\nf 1 2 x\nf 1 2\nf 1/7 2/7 3/7\nf 1//7 2//7 3//7\n");
  EXPECT_NEAR(totalArea(scene), 4.0 + 2.0 + 2.0, 1e-6);
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("1 face is left out that has fewer corners than three"),
                          HasSubstr("6 corners of faces name normals or texture coordinates that are not there"),
                          HasSubstr("4 triangles name vertices that are not there and are left out")));
}

TEST(ObjGeometry, CoordinatesThatAreNoNumbersAreZero) {
  const Scene scene = sceneOfObj(kSquareVertices + "vt 0.5 0.5\nvt -nan(ind) 0\nf 1/1 2/1 3/2\n");
  for (const Vertex& vertex : scene.meshes.at(0)->vertices)
    EXPECT_EQ(vertex.uv[0], vertex.position == glm::vec3(1, 1, 0) ? glm::vec2(0) : glm::vec2(0.5f));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("1 texture coordinate holds NaN or infinity and is read as 0")));
}

// MeshLab, MeshMixer, Blender: from 0 to 1, sRGB.
TEST(ObjGeometry, ColoursBehindPositionsAreThoseOfTheVertices) {
  const Scene scene = sceneOfObj("v -1 -1 0 1 0 0\nv 1 -1 0 0 0.735357 0\nv 1 1 0 nan 1 1\nv -1 1 0\nf 1 2 3 4\n");
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.vertices[0].color, glm::vec4(1, 0, 0, 1));
  EXPECT_NEAR(mesh.vertices[1].color.g, 0.5f, 1e-5f);
  EXPECT_EQ(mesh.vertices[2].color, glm::vec4(1));
  EXPECT_EQ(mesh.vertices[3].color, glm::vec4(1)) << "white, as where a file has none";
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1)) << "they are shown as they are";
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(ObjGeometry, ColoursBeyondOneAreCodes) {
  const Scene scene = sceneOfObj("v -1 -1 0 255 0 188\nv 1 -1 0 0 0 0\nv 1 1 0 0 0 0\nf 1 2 3\n");
  EXPECT_NEAR(scene.meshes.at(0)->vertices[0].color.r, 1.0f, 1e-6f);
  EXPECT_NEAR(scene.meshes[0]->vertices[0].color.b, 0.5028864f, 1e-5f);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("up to 255, beyond the 1 that is usual: they are read as codes")));
}

// One vertex of a scan that rounding, or light, has left above 1 says nothing of the others.
TEST(ObjGeometry, ColoursThatAreNotWholeAreCutAtOne) {
  const auto load = [](const std::string& red) {
    return sceneOfObj("v -1 -1 0 " + red + " 0 0\nv 1 -1 0 0.735357 0 0\nv 1 1 0 0 0 0\nf 1 2 3\n");
  };
  for (const std::string red : {"1.0001", "1.5"}) {
    const Scene scene = load(red);
    EXPECT_EQ(scene.meshes.at(0)->vertices[0].color.r, 1.0f);
    EXPECT_NEAR(scene.meshes[0]->vertices[1].color.r, 0.5f, 1e-5f);
  }
  EXPECT_THAT(load("1.0001").warnings, IsEmpty());
  EXPECT_THAT(load("1.5").warnings, ElementsAre(HasSubstr("from 0 to 1.5: they are cut to 0 to 1")));
}

// ZBrush keeps its polypaint in comments: a mask and a colour each.
TEST(ObjGeometry, PolypaintIsRead) {
  const Scene scene = sceneOfObj(kSquareVertices + "#MRGB ffff0000ff00ff00ff0000ff\n#MRGB ffbc0000\nf 1 2 3 4\n");
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.vertices[0].color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(mesh.vertices[1].color, glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(mesh.vertices[2].color, glm::vec4(0, 0, 1, 1));
  EXPECT_NEAR(mesh.vertices[3].color.r, 0.5028864f, 1e-5f);
}

TEST(ObjGeometry, AWeightThatIsNotOneIsLeftOutWithARemark) {
  const Scene scene = sceneOfObj("v -1 -1 0 2\nv 1 -1 0 1\nv 1 1 0 1\nf 1 2 3\n");
  EXPECT_EQ(scene.meshes.at(0)->vertices[0].position, glm::vec3(-1, -1, 0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("line 1: the weight of a vertex is not 1")));
}

TEST(ObjGeometry, IsReadAsFarAsItGoesWhereverItIsCut) {
  const std::string whole =
      "mtllib a.mtl\n" + kSquareVertices + "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1/1/1 2/1/1 3/1/1\n";
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const Result<Scene> scene = decodeObj(testing::toBytes(whole.substr(0, size)), "model.obj");
    EXPECT_EQ(bool(scene), size >= whole.size() - 5) << size;
  }
}

TEST(ObjGeometry, PositionsKeepTheDigitsThatAFloatLacks) {
  const ObjGeometry geometry = readObjGeometry("v 4500000.125 300000.0625 1\nv 1e39 0 0\n");
  ASSERT_EQ(geometry.positions.size(), 2u);
  EXPECT_EQ(geometry.positions[0], glm::dvec3(4500000.125, 300000.0625, 1));
  EXPECT_TRUE(std::isnan(geometry.positions[1].x));
}

}  // namespace
}  // namespace mirrorball
