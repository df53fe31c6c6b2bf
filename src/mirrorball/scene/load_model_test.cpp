#include "mirrorball/scene/load_model.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/tangents.h"
#include "test_data.h"

namespace mirrorball {
namespace {

// Whoever has one of these finds the way to glTF.
TEST(LoadModel, OthersFilesAreNamedWithTheProgramThatMakesGltfOfThem) {
  const std::string folder = ::testing::TempDir() + "load_model_";
  const auto refusal = [&](const std::string& name, const std::string& begin) {
    EXPECT_TRUE(writeFile(folder + name, Bytes(begin.begin(), begin.end())));
    return loadModel(folder + name).error().message;
  };
  EXPECT_THAT(
      refusal("a.fbx", "Kaydara FBX Binary  "),
      ::testing::HasSubstr("is an FBX, which is not read; open it in Blender and export it as glTF 2.0 (.glb)"));
  EXPECT_THAT(refusal("unnamed", "PXR-USDC"), ::testing::HasSubstr("is a USD"));
  EXPECT_THAT(refusal("a.blend", "BLENDER-v402"), ::testing::HasSubstr("is a Blender file"));
  EXPECT_THAT(refusal("a.stp", "ISO-10303-21;"), ::testing::HasSubstr("open it in FreeCAD"));
  EXPECT_THAT(refusal("a.dae", "?"), ::testing::HasSubstr("is a COLLADA, which is not read"));
  EXPECT_THAT(refusal("a.usdz", "PK\x03\x04"), ::testing::HasSubstr("is a USD"));
  EXPECT_THAT(refusal("a.txt", "hello"), ::testing::HasSubstr("model that can be read"));
}

// What came in a model's place has its name, and is not called damaged glTF.
TEST(LoadModel, WhatStandsInAModelsPlaceIsNamed) {
  for (const char* name : {"a.gltf", "a.glb", "a.obj", "a.stl", "a.ply"}) {
    const std::string path = ::testing::TempDir() + "load_model_place_" + name;
    const auto refusal = [&](std::string_view begin) {
      EXPECT_TRUE(writeFile(path, Bytes(begin.begin(), begin.end())));
      return loadModel(path).error().message;
    };
    EXPECT_EQ(refusal("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"),
              path +
                  ": is a Git LFS pointer, which is not read; run `git lfs pull`, which fetches the file that it "
                  "stands for");
    EXPECT_THAT(refusal("\n<!DOCTYPE html>\n<html>"), ::testing::HasSubstr("is a web page, which is not read"));
    EXPECT_THAT(refusal("PK\x03\x04"), ::testing::HasSubstr("is a zip archive, which is not read; unpack it"));
    EXPECT_THAT(refusal("\x1f\x8b\x08"), ::testing::HasSubstr("is compressed by gzip"));
    EXPECT_THAT(refusal("b3dm"), ::testing::HasSubstr("take the .glb out of it by `npx 3d-tiles-tools b3dmToGlb`"));
    EXPECT_THAT(refusal("i3dm"), ::testing::HasSubstr("take the .glb out of it by `npx 3d-tiles-tools i3dmToGlb`"));
    EXPECT_THAT(refusal("GIF89a"), ::testing::HasSubstr("is a GIF, a picture and no model"));
  }
}

// As Notepad and PowerShell write it, with its byte-order mark and without.
TEST(LoadModel, TextsMayBeInUtf16) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string facet = "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nendsolid a\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  testing::GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::pair<const char*, std::string> files[] = {
      {"a.obj", square}, {"a.stl", facet}, {"a.ply", ply}, {"a.gltf", maker.gltf(R"({"attributes":{"POSITION":0}})")}};
  for (const auto& [name, text] : files)
    for (const bool is_big : {false, true})
      for (const bool has_mark : {false, true}) {
        Bytes bytes;
        const auto put = [&](unsigned unit) {
          bytes.push_back(static_cast<std::uint8_t>(is_big ? unit >> 8 : unit & 0xFF));
          bytes.push_back(static_cast<std::uint8_t>(is_big ? unit & 0xFF : unit >> 8));
        };
        if (has_mark) put(0xFEFF);
        for (const char letter : text) put(static_cast<unsigned char>(letter));
        const std::string path = ::testing::TempDir() + "load_model_utf16_" + name;
        ASSERT_TRUE(writeFile(path, bytes));
        const Result<Scene> scene = loadModel(path);
        ASSERT_TRUE(scene) << scene.error().message;
        EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
        EXPECT_THAT(scene->warnings,
                    ::testing::ElementsAre(path + ": is in UTF-16, and is read as the UTF-8 that it stands for"));
      }
}

