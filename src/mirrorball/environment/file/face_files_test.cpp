#include "mirrorball/environment/file/face_files.h"

#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FaceFilesTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void touch(const std::vector<std::string>& names) const {
    for (const std::string& name : names) std::ofstream(folder_ / name) << "x";
  }

  /// The names of the six that one of them stands for, in the order of the faces; "" when it stands for itself.
  std::string facesBeside(const std::string& name) const {
    const auto files = faceFilesBeside(folder_ / name);
    std::string names;
    if (files)
      for (const fs::path& path : files->paths) names += (names.empty() ? "" : " ") + path.filename().string();
    return names;
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("mirrorball_face_files_test_" + std::to_string(::getpid()));
};

TEST_F(FaceFilesTest, EveryNamingIsKnown) {
  EXPECT_EQ(facesBeside("room_ny.hdr"), "room_px.hdr room_nx.hdr room_py.hdr room_ny.hdr room_pz.hdr room_nz.hdr");
  EXPECT_EQ(facesBeside("a-posz.jpg"), "a-posx.jpg a-negx.jpg a-posy.jpg a-negy.jpg a-posz.jpg a-negz.jpg");
  EXPECT_EQ(facesBeside("bottom.png"), "right.png left.png top.png bottom.png front.png back.png");
  EXPECT_EQ(facesBeside("sky.down.png"),
            "sky.right.png sky.left.png sky.up.png sky.down.png sky.front.png sky.back.png");
  EXPECT_EQ(facesBeside("room-Y.exr"), "room+X.exr room-X.exr room+Y.exr room-Y.exr room+Z.exr room-Z.exr");
  EXPECT_EQ(textOf(faceFilesBeside("nz.hdr")->naming), "px nx py ny pz nz");
}

TEST_F(FaceFilesTest, ANameThatOnlyEndsInTheseLettersIsNoFace) {
  for (const char* name : {"bright.hdr", "startup.hdr", "room.hdr", "onyx.hdr", "px_room.hdr", ".hdr"})
    EXPECT_EQ(facesBeside(name), "") << name;
}

TEST_F(FaceFilesTest, TheFilesThatExistDecideBetweenTwoNamings) {
  touch({"right.png", "left.png", "up.png", "down.png", "front.png", "back.png"});
  EXPECT_EQ(facesBeside("left.png"), "right.png left.png up.png down.png front.png back.png");
  EXPECT_EQ(faceFilesBeside(folder_ / "left.png")->present, 6);
}

TEST_F(FaceFilesTest, CapitalsAreTheSame) {
  touch({"Room_PX.HDR", "Room_NX.hdr", "Room_py.hdr", "Room_Ny.hdr", "Room_pz.hdr", "Room_nz.hdr"});
  EXPECT_EQ(facesBeside("Room_py.hdr"), "Room_PX.HDR Room_NX.hdr Room_py.hdr Room_Ny.hdr Room_pz.hdr Room_nz.hdr");
}

TEST_F(FaceFilesTest, AFolderMayStandForItsSixFiles) {
  touch({"posx.jpg", "negx.jpg", "posy.jpg"});
  EXPECT_THAT(faceFilesIn(folder_).error().message, HasSubstr("is a folder without the six files of a cube"));
  touch({"negy.jpg"});
  EXPECT_THAT(faceFilesIn(folder_).error().message,
              HasSubstr("holds 4 of the six files of a cube, without posz.jpg and negz.jpg"));
  touch({"posz.jpg"});
  EXPECT_THAT(faceFilesIn(folder_).error().message, HasSubstr("holds 5 of the six files of a cube, without negz.jpg"));
  touch({"negz.jpg", "readme.txt"});
  const auto files = faceFilesIn(folder_);
  ASSERT_TRUE(files) << files.error().message;
  EXPECT_EQ(files->paths[5], folder_ / "negz.jpg");
  touch({"px.jpg", "nx.jpg", "py.jpg", "ny.jpg", "pz.jpg", "nz.jpg"});
  EXPECT_THAT(faceFilesIn(folder_).error().message, HasSubstr("holds 2 cubes"));
}

}  // namespace
}  // namespace mirrorball
