#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/scene/mesh_file/obj.h"

namespace mirrorball {
namespace {

TEST(ObjTiff, PicturesMayBeTiff) {
  const auto write = [](const char* name, const Bytes& bytes) {
    ASSERT_TRUE(writeFile(std::filesystem::path(::testing::TempDir()) / name, bytes));
  };
  const auto toBytes = [](std::string_view text) { return Bytes(text.begin(), text.end()); };
  write("colour.tif", testing::tiffFile({.width = 1, .height = 1}, {1, 2, 3}));
  write("obj_tiff.mtl", toBytes("newmtl painted\nmap_Kd colour.tif\n"));
  const Result<Scene> scene =
      decodeObj(toBytes("mtllib obj_tiff.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl painted\nf 1 2 3\n"),
                ::testing::TempDir() + "model.obj");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(scene->warnings, ::testing::IsEmpty());
  EXPECT_THAT(scene->textures.at(0).image.samples(), ::testing::ElementsAre(1, 2, 3, 255));
}

}  // namespace
}  // namespace mirrorball