// The free text with which one begins may be in it.
TEST(LoadModel, ABinaryStlIsNoTextInUtf16) {
  const std::string path = ::testing::TempDir() + "load_model_utf16_binary.stl";
  for (const bool has_mark : {false, true})
    for (const int named : {1, 2}) {
      Bytes bytes;
      if (has_mark) bytes = {0xFF, 0xFE};
      for (const char letter : std::string_view("Exported by XYZ"))
        bytes.insert(bytes.end(), {static_cast<std::uint8_t>(letter), 0});
      bytes.resize(80);
      bytes.insert(bytes.end(), {static_cast<std::uint8_t>(named), 0, 0, 0});
      const float facet[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
      const auto* const numbers = reinterpret_cast<const std::uint8_t*>(facet);
      bytes.insert(bytes.end(), numbers, numbers + sizeof facet);
      bytes.insert(bytes.end(), {0, 0});
      ASSERT_TRUE(writeFile(path, bytes));
      const Result<Scene> scene = loadModel(path);
      ASSERT_TRUE(scene) << scene.error().message;
      EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
      EXPECT_EQ(scene->warnings.size(), named == 2 ? 1u : 0u) << "that it is truncated";
    }
}

// Beside the file's bytes are those in UTF-8, half as many again where its letters are Chinese ones.
TEST(LoadModel, AsksForTheMemoryOfBothFormsOfAText) {
  const std::string path = ::testing::TempDir() + "load_model_utf16_large.obj";
  Bytes bytes;
  for (const char letter : std::string_view("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# "))
    bytes.insert(bytes.end(), {static_cast<std::uint8_t>(letter), 0});
  bytes.resize(std::size_t{4} << 20, 0x4E);
  ASSERT_TRUE(writeFile(path, bytes));
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{8} << 20);
  const Result<Scene> refused = loadModel(path);
  setMemoryLimit(std::uint64_t{11} << 20);
  const Result<Scene> read = loadModel(path);
  setMemoryLimit(usual);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().fix_hint, FixHint::raise_memory);
  EXPECT_TRUE(read) << read.error().message;
}

using ::testing::HasSubstr;

/// What every loaded scene promises: indices in range, finite numbers.
void expectSafe(const Scene& scene) {
  for (const Instance& instance : scene.instances) ASSERT_LT(std::size_t(instance.mesh), scene.meshes.size());
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_LT(std::size_t(mesh.material), scene.materials.size());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) {
      ASSERT_TRUE(std::isfinite(glm::length(vertex.position)));
      ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-3f);
      ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-3f);
    }
  }
  for (const Material& material : scene.materials)
    for (const MaterialMap& map : materialMaps())
      ASSERT_LT((material.*map.slot).texture, static_cast<int>(scene.textures.size()));
  for (const Texture& texture : scene.textures) ASSERT_EQ(texture.image.channels(), 4);
}

TEST(LoadModel, KnowsEveryBuiltIn) {
  for (const std::string_view name : builtinModelNames()) {
    const Result<Scene> scene = loadModel(std::string(name));
    ASSERT_TRUE(scene) << name;
    EXPECT_EQ(scene->empty(), name == "none") << name;
    expectSafe(*scene);
  }
}

TEST(LoadModel, ListsWhatThereIsForAnUnknownName) {
  const Result<Scene> scene = loadModel("tepot");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::not_found);
  EXPECT_THAT(scene.error().message, HasSubstr("did you mean 'teapot'"));
  EXPECT_THAT(scene.error().message, HasSubstr("showcase"));
  EXPECT_THAT(scene.error().message, HasSubstr(".glb .gltf .obj .ply .stl"));
}

