#include "mirrorball/scene/mesh_file/obj.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Bytes objBytes(std::string_view text) { return Bytes(text.begin(), text.end()); }

Result<Scene> decodeObjText(std::string_view text) {
  return decodeObj(objBytes(text), std::filesystem::path(::testing::TempDir()) / "model.obj");
}

void expectObjRefused(std::string_view text, const std::string& part) {
  const Result<Scene> scene = decodeObjText(text);
  ASSERT_FALSE(scene) << part;
  EXPECT_EQ(scene.error().code, ErrorCode::bad_file);
  EXPECT_THAT(scene.error().message, Not(HasSubstr("model.obj")));
  EXPECT_THAT(scene.error().message, HasSubstr(part));
}

void writeText(const char* name, std::string_view text) {
  ASSERT_TRUE(writeFile(std::filesystem::path(::testing::TempDir()) / name, objBytes(text)));
}

TEST(Obj, SharesVerticesAndTurnsV) {
  const Result<Scene> scene = decodeObjText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\n"
      "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
  ASSERT_TRUE(scene) << scene.error().message;
  const Mesh& mesh = scene->meshes.at(0);
  ASSERT_EQ(mesh.vertices.size(), 4u);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(mesh.vertices[3].uv[0], glm::vec2(0, 0));
  EXPECT_EQ(mesh.vertices[3].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.vertices[3].tangent, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(scene->materials.size(), 1u);
}

TEST(Obj, CountsBackwardsAndForwards) {
  const Result<Scene> scene = decodeObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf 1 2 4\nv 0 0 1\n");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->meshes.at(0)->indices.size(), 6u);
  EXPECT_EQ(scene->meshes[0]->vertices.back().position, glm::vec3(0, 0, 1));
}

TEST(Obj, SmoothsAcrossSeamsOfTheTextureCoordinates) {
  // A fold of two faces that share an edge but not its texture coordinates.
  const Result<Scene> scene = decodeObjText(
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\ns 1\n"
      "f 1/1 3/2 2/3\nf 1/4 2/2 4/3\n");
  ASSERT_TRUE(scene) << scene.error().message;
  const Mesh& mesh = scene->meshes.at(0);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  for (const Vertex& vertex : mesh.vertices) {
    if (vertex.position == glm::vec3(0, 0, 0)) {
      EXPECT_NEAR(vertex.normal.z, 0.70711f, 1e-4f);
      EXPECT_NEAR(vertex.normal.x, -0.70711f, 1e-4f);
    }
  }
}

/// A box of six squares, with `before` ahead of each face.
std::string boxText(std::string_view before) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  for (const char* face : {"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"})
    text += std::string(before) + "f " + face + "\n";
  return text;
}

/// A ball of triangles, each of whose edges turns by 15° or less.
std::string ballText(std::string_view before) {
  const Mesh ball = sphereMesh(12, 24);
  std::string text(before);
  std::map<std::array<long, 3>, std::size_t> places;
  std::string faces;
  for (std::size_t i = 0; i < ball.indices.size(); ++i) {
    const glm::vec3 position = glm::round(ball.vertices[ball.indices[i]].position * 1e5f);
    const std::array place{std::lround(position.x), std::lround(position.y), std::lround(position.z)};
    const auto [found, is_new] = places.emplace(place, places.size() + 1);
    if (is_new)
      text += "v " + std::to_string(position.x) + " " + std::to_string(position.y) + " " + std::to_string(position.z) +
              "\n";
    faces += (i % 3 == 0 ? "\nf " : " ") + std::to_string(found->second);
  }
  return text + faces + "\n";
}

/// The mean cosine between the normals of a model's vertices and the way from `center` to them.
float roundness(const Scene& scene, glm::vec3 center) {
  float sum = 0.0f;
  for (const Vertex& vertex : scene.meshes.at(0)->vertices)
    sum += glm::dot(vertex.normal, glm::normalize(vertex.position - center));
  return sum / static_cast<float>(scene.meshes[0]->vertices.size());
}

TEST(Obj, WithoutNormalsABoxIsSharpAndABallIsSmooth) {
  const Scene box = *decodeObjText(boxText(""));
  EXPECT_EQ(box.meshes.at(0)->vertices.size(), 24u);
  for (const Vertex& vertex : box.meshes[0]->vertices)
    EXPECT_EQ(std::max({std::abs(vertex.normal.x), std::abs(vertex.normal.y), std::abs(vertex.normal.z)}), 1.0f);
  const Scene ball = *decodeObjText(ballText(""));
  EXPECT_EQ(ball.meshes.at(0)->vertices.size(), 11u * 24u + 2u);
  EXPECT_GT(roundness(ball, glm::vec3(0.0f)), 0.9999f);
}

