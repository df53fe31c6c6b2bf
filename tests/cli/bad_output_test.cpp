// Outputs that cannot be written, and a machine that cannot draw: one clear line, nothing left behind.

#include <string>
#include <vector>

#include <unistd.h>

#include "cli/cli_testing.h"
#include "mirrorball/gl/context.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class BadOutputTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("map.exr", smoothPanorama());
  }

  /// Both commands refuse to write there.
  void refuseOutput(int exit_code, const std::string& output, const std::string& what) const {
    for (const std::string command :
         {"convert map.exr --to sphere --size 8 -o ", "render none -e map.exr --size 8x8 -o "})
      EXPECT_THAT(refuse(exit_code, command + output), AllOf(StartsWith(output + ": "), HasSubstr(what))) << command;
  }
};

TEST_F(BadOutputTest, AFolderThatIsNotThere) {
  refuseOutput(1, "none/out.exr", "there is no folder none; make it");
  refuseOutput(1, "map.exr/out.exr", "map.exr is no folder");
  for (const std::string line : {"capture none -e map.exr --at 0,0,0 -o none/out.exr", "photo map.exr -o none/out.exr",
                                 "photo map.exr -o out.exr --debug none/out.png", "bake map.exr -o none/out.ktx2",
                                 "render none -e map.exr --frames 2 -o none/out.png"})
    EXPECT_THAT(refuse(1, line), HasSubstr("there is no folder none; make it")) << line;
}

TEST_F(BadOutputTest, AFolderInTheFilesPlace) {
  fs::create_directory(path("folder.exr"));
  for (const std::string command : {"render none -e map.exr", "capture none -e map.exr --at 0,0,0", "photo map.exr"})
    for (const std::string output : {"folder.exr", "folder.exr/", "none/"})
      EXPECT_THAT(refuse(2, command + " -o " + output), StartsWith(output + ": is a folder; name a file in it"));
  // A folder that is there is where convert puts its files, whatever it is called.
  succeed("convert map.exr --to sphere --size 8 -o folder.exr");
  EXPECT_EQ(image("folder.exr/map.exr").width(), 8);
}

TEST_F(BadOutputTest, AFileInAFoldersPlace) {
  EXPECT_EQ(refuse(1, "convert map.exr -o map.exr/"),
            "map.exr/: cannot be made a folder, since map.exr is a file; name another folder, or a file, without / "
            "behind it");
  EXPECT_THAT(refuse(1, "convert map.exr -o map.exr/deep/"), HasSubstr("since map.exr is a file; "));
  fs::create_symlink("nowhere", path("link"));
  EXPECT_THAT(refuse(1, "convert map.exr -o link/"), HasSubstr("since link is a link that leads to nothing; "));
  EXPECT_THAT(refuse(1, "bake map.exr --size 16 --brdf-size 4 -o link"), HasSubstr("leads to nothing; "));
  EXPECT_TRUE(fs::is_symlink(path("link"))) << "it is not ours to remove";
}

TEST_F(BadOutputTest, ALinkToAFolderThatIsNotThere) {
  fs::create_symlink("none/far.exr", path("link.exr"));
  refuseOutput(1, "link.exr", "is a link to none/far.exr, and there is no folder none; make it");
}

TEST_F(BadOutputTest, AChainIsNoPictureWhateverElseIsAsked) {
  for (const std::string options : {"", " --brdf-size 64"}) {
    EXPECT_THAT(refuse(2, "bake map.exr -o out.png" + options), StartsWith("out.png: a prefiltered chain goes into "));
    EXPECT_THAT(refuse(2, "bake map.exr -o map.exr" + options), StartsWith("map.exr: is the input itself"));
  }
  EXPECT_THAT(refuse(2, "bake map.exr -o out.ktx2 --brdf-size 64"), HasSubstr("--brdf-size is for what lies beside"));
}

TEST_F(BadOutputTest, AFolderThatNobodyMayWriteTo) { refuseOutput(1, "/proc/out.exr", "cannot be written"); }