TEST(LoadModel, NamesAMissingFileAndAnUnknownKind) {
  const Result<Scene> missing = loadModel("no/such/model.glb");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
  EXPECT_THAT(missing.error().message, HasSubstr("no/such/model.glb"));

  const std::string path = ::testing::TempDir() + "model.xyz";
  ASSERT_TRUE(writeFile(path, {}));
  const Result<Scene> unknown = loadModel(path);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::unsupported);
  EXPECT_THAT(unknown.error().message, HasSubstr(".glb .gltf .obj .ply .stl"));
}

TEST(LoadModel, TellsHowFarItIsAndCanBeStopped) {
  const std::string path = ::testing::TempDir() + "/stopped.glb";
  Scene scene = *loadModel("showcase");
  scene.textures.resize(8);
  for (int i = 0; i < 8; ++i) {
    scene.textures[std::size_t(i)].image = Image8(64, 64, 4, std::uint8_t(100 + i));
    scene.materials[std::size_t(i)].base_color_map.texture = i;
  }
  ASSERT_TRUE(writeFile(path, encodeGlb(scene)->bytes));
  std::vector<std::size_t> steps;
  ModelLoadOptions options;
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 200u) << "hundredths of the meshes, then of the pictures";
    steps.push_back(done);
    return true;
  };
  ASSERT_TRUE(loadModel(path, options));
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  EXPECT_THAT(steps, ::testing::AllOf(::testing::Contains(100u), ::testing::Contains(200u)));
  for (const std::size_t most : {0u, 100u}) {
    options.progress = [most](std::size_t done, std::size_t) { return done <= most; };
    const Result<Scene> stopped = loadModel(path, options);
    ASSERT_FALSE(stopped) << most;
    EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  }
}

TEST(LoadModel, RefusesWhatIsTooLargeToDraw) {
  const std::string path = ::testing::TempDir() + "huge.obj";
  const std::string text = "v 0 0 0\nv 1e20 0 0\nv 0 1 0\nf 1 2 3\n";
  ASSERT_TRUE(writeFile(path, Bytes(text.begin(), text.end())));
  const Result<Scene> scene = loadModel(path);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::bad_file);
  EXPECT_THAT(scene.error().message, HasSubstr("scale the model down"));
}

TEST(LoadModel, TheFirstBytesCountMoreThanTheName) {
  const std::string path = ::testing::TempDir() + "named_wrongly.obj";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  ASSERT_TRUE(writeFile(path, Bytes(ply.begin(), ply.end())));
  const Result<Scene> scene = loadModel(path);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(scene->warnings, ::testing::ElementsAre(HasSubstr("is a PLY by its first bytes, and read so")));
  EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
}

TEST(LoadModel, WordsThatAFileBeginsWithDoNotCountMoreThanItsName) {
  const std::string obj = " by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const std::string word : {"ply", "plywood", "glTF", "glTF viewer"}) {
    const std::string path = ::testing::TempDir() + "begins_with_a_word.obj";
    const std::string text = word + obj;
    ASSERT_TRUE(writeFile(path, Bytes(text.begin(), text.end())));
    const Result<Scene> scene = loadModel(path);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u) << word;
    EXPECT_FALSE(isModel(Bytes(text.begin(), text.end()))) << word;
  }
  const auto begins = [](std::string_view text) { return isModel(Bytes(text.begin(), text.end())); };
  EXPECT_TRUE(begins("ply\r\nformat"));
  EXPECT_TRUE(begins({"glTF\1\0\0\0", 8})) << "it is refused by its version, and named";
  EXPECT_FALSE(begins({"glTF\2\0", 6}));
}

TEST(LoadModel, TheFilesNameStandsInFrontOfAnErrorOnce) {
  constexpr std::pair<const char*, const char*> kDamaged[] = {
      {"bad.ply", "ply\nformat ascii 1.0\n"},
      {"bad.stl", "solid\n"},
      {"bad.obj", "v 0 0 0\nf 1 2 3\n"},
      {"bad.gltf", R"({"asset": {"version": "1.0"}})"},
  };
  for (const auto& [name, text] : kDamaged) {
    const std::string path = ::testing::TempDir() + name;
    ASSERT_TRUE(writeFile(path, Bytes(text, text + std::string_view(text).size())));
    const Result<Scene> scene = loadModel(path);
    ASSERT_FALSE(scene) << name;
    EXPECT_THAT(scene.error().message, ::testing::StartsWith(path + ": "));
    EXPECT_EQ(scene.error().message.rfind(path), 0u) << scene.error().message;
  }
}

