#include "mirrorball/environment/file/face_files.h"

#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FaceFilesTest : public testing::FolderTest {
 protected:
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

TEST_F(FaceFilesTest, NamesOfEnginesAreKnown) {
  EXPECT_EQ(facesBeside("cube_neg_y.png"),
            "cube_pos_x.png cube_neg_x.png cube_pos_y.png cube_neg_y.png cube_pos_z.png cube_neg_z.png");
  EXPECT_EQ(facesBeside("sky_xneg.jpg"),
            "sky_xpos.jpg sky_xneg.jpg sky_ypos.jpg sky_yneg.jpg sky_zpos.jpg sky_zneg.jpg");
  EXPECT_EQ(facesBeside("skybox_y_neg.png"),
            "skybox_x_pos.png skybox_x_neg.png skybox_y_pos.png skybox_y_neg.png skybox_z_pos.png skybox_z_neg.png");
  EXPECT_EQ(facesBeside("sky_negative_z.png"),
            "sky_positive_x.png sky_negative_x.png sky_positive_y.png sky_negative_y.png sky_positive_z.png "
            "sky_negative_z.png");
  EXPECT_EQ(facesBeside("positive-x.jpg"),
            "positive-x.jpg negative-x.jpg positive-y.jpg negative-y.jpg positive-z.jpg negative-z.jpg");
  EXPECT_EQ(facesBeside("PositiveY.png"),
            "PositiveX.png NegativeX.png PositiveY.png NegativeY.png PositiveZ.png NegativeZ.png");
  EXPECT_EQ(facesBeside("X+.png"), "X+.png X-.png Y+.png Y-.png Z+.png Z-.png");
  touch({"sky-x+.png", "sky-x-.png", "sky-y+.png", "sky-y-.png", "sky-z+.png", "sky-z-.png"});
  EXPECT_EQ(facesBeside("sky-y-.png"), "sky-x+.png sky-x-.png sky-y+.png sky-y-.png sky-z+.png sky-z-.png");
  touch({"v_forward.png", "v_backward.png", "v_left.png", "v_right.png", "v_up.png", "v_down.png"});
  EXPECT_EQ(facesBeside("v_left.png"), "v_right.png v_left.png v_up.png v_down.png v_forward.png v_backward.png");
  EXPECT_EQ(facesBeside("w_backward.png"), "w_right.png w_left.png w_up.png w_down.png w_forward.png w_backward.png");
  touch({"u_forward.png", "u_backward.png", "u_left.png", "u_right.png", "u_top.png", "u_bottom.png"});
  EXPECT_EQ(facesBeside("u_right.png"), "u_right.png u_left.png u_top.png u_bottom.png u_forward.png u_backward.png");
  EXPECT_EQ(facesBeside("env_ft.tga"), "env_rt.tga env_lf.tga env_up.tga env_dn.tga env_ft.tga env_bk.tga");
  EXPECT_EQ(facesBeside("sky.fr.png"), "sky.rt.png sky.lf.png sky.up.png sky.dn.png sky.fr.png sky.bk.png");
  EXPECT_EQ(facesBeside("cube_m00_c05.jpg"),
            "cube_m00_c00.jpg cube_m00_c01.jpg cube_m00_c02.jpg cube_m00_c03.jpg cube_m00_c04.jpg cube_m00_c05.jpg");
  EXPECT_EQ(facesBeside("a_face0.png"), "a_face0.png a_face1.png a_face2.png a_face3.png a_face4.png a_face5.png");
  EXPECT_EQ(usualReading(faceFilesBeside("a_px.png")->naming), "faces");
  EXPECT_EQ(usualReading(faceFilesBeside("a_positive_x.png")->naming), "faces");
  EXPECT_EQ(usualReading(faceFilesBeside("a_ft.png")->naming), "faces:for=quake");
  EXPECT_EQ(usualReading(faceFilesBeside("a_fr.png")->naming), "faces:for=ogre");
  EXPECT_EQ(usualReading(faceFilesBeside("a_forward.png")->naming), "faces:for=krpano");
}

TEST_F(FaceFilesTest, UnitysFacesHaveTheirDirectionAndCameraInTheirNames) {
  const std::vector<std::string> faces{"Cold_Cam_3_Right-X.png", "Cold_Cam_2_Left+X.png",  "Cold_Cam_4_Up+Y.png",
                                       "Cold_Cam_5_Down-Y.png",  "Cold_Cam_0_Front+Z.png", "Cold_Cam_1_Back-Z.png"};
  touch(faces);
  for (const std::string& face : faces) EXPECT_EQ(facesBeside(face), join(faces, " "));
  EXPECT_EQ(usualReading(faceFilesBeside(folder_ / faces[0])->naming), "faces:as-seen");
}