TEST_F(BadOutputTest, AFolderThatIsReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write to any folder";
  fs::create_directory(path("locked"));
  fs::permissions(path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
  refuseOutput(1, "locked/out.exr", "cannot be written");
}

TEST_F(BadOutputTest, AFullDisk) {
  succeed("convert map.exr --to sphere --size 32 -o ball.exr");
  const Start full{.largest_file = 1000};
  for (const std::string command :
       {"convert map.exr --to sphere --size 32 -o ", "render torus -e map.exr --size 64x64 -o "})
    for (const std::string output : {"out.exr", "ball.exr"})
      EXPECT_THAT(refuse(1, command + output, full), StartsWith(output + ": cannot be written")) << command;
}

TEST_F(BadOutputTest, AnExtensionThatNamesNoFormat) {
  for (const std::string output : {"out.tga", "out.tif", "out.gif", "out", "out.", ".png", "exr"}) {
    refuseOutput(2, output, "; use .hdr or .exr for linear light, ");
    refuseOutput(2, output, ".png or .jpg for pictures");
  }
  for (const std::string output : {"out.tga", "out.tif", "out.gif"})
    refuseOutput(2, output, "is not a format that Mirrorball writes");
  EXPECT_THAT(refuse(2, "convert map.exr --to sphere -o out.tif"), HasSubstr(".ktx2, .ktx or .dds for textures"));
  EXPECT_THAT(refuse(2, "render none -e map.exr -o out.dds"), HasSubstr("would hold textures; use .hdr or .exr"));
}

TEST_F(BadOutputTest, NoNameAtAll) {
  using Words = std::vector<std::string>;
  EXPECT_THAT(refuse(2, Words{"convert", "map.exr", "--to", "cube", "-o", ""}), HasSubstr("-o"));
  EXPECT_THAT(refuse(2, Words{"render", "none", "-e", "map.exr", "-o", ""}), HasSubstr("-o"));
}

TEST_F(BadOutputTest, JpegAndHdrHaveNoAlpha) {
  for (const std::string output : {"out.jpg", "out.hdr"})
    EXPECT_THAT(refuse(2, "render sphere -e map.exr --size 8x8 --background transparent -o " + output),
                AllOf(StartsWith(output + ": "), HasSubstr("write .png or .exr")));
}

// --tone-map neutral and --resolve display are the defaults: what counts is that they were given.
TEST_F(BadOutputTest, WhatHoldsRadianceHasNoDisplay) {
  for (const std::string output : {"out.exr", "out.hdr"}) {
    for (const std::string option : {"--exposure 1", "--exposure 0", "--tone-map neutral", "--tone-map aces",
                                     "--dither none", "--resolve display"})
      EXPECT_THAT(refuse(2, "render sphere -e map.exr --size 8x8 -o " + output + " " + option),
                  AllOf(StartsWith(output + ": holds light as it is; for " + option.substr(0, option.find(' '))),
                        HasSubstr("write .png or .jpg")));
    succeed("render sphere -e map.exr --size 8x8 --resolve radiance -o " + output);
  }
  EXPECT_THAT(refuse(2, "capture sphere -e map.exr --at 0,0,2 --exposure 1 -o out.exr"),
              AllOf(StartsWith("out.exr: holds light as it is; for --exposure write"), HasSubstr("--scale-light 2")));
}

TEST_F(BadOutputTest, TheInputIsNotOverwritten) {
  fs::create_symlink("map.exr", path("link.exr"));
  for (const std::string output : {"map.exr", "./map.exr", "link.exr"}) refuseOutput(2, output, "is the input itself");
  write("model.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  fs::create_symlink("model.obj", path("model.png"));
  EXPECT_THAT(refuse(2, "render model.obj -e map.exr --size 8x8 -o model.png"), HasSubstr("is the input itself"));
}

// The names that are written are not always the one that was given.
TEST_F(BadOutputTest, NoneOfSixFacesIsOverwritten) {
  succeed("convert map.exr --to cube --layout faces --size 8 -o room.exr");
  EXPECT_THAT(refuse(2, "convert room_px.exr --to cube --layout faces --size 4 -o room.exr"), HasSubstr("input"));
  EXPECT_THAT(refuse(2, "convert room_px.exr --to sphere --size 8 -o room_nz.exr"), HasSubstr("input"));
  EXPECT_THAT(refuse(2, "render none -e room_px.exr --size 8x8 -o room_ny.exr"), HasSubstr("input"));
}

TEST_F(BadOutputTest, NoPictureOfATurntableOverwritesItsEnvironment) {
  fs::rename(path("map.exr"), path("turn_001.exr"));
  EXPECT_THAT(refuse(2, "render none -e turn_001.exr --frames 2 --size 8x8 -o turn.exr"), HasSubstr("input"));
}

TEST_F(BadOutputTest, NoFileOfAModelIsOverwritten) {
  write("model.obj", std::string("mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"));
  write("model.mtl", std::string("newmtl a\nmap_Kd color.png\n"));
  write("color.png", Image(4, 4, 3, 0.5f));
  succeed("render model.obj -e map.exr --size 8x8 -o out.png");
  EXPECT_THAT(refuse(2, "render model.obj -e map.exr --size 8x8 -o color.png"), HasSubstr("input"));
}

// A vendor list without a vendor is a machine without a driver.
TEST_F(BadOutputTest, NoDriver) {
  const Start bare{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}}};
  EXPECT_THAT(refuse(1, "render sphere -e map.exr --size 8x8 -o out.png", bare),
              AllOf(StartsWith("no driver for OpenGL 4.3 found"), HasSubstr("install libegl1")));
  // What needs no picture needs no driver.
  succeed("convert map.exr --to cube -o cube.exr", bare);
  succeed("info map.exr", bare);
}

TEST_F(BadOutputTest, ADriverThatIsTooOld) {
  const auto context = gl::Context::createHeadless();
  ASSERT_TRUE(context) << context.error().message;
  if (context->version().find("Mesa") == std::string::npos) GTEST_SKIP() << "only Mesa can pretend to be older";
  EXPECT_THAT(refuse(1, "render sphere -e map.exr --size 8x8 -o out.png",
                     {.environment = {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}}),
              AllOf(HasSubstr("offers only version 3.3"), HasSubstr("OpenGL 4.3 is needed")));
}

// What is wrong with the input is told even where there is no driver.
TEST_F(BadOutputTest, AWrongModelIsToldBeforeAMissingDriver) {
  EXPECT_THAT(refuse(1, "render missing.obj -e map.exr --size 8x8 -o out.png",
                     {.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}}}),
              StartsWith("missing.obj: "));
}

}  // namespace
}  // namespace mirrorball::testing