TEST(Obj, SmoothingGroupsSayWhatIsSmooth) {
  EXPECT_EQ(decodeObjText(boxText("s 7\n"))->meshes.at(0)->vertices.size(), 8u) << "one group";
  EXPECT_GT(roundness(*decodeObjText(boxText(" s\t7 \r\n")), glm::vec3(0.5f)), 0.999f);
  EXPECT_EQ(decodeObjText("s 1\n" + boxText("s off\n"))->meshes.at(0)->vertices.size(), 24u);
  const std::size_t triangles = 24u * 22u;
  EXPECT_EQ(decodeObjText(ballText("s off\n"))->meshes.at(0)->vertices.size(), 3u * triangles);
  EXPECT_EQ(decodeObjText(ballText("s 0\n"))->meshes.at(0)->vertices.size(), 3u * triangles);
  EXPECT_EQ(decodeObjText(ballText("s 2\n"))->meshes.at(0)->vertices.size(), 11u * 24u + 2u);
  // The four sides of the box are one group, top and bottom have others; before the first `s` all is off.
  std::string groups = boxText("");
  groups.insert(groups.find("f 1 2 6 5"), "s 3\n");
  const Scene tube = *decodeObjText(groups);
  EXPECT_EQ(tube.meshes.at(0)->vertices.size(), 4u + 4u + 8u);
}

TEST(Obj, ReadsMaterialsAndTheirPictures) {
  Image8 picture(1, 1, 3, 128);
  ASSERT_TRUE(savePicture(std::filesystem::path(::testing::TempDir()) / "obj_colour.png", picture));
  writeText("obj_test.mtl",
            "newmtl shiny\nKd 0.5 0.25 0.125\nKs 1 1 1\nNs 198\nNi 1.33\nd 0.5\nKe 2 0 0\n"
            "newmtl painted\nKd 1 1 1\nmap_Kd obj_colour.png\nmap_Bump bumps.png\nPr 0.3\nPm 1\n"
            "newmtl broken\nmap_Kd no_such.png\n"
            "newmtl unused\nKd 1 0 0\n");
  const Result<Scene> scene = decodeObjText(
      "mtllib obj_test.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl painted\nf 1 2 3\nusemtl shiny\nf 1 2 3\n"
      "usemtl painted\nf 3 2 1\nusemtl broken\nf 1 2 3\nusemtl unheard\nf 1 2 3\n");
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->meshes.size(), 4u);
  ASSERT_EQ(scene->materials.size(), 4u);
  std::map<std::string, const Material*> named;
  for (const Mesh& mesh : scene->meshes) {
    const Material& material = scene->materials.at(std::size_t(mesh.material));
    named[material.name] = &material;
    EXPECT_EQ(mesh.indices.size(), material.name == "painted" ? 6u : 3u) << material.name;
  }
  const Material& shiny = *named.at("shiny");
  EXPECT_EQ(shiny.base_color, glm::vec3(0.5f, 0.25f, 0.125f));
  EXPECT_NEAR(shiny.perceptual_roughness, std::sqrt(0.1f), 1e-6f);  // α = √(2/200)
  EXPECT_FLOAT_EQ(shiny.ior, 1.33f);
  EXPECT_FLOAT_EQ(shiny.opacity, 0.5f);
  EXPECT_EQ(shiny.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(shiny.emission, glm::vec3(2, 0, 0));
  const Material& painted = *named.at("painted");
  EXPECT_FLOAT_EQ(painted.perceptual_roughness, 0.3f);
  EXPECT_EQ(painted.metallic, 1.0f);
  const Texture& texture = scene->textures.at(std::size_t(painted.base_color_map.texture));
  EXPECT_TRUE(texture.srgb);
  EXPECT_EQ(texture.image.texel(0, 0)[0], 128);
  EXPECT_EQ(named.at("broken")->base_color_map.texture, -1);
  EXPECT_THAT(scene->warnings, Contains(HasSubstr("no_such.png")));
  EXPECT_THAT(scene->warnings, Contains(HasSubstr("'bumps.png' is missing")));
  EXPECT_THAT(scene->warnings, Contains(HasSubstr("'unheard'")));
}

// The formats that .mtl files name most beside PNG and JPEG.
TEST(Obj, PicturesMayBeTgaBmpOrPpm) {
  const std::vector<std::pair<std::string, Bytes>> pictures{
      {"colour.tga", testing::tgaFile({.width = 1, .height = 1}, {3, 2, 1})},
      {"colour.bmp", testing::bmpFile({.width = 1, .height = 1}, {3, 2, 1, 0})},
      {"colour.ppm", {'P', '6', ' ', '1', ' ', '1', ' ', '2', '5', '5', '\n', 1, 2, 3}}};
  for (const auto& [name, bytes] : pictures) {
    ASSERT_TRUE(writeFile(std::filesystem::path(::testing::TempDir()) / name, bytes));
    writeText("obj_formats.mtl", "newmtl painted\nmap_Kd " + name + "\n");
    const Result<Scene> scene =
        decodeObjText("mtllib obj_formats.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl painted\nf 1 2 3\n");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_THAT(scene->warnings, ::testing::IsEmpty());
    EXPECT_THAT(scene->textures.at(0).image.samples(), ::testing::ElementsAre(1, 2, 3, 255)) << name;
  }
}