TEST_F(FaceFilesTest, QuakesEndingsNeedNoSeparatorWhereTheOthersAre) {
  EXPECT_EQ(facesBeside("dustrt.tga"), "");
  touch({"dustrt.tga", "dustlf.tga", "dustup.tga", "dustdn.tga", "dustft.tga", "DUSTBK.TGA"});
  EXPECT_EQ(facesBeside("dustup.tga"), "dustrt.tga dustlf.tga dustup.tga dustdn.tga dustft.tga DUSTBK.TGA");
}

TEST_F(FaceFilesTest, LettersAndNumbersAreFacesWhereAllSixAre) {
  touch({"p_f.jpg", "p_r.jpg", "p_b.jpg", "p_l.jpg", "p_u.jpg"});
  EXPECT_EQ(facesBeside("p_f.jpg"), "");
  touch({"p_d.jpg"});
  EXPECT_EQ(facesBeside("p_f.jpg"), "p_r.jpg p_l.jpg p_u.jpg p_d.jpg p_f.jpg p_b.jpg");
  touch({"P-R.JPG", "P-L.JPG", "P-U.JPG", "P-D.JPG", "P-F.JPG", "P-B.JPG"});
  EXPECT_EQ(facesBeside("P-U.JPG"), "P-R.JPG P-L.JPG P-U.JPG P-D.JPG P-F.JPG P-B.JPG");
  touch({"c_1.png", "c_2.png", "c_3.png", "c_4.png", "c_5.png"});
  EXPECT_EQ(facesBeside("c_1.png"), "");
  touch({"c_6.png"});
  EXPECT_EQ(facesBeside("c_1.png"), "c_1.png c_2.png c_3.png c_4.png c_5.png c_6.png");
  EXPECT_TRUE(isCommon(faceFilesBeside(folder_ / "c_1.png")->naming));
  touch({"c_0.png"});
  EXPECT_EQ(facesBeside("c_0.png"), "c_0.png c_1.png c_2.png c_3.png c_4.png c_5.png");
  EXPECT_EQ(facesBeside("c_6.png"), "c_1.png c_2.png c_3.png c_4.png c_5.png c_6.png");
  touch({"cube0000.tif", "cube0001.tif", "cube0002.tif", "cube0003.tif", "cube0004.tif", "cube0005.tif"});
  EXPECT_EQ(facesBeside("cube0003.tif"),
            "cube0000.tif cube0001.tif cube0002.tif cube0003.tif cube0004.tif cube0005.tif");
}

TEST_F(FaceFilesTest, SixNumberedPicturesBesideACubeAreNoSecondOne) {
  touch({"px.jpg", "nx.jpg", "py.jpg", "ny.jpg", "pz.jpg", "nz.jpg"});
  touch({"v_1.jpg", "v_2.jpg", "v_3.jpg", "v_4.jpg", "v_5.jpg", "v_6.jpg"});
  const auto files = faceFilesIn(folder_);
  ASSERT_TRUE(files) << files.error().message;
  EXPECT_EQ(files->paths[5], folder_ / "nz.jpg");
}

TEST_F(FaceFilesTest, ThoseThatExistAndThoseThatDoNotAreNamed) {
  touch({"a_px.jpg", "a_nx.jpg", "a_py.jpg", "a_pz.jpg"});
  const FaceFiles files = *faceFilesBeside(folder_ / "a_py.jpg");
  EXPECT_EQ(listFaces(files, true, folder_ / "a_py.jpg"), "a_px.jpg, a_nx.jpg and a_pz.jpg");
  EXPECT_EQ(listFaces(files, false), "a_ny.jpg and a_nz.jpg");
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
  fs::remove(folder_ / "negy.jpg");
  ASSERT_TRUE(faceFilesIn(folder_));
  EXPECT_TRUE(lacksBottomAlone(*faceFilesIn(folder_)));
  touch({"negy.jpg"});
  const auto files = faceFilesIn(folder_);
  ASSERT_TRUE(files) << files.error().message;
  EXPECT_EQ(files->paths[5], folder_ / "negz.jpg");
  touch({"px.jpg", "nx.jpg", "py.jpg", "ny.jpg", "pz.jpg", "nz.jpg"});
  EXPECT_THAT(faceFilesIn(folder_).error().message, HasSubstr("holds 2 cubes"));
}

}  // namespace
}  // namespace mirrorball
