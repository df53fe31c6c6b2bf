#include "mirrorball/scene/model_files.h"

#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/mesh_file/obj.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A folder with a model's folder in it.
class ModelFilesTest : public ::testing::Test {
 protected:
  ModelFilesTest() {
    fs::create_directories(folder_ / "textures");
    write("inside.bin", triangle());
    write("textures/inside.bin", triangle());
    write("../outside.bin", triangle());
    fs::create_symlink("../outside.bin", folder_ / "link.bin");
    fs::create_directory_symlink("..", folder_ / "up");
  }
  ~ModelFilesTest() override { fs::remove_all(above_); }

  static Bytes triangle() {
    constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const auto bytes = bytesOf(std::span<const float>(kPositions));
    return {bytes.begin(), bytes.end()};
  }

  void write(const std::string& name, const Bytes& bytes) const { ASSERT_TRUE(writeFile(folder_ / name, bytes)); }
  void write(const std::string& name, const std::string& text) const { write(name, Bytes(text.begin(), text.end())); }

  /// A triangle whose positions are in the file of a uri.
  Result<Scene> gltf(const std::string& uri, const ModelLoadOptions& options = {}) const {
    write("model.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
                        R"({"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":)"
                        R"("VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
                            uri + "\"}]}");
    return loadModel((folder_ / "model.gltf").string(), options);
  }
  std::string refusal(const std::string& uri, const ModelLoadOptions& options = {}) const {
    const auto scene = gltf(uri, options);
    return scene ? "is read" : scene.error().message;
  }

  /// A triangle of the material that the table of a name has.
  Result<Scene> obj(const std::string& table, const ModelLoadOptions& options = {}) const {
    write("model.obj", "mtllib " + table + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    return loadModel((folder_ / "model.obj").string(), options);
  }

  const fs::path above_ = fs::path(::testing::TempDir()) / ("model_files_" + std::to_string(::getpid()));
  const fs::path folder_ = above_ / "model";
};

const ModelLoadOptions kInsideOnly{.inside_only = true};

TEST_F(ModelFilesTest, WhatLiesInsideIsReadWithoutARemark) {
  for (const char* uri : {"inside.bin", "./inside.bin", "%69nside.bin", "textures/inside.bin", "textures/../inside.bin",
                          "../model/inside.bin", "up/model/inside.bin"})
    for (const ModelLoadOptions& options : {ModelLoadOptions(), kInsideOnly}) {
      const auto scene = gltf(uri, options);
      ASSERT_TRUE(scene) << uri << ": " << scene.error().message;
      EXPECT_THAT(scene->warnings, IsEmpty()) << uri;
    }
}

TEST_F(ModelFilesTest, WhatLiesOutsideIsReadWithARemarkOrRefused) {
  for (const char* uri :
       {"../outside.bin", "textures/../../outside.bin", "%2e%2e/outside.bin", "link.bin", "up/outside.bin"}) {
    const auto scene = gltf(uri);
    ASSERT_TRUE(scene) << uri << ": " << scene.error().message;
    EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("outside of its folder: " + (above_ / "outside.bin").string())));
    EXPECT_THAT(refusal(uri, kInsideOnly), HasSubstr("lies outside of the model's folder")) << uri;
  }
  EXPECT_THAT(refusal("../none.bin"), HasSubstr("is missing"));
  EXPECT_THAT(refusal("../none.bin", kInsideOnly), HasSubstr("lies outside")) << "not whether it is there";
}

TEST_F(ModelFilesTest, WhatIsNoPathFromTheFolderIsRefused) {
  const std::string absolute = (above_ / "outside.bin").string();
  for (const std::string& uri : {absolute, "%2F" + absolute.substr(1), "file://" + absolute, "FILE:" + absolute,
                                 std::string("C:/a.bin"), std::string("%5C%5Cserver%5Ca.bin")})
    EXPECT_THAT(refusal(uri), HasSubstr("is no path from the model's folder")) << uri;
  EXPECT_THAT(refusal("inside.bin%00.png"), HasSubstr("has a NUL in it"));
  EXPECT_THAT(refusal("ssh://host/a"), HasSubstr("lies in a network"));
  EXPECT_THAT(refusal(""), HasSubstr("names no file"));
}

// It is who the model is from whose disk has such a file; here it lies beside the model.
TEST_F(ModelFilesTest, OfAPathOfAnotherMachineTheFileBesideTheModelIsRead) {
  for (const char* uri : {"/home/others/inside.bin", "file:///C:/Users/me/INSIDE.bin", "D:\\\\work\\\\inside.bin",
                          "https://example.org/inside.bin", "lost/inside.bin"})
    for (const ModelLoadOptions& options : {ModelLoadOptions(), kInsideOnly}) {
      const auto scene = gltf(uri, options);
      ASSERT_TRUE(scene) << uri << ": " << scene.error().message;
      EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("is read from 'inside.bin' in the model's folder"))) << uri;
    }
}

TEST_F(ModelFilesTest, WhatIsNoRegularFileIsRefused) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder_ / "device");
  for (const char* uri : {"pipe", "device", "textures"})
    EXPECT_THAT(refusal(uri), HasSubstr("is no regular file")) << uri;
}

TEST_F(ModelFilesTest, TablesOfMaterialsAndTheirPicturesTooAreNotRead) {
  write("inside.mtl", std::string("newmtl red\nmap_Kd /dev/zero\nmap_Ke ..\\outside.bin\n"));
  write("../outside.mtl", std::string("newmtl red\nKd 1 0 0\n"));
  const auto outside = obj("../outside.mtl");
  ASSERT_TRUE(outside);
  EXPECT_EQ(outside->materials.at(0).base_color, glm::vec3(1, 0, 0));
  EXPECT_THAT(outside->warnings, ElementsAre(HasSubstr("outside of its folder")));
  for (const auto& [table, options] : {std::pair{"../outside.mtl", kInsideOnly}, {"/dev/zero", {}}}) {
    const auto refused = obj(table, options);
    ASSERT_TRUE(refused);
    EXPECT_THAT(refused->files, IsEmpty());
    EXPECT_THAT(refused->warnings, ::testing::Contains(HasSubstr("its materials are left out")));
  }
  const auto pictures = obj("inside.mtl", kInsideOnly);
  ASSERT_TRUE(pictures);
  EXPECT_THAT(pictures->warnings,
              ElementsAre(HasSubstr("'/dev/zero' is no path"), HasSubstr("'..\\outside.bin' lies outside")));
}

// What a file's name says goes no further than the line that tells of it.
TEST_F(ModelFilesTest, NamesAreQuoted) {
  EXPECT_THAT(refusal("%1B[2J\\n" + std::string(5000, 'x')), HasSubstr("'?[2J?x"));
  EXPECT_LT(refusal(std::string(5000, 'x')).size(), 400u);
}

TEST_F(ModelFilesTest, AFileIsReadOnceWhateverItsName) {
  ModelFiles named(folder_ / "model.gltf", {});
  const auto first = named.read(named.find("inside.bin").value());
  ASSERT_TRUE(first);
  write("inside.bin", Bytes(36, 1));
  for (const char* name : {"./inside.bin", "textures/../inside.bin", "up/model/inside.bin"})
    EXPECT_EQ(named.read(named.find(name).value())->data(), first->data()) << name;
  EXPECT_THAT(named.files(), SizeIs(1));
}

}  // namespace
}  // namespace mirrorball