// Whoever names a table once more is told what is known: it is read once, and its materials are handed on once.
TEST(Obj, ManyLinesThatNameTablesTakeLittleTime) {
  std::string table;
  for (int i = 0; i < 1000; ++i) table += "newmtl red" + std::to_string(i) + "\nKd 1 0 0\n";
  writeText("obj_many.mtl", table);
  std::string text, spelling = "obj_many.mtl";
  for (int i = 0; i < 30'000; ++i) text += "mtllib obj_many.mtl\nmtllib nowhere.mtl\n";
  for (int i = 0; i < 500; ++i) text += "mtllib " + (spelling = "./" + spelling) + "\n";
  const auto begin = std::chrono::steady_clock::now();
  const Result<Scene> scene = decodeObjText(text + "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red999\nf 1 2 3\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(scene->warnings, ::testing::ElementsAre(HasSubstr("nowhere.mtl"))) << "once";
  EXPECT_THAT(scene->files, ::testing::SizeIs(1));
  EXPECT_EQ(scene->materials.at(0).name, "red999");
}

TEST(Obj, WithoutItsMaterialsIsAWarning) {
  const Result<Scene> scene = decodeObjText("mtllib nowhere.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(scene->warnings, Contains(HasSubstr("nowhere.mtl")));
  EXPECT_EQ(scene->materials.size(), 1u);
}

TEST(Obj, WhatItSaysIsQuoted) {
  const std::string name = "\x1b[2J\x9b" + std::string(100'000, 'x');
  writeText("obj_quoted.mtl", "newmtl red\nmap_Kd " + name + "\nbump " + name + "\n");
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const Result<Scene> scene = decodeObjText("mtllib " + name + "\nmtllib obj_quoted.mtl\nusemtl " + name + "\n" +
                                            triangle + "usemtl red\nf 1 2 3\n");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->warnings.size(), 3u) << "of a picture that is named twice, one";
  for (const std::string& warning : scene->warnings) {
    EXPECT_THAT(warning, HasSubstr("'?[2J?xxx"));
    EXPECT_LT(warning.size(), 400u);
  }
  expectObjRefused("v \x1b[2J 0 0\n" + triangle, "'?[2J' is not a number");
}

TEST(Obj, NamesWhatIsWrong) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expectObjRefused("", "holds no faces; it is not an OBJ file");
  expectObjRefused("just text\n", "holds no faces");
  expectObjRefused("v 0 0 0\nl 1 1\n", "1 line is left out, since only faces are drawn");
  const Result<Scene> points = decodeObjText("v 0 0 0\nv 1 0 0\n");
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().code, ErrorCode::unsupported);
  EXPECT_THAT(points.error().message, HasSubstr("holds no faces, but 2 points; only surfaces can be drawn: make one"));
  expectObjRefused("v 0 0 0\nf 1 1\n", "1 face is left out that has fewer corners than three");
  expectObjRefused("v 0 0 0\nf 1 2 4\n", "1 triangle names a vertex that is not there");
  expectObjRefused("v 0 0 1e999\n" + triangle, "1 triangle reaches NaN or infinity");
  expectObjRefused("v nan 0 0\n" + triangle, "1 triangle reaches NaN or infinity");
  expectObjRefused("v one 0 0\n" + triangle, "line 1: 'one' is not a number");
  EXPECT_TRUE(decodeObjText("v 0 0 0 # nan\nv +1.5e-3 0 0\nv 0 1E2 0\nvx nan\nf 1 2 3\n"));
}

TEST(Obj, MemoryIsAskedForBeforeItIsTaken) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(std::uint64_t{1} << 20);
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 2000; ++i) text += "  f 1\t2  3\r\n";
  const Result<Scene> refused = decodeObjText(text);
  const Result<Scene> smaller = decodeObjText(text.substr(0, text.size() / 4));
  setMemoryLimit(before);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_TRUE(smaller) << smaller.error().message;
  EXPECT_TRUE(decodeObjText(text));
}

TEST(Obj, SurvivesRandomDamage) {
  const std::string whole =
      "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nvt 0 0\nvn 0 0 1\ng part\nusemtl a\n"
      "f 1/1/1 2/1/1 3/1/1 4/1/1 5/1/1\nf -1 -2 -3\ns 1\n";
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole;
    for (int flips = 0; flips < 3; ++flips) {
      char& letter = damaged[random() % damaged.size()];
      letter = static_cast<char>(letter ^ (1 << random() % 8));
    }
    const Result<Scene> scene = decodeObjText(damaged);
    if (!scene) continue;
    for (const Mesh& mesh : scene->meshes)
      for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  }
}

}  // namespace
}  // namespace mirrorball