TEST(LoadModel, SaysWhereAModelIsFarAwayAndRefusesWhatIsTooSmall) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "placed.obj";
  const auto loaded = [&](const std::string& x, const std::string& size) {
    const std::string text = "v " + x + " 0 0\nv " + x + " " + size + " 0\nv " + x + " 0 " + size + "\nf 1 2 3\n";
    EXPECT_TRUE(writeFile(file, Bytes(text.begin(), text.end())));
    return loadModel(file.string());
  };
  const auto far = loaded("1e6", "1");
  ASSERT_TRUE(far) << far.error().message;
  EXPECT_THAT(far->warnings, ::testing::ElementsAre(HasSubstr("drawn about 1000000,")));
  const auto near = loaded("50", "1");
  ASSERT_TRUE(near) << near.error().message;
  EXPECT_THAT(near->warnings, ::testing::IsEmpty());
  const auto tiny = loaded("0", "1e-18");
  ASSERT_FALSE(tiny);
  EXPECT_THAT(tiny.error().message, HasSubstr("scale the model up"));
  EXPECT_TRUE(loaded("0", "1e-12"));
}

TEST(LoadModel, SaysWhereAClosedSurfaceShowsItsInside) {
  const std::string path = ::testing::TempDir() + "mirrorball_inwards.obj";
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const auto warnings = [&](const std::string& faces) {
    const std::string text = corners + faces;
    EXPECT_TRUE(writeFile(path, Bytes(text.begin(), text.end())));
    const Result<Scene> scene = loadModel(path);
    EXPECT_TRUE(scene);
    return scene->warnings;
  };
  EXPECT_THAT(warnings("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"), ::testing::IsEmpty());
  EXPECT_THAT(warnings("f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"), ::testing::ElementsAre(HasSubstr("face its inside")));
}

TEST(LoadModel, LoadsRealFiles) {
  struct Expected {
    const char* file;
    std::size_t meshes;
    std::size_t textures;
  };
  for (const Expected& expected :
       {Expected{"Duck.glb", 1, 1}, Expected{"lucy.glb", 1, 0}, Expected{"FlightHelmet/FlightHelmet.gltf", 5, 10}}) {
    const auto path = testing::sharedData(expected.file);
    if (!path) GTEST_SKIP() << expected.file << " is not in the shared data folder";
    const Result<Scene> scene = loadModel(path->string());
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->meshes.size(), expected.meshes) << expected.file;
    EXPECT_EQ(scene->textures.size(), expected.textures) << expected.file;
    expectSafe(*scene);
    EXPECT_GT(boundingSphere(*scene).radius, 0.0f);
  }
}

TEST(LoadModel, ComputesTheTangentsThatARealFileHas) {
  const auto path = testing::sharedData("FlightHelmet/FlightHelmet.gltf");
  if (!path) GTEST_SKIP() << "FlightHelmet is not in the shared data folder";
  const Result<Scene> scene = loadModel(path->string());
  ASSERT_TRUE(scene) << scene.error().message;
  std::size_t count = 0;
  std::size_t agreeing = 0;
  for (const Mesh& mesh : scene->meshes) {
    Mesh computed = mesh;
    computeTangents(computed);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const glm::vec4 theirs = mesh.vertices[mesh.indices[i]].tangent;
      const glm::vec4 ours = computed.vertices[computed.indices[i]].tangent;
      ++count;
      agreeing += theirs.w == ours.w && glm::dot(glm::vec3(theirs), glm::vec3(ours)) > 0.9f;
    }
  }
  // The file's come from another program, which weighs triangles in another way.
  EXPECT_GT(static_cast<double>(agreeing), 0.99 * static_cast<double>(count));
}

}  // namespace
}  // namespace mirrorball
